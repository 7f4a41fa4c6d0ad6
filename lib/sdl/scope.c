#include "sdl/scope.h"

#include "base/vec.h"
#include "sdl/report.h"

bool scope_push(pov_reader *in)
{
    static const scope empty;

    if (VEC_PUSH(in->model->env, &in->scopes, empty))
        return true;
    report_memory(in);
    return false;
}

/* Where the chain of a name's bindings, the innermost first, has that of the level or lacks it. */
static binding **place_of(symbol *name, size_t level)
{
    binding **at = &name->binding;

    while (*at && (*at)->level > level)
        at = &(*at)->outer;
    return at;
}

static void unlink_binding(pov_reader *in, binding *b)
{
    scope *s = &in->scopes.items[b->level];

    *place_of(b->symbol, b->level) = b->outer;
    if (b->previous)
        b->previous->next = b->next;
    else
        s->first = b->next;
    if (b->next)
        b->next->previous = b->previous;
    value_unshare(&in->heap, &b->head);
}

/* The innermost scope's bindings are the innermost of their names. */
void scope_pop(pov_reader *in)
{
    scope *s = &in->scopes.items[in->scopes.count - 1];

    while (s->first)
        unlink_binding(in, s->first);
    in->scopes.count--;
}

static binding *bind(pov_reader *in, symbol *name, size_t level)
{
    scope *s = &in->scopes.items[level];
    binding *b = value_share(&in->heap, VALUE_NOTHING, sizeof *b), **at = place_of(name, level);

    if (!b) {
        report_memory(in);
        return NULL;
    }
    b->symbol = name;
    b->slot = &b->own;
    b->level = level;
    b->outer = *at;
    b->next = s->first;
    if (b->next)
        b->next->previous = b;
    s->first = b;
    *at = b;
    return b;
}

static void assign(pov_reader *in, value *slot, value v)
{
    value old = *slot;

    *slot = v;
    value_drop(&in->heap, &old);
}

void scope_declare(pov_reader *in, symbol *name, value v)
{
    binding *b = name->binding;

    if (!in->failed && !b)
        b = bind(in, name, 0);
    if (in->failed)
        value_drop(&in->heap, &v);
    else
        assign(in, b->slot, v);
}

void scope_local(pov_reader *in, symbol *name, size_t level, value v)
{
    binding *b = *place_of(name, level);

    if (!in->failed && level < in->scopes.count && (!b || b->level < level))
        b = bind(in, name, level);
    if (in->failed || level >= in->scopes.count)
        value_drop(&in->heap, &v);
    else
        assign(in, b->slot, v);
}

void scope_lend(pov_reader *in, symbol *name, value *slot, shared *lender)
{
    const size_t level = in->scopes.count - 1;
    binding *b = name->binding;

    if (!b || b->level < level)
        b = bind(in, name, level);
    if (in->failed)
        return;
    lender->uses++;
    value_drop(&in->heap, &b->own);
    if (b->lender)
        value_unshare(&in->heap, b->lender);
    b->lender = lender;
    b->slot = slot;
}

void scope_forget(pov_reader *in, symbol *name)
{
    if (name->binding)
        unlink_binding(in, name->binding);
}
