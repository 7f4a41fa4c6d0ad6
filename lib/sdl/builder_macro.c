#include "sdl/builder.h"

#include <string.h>

const local *builder_find_local(const builder *b, const symbol *name)
{
    int i;

    for (i = b->locals - 1; i >= 0; i--)
        if (b->local[i].name == name)
            return &b->local[i];
    return NULL;
}

static void add_local(builder *b, const symbol *name, term t)
{
    local l = { name, t };

    l.term.is_part = false;
    if (t.kind == VALUE_NUMBER)
        memset(&l.term.reg[1], 0, sizeof l.term.reg - sizeof l.term.reg[0]);
    if (b->locals == BUILDER_LOCALS)
        builder_refuse(b);
    else
        b->local[b->locals++] = l;
}

/* To a parameter it could be the caller's name that changes. */
static bool is_free(const builder *b, const symbol *name)
{
    const value *v = scope_value(name);
    int i;

    for (i = b->s->locals; i < b->s->parameters; i++)
        if (b->local[i].name == name)
            return false;
    return name->id == KEYWORD_OTHER && (!v || (v->kind != VALUE_MACRO && v->kind != VALUE_FUNCTION));
}

/* `#local NAME = E;` */
void builder_local(builder *b)
{
    const token *t = builder_peek(b, 1), *name = builder_peek(b, 2);
    stream *s = b->s;
    term made;

    if (t->kind != TOKEN_WORD || t->symbol->id != KEYWORD_LOCAL || name->kind != TOKEN_WORD ||
        !is_free(b, name->symbol) || builder_peek(b, 3)->kind != '=') {
        builder_refuse(b);
        return;
    }
    s->at += 4;
    made = builder_additive(b);
    if (b->s != s || builder_peek(b, 0)->kind != ';') {
        builder_refuse(b);
        return;
    }
    s->at += builder_peek(b, 1)->kind == ';' ? 2 : 1;
    add_local(b, name->symbol, made);
}

static int read_arguments(builder *b, const macro *m, term *out)
{
    int i;

    builder_expect(b, '(');
    for (i = 0; i < m->count && !b->is_refused; i++) {
        out[i] = builder_additive(b);
        builder_accept(b, ',');
    }
    builder_expect(b, ')');
    return i;
}

term builder_insert(builder *b, symbol *name, macro *m)
{
    const calc_name n = { name, VALUE_MACRO, false, 0, m->number, m };
    term arguments[BUILDER_LOCALS];
    stream body;
    int i, count;

    builder_name(b, n);
    if (b->s + 1 == b->streams + BUILDER_STREAMS || m->count > BUILDER_LOCALS || !macro_lex(b->in, m))
        return builder_refuse(b);
    count = read_arguments(b, m, arguments);
    if (b->is_refused)
        return builder_refuse(b);
    body = (stream){ m->tokens->items, m->start, m->end, b->locals, b->locals + count };
    for (i = 0; i < count; i++)
        add_local(b, m->parameters[i], arguments[i]);
    *++b->s = body;
    return builder_operand(b);
}
