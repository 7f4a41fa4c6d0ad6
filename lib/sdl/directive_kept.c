#include "sdl/directive_kept.h"

#include "sdl/calc.h"
#include "sdl/condition.h"
#include "sdl/directive.h"
#include "sdl/expression.h"
#include "sdl/loop.h"

/* `#declare NAME = E;`, `#declare NAME[E]... = E;`, `#if (E)`, `#else`, `#end`. All others are read. */
typedef struct kept {
    replay head;
    symbol *name;
    bool is_local;
    keyword_id branch;           /* ELSE or END: what comes next where the condition does not hold; behind #else the END */
    size_t behind;               /* the token behind the word of that branch */
} kept;

/* ---- compiling ---- */

/* The word of the next branch of the same condition, or of its end. False: the buffer ends before. */
static bool find_branch(const token_buffer *b, size_t at, kept *q)
{
    size_t depth = 1;

    for (; at + 1 < b->count; at++) {
        const token *t = &b->items[at + 1];
        int nesting;

        if (b->items[at].kind != '#' || t->kind != TOKEN_WORD || t->symbol->directive < 0)
            continue;
        q->branch = t->symbol->id;
        q->behind = at + 2;
        nesting = directive_nesting(t);
        if (depth == 1 && condition_is_branch(q->branch))
            return true;
        depth = nesting < 0 ? depth - 1 : depth + (size_t)nesting;
        if (depth == 0)
            return true;
    }
    return false;
}

static bool is_set(const token *t, size_t count)
{
    return count > 4 && t[2].kind == TOKEN_WORD && t[2].symbol->id == KEYWORD_OTHER &&
           (t[3].kind == '=' || t[3].kind == '[');
}

static replay_kind understand(const token_buffer *b, size_t index, kept *q)
{
    const token *t = &b->items[index];
    const size_t count = b->count - index;

    if (count < 2 || t[1].kind != TOKEN_WORD)
        return REPLAY_NONE;
    switch (t[1].symbol->id) {
    case KEYWORD_DECLARE: case KEYWORD_LOCAL:
        q->is_local = t[1].symbol->id == KEYWORD_LOCAL;
        q->name = is_set(t, count) ? t[2].symbol : NULL;
        return q->name ? REPLAY_SET : REPLAY_NONE;
    case KEYWORD_IF:
        return count > 4 && t[2].kind == '(' && find_branch(b, index + 2, q) &&
               (q->branch == KEYWORD_ELSE || q->branch == KEYWORD_END) ? REPLAY_IF : REPLAY_NONE;
    case KEYWORD_ELSE:
        return find_branch(b, index + 2, q) && q->branch == KEYWORD_END ? REPLAY_ELSE : REPLAY_NONE;
    case KEYWORD_END:
        return REPLAY_END;
    default:
        return REPLAY_NONE;
    }
}

static const kept *compile(pov_reader *in, token_buffer *b, size_t index, replay **slot)
{
    static const kept none;
    kept q = none, *copy;
    const replay_kind kind = understand(b, index, &q);

    *slot = &b->none;
    if (kind == REPLAY_NONE)
        return NULL;
    copy = token_buffer_keep(&in->buffers, b, sizeof *copy);
    if (!copy)
        return NULL;
    q.head.next = copy->head.next;
    q.head.kind = kind;
    *copy = q;
    *slot = &copy->head;
    return copy;
}

static const kept *kept_at(pov_reader *in, token_buffer *b, size_t index)
{
    replay **slot = token_buffer_replay(&in->buffers, b, index);

    if (!slot || *slot == &b->none)
        return NULL;
    if (*slot == &b->met)
        return compile(in, b, index, slot);
    if (*slot)
        return (const kept *)*slot;
    *slot = &b->met;
    return NULL;
}

/* ---- running ---- */

static bool go_to(pov_reader *in, size_t at)
{
    in->top->at = at;
    directive_step(in);
    return true;
}

/* The program of an expression that ends at a token of that kind. */
static calc *program_at(pov_reader *in, size_t index, replay_kind grammar, int end)
{
    token_buffer *b = in->top->tokens;
    calc *c = calc_at(in, b, index, grammar);

    return c && c->end < in->top->end && b->items[c->end].kind == end ? c : NULL;
}

/* Behind one or two `;`. */
static size_t behind_value(const pov_reader *in, size_t at)
{
    return at + 1 < in->top->end && in->top->tokens->items[at + 1].kind == ';' ? at + 2 : at + 1;
}

/* A name of a number holds nothing else. */
static value result(const calc *c, const double r[CALC_REGISTERS])
{
    return c->kind == VALUE_NUMBER ? value_of_number(r[c->result[0]]) : calc_value(c, r);
}

static bool set_name(pov_reader *in, const kept *q, size_t at)
{
    const size_t level = in->scopes.count - 1;
    const binding *b = q->name->binding;
    double r[CALC_REGISTERS];
    calc *c;

    if (b && (b->slot->kind == VALUE_MACRO || b->slot->kind == VALUE_FUNCTION))
        return false;
    c = program_at(in, at, REPLAY_ADDITIVE, ';');
    if (!c || !calc_try(in, in->top->tokens, at, c, r))
        return false;
    at = behind_value(in, c->end);
    if (b && (!q->is_local || b->level == level) && value_is_arithmetic(b->slot))
        *b->slot = result(c, r);
    else if (q->is_local)
        scope_local(in, q->name, level, result(c, r));
    else
        scope_declare(in, q->name, result(c, r));
    return go_to(in, at);
}

/* The element that the subscripts from `at` on name; `at` is the token behind them. NULL: they are read. */
static value *element(pov_reader *in, array *a, size_t *at)
{
    double r[CALC_REGISTERS], number;
    size_t index = 0;
    int i;

    for (i = 0; i < a->dimensions; i++) {
        calc *c = in->top->tokens->items[*at].kind == '[' ? program_at(in, *at + 1, REPLAY_ADDITIVE, ']') : NULL;

        if (!c || c->kind != VALUE_NUMBER || c->is_random || !calc_try(in, in->top->tokens, *at + 1, c, r))
            return NULL;
        number = r[c->result[0]] + EXPRESSION_NEAR;
        if (!(number >= 0.0 && number < (double)a->sizes[i]))
            return NULL;
        index = index * a->sizes[i] + (size_t)number;
        *at = c->end + 1;
    }
    return &a->items[index];
}

/* #local changes a copy of another scope's array, but for a parameter. */
static bool is_own(const pov_reader *in, const kept *q)
{
    const binding *b = q->name->binding;

    return b && b->slot->kind == VALUE_ARRAY && (!q->is_local || b->level >= in->scopes.count - 1 || b->lender);
}

static bool set_element(pov_reader *in, const kept *q, size_t at)
{
    double r[CALC_REGISTERS];
    array *a;
    value *slot;
    calc *c;

    if (!is_own(in, q))
        return false;
    a = value_array(q->name->binding->slot);
    slot = element(in, a, &at);
    if (!slot || at + 1 >= in->top->end || in->top->tokens->items[at].kind != '=')
        return false;
    at++;
    c = program_at(in, at, REPLAY_ADDITIVE, ';');
    if (!c || c->kind != a->kind || c->size != a->size || !calc_try(in, in->top->tokens, at, c, r))
        return false;
    *slot = result(c, r);
    return go_to(in, behind_value(in, c->end));
}

static bool branch(pov_reader *in, const kept *q, size_t at)
{
    static const condition none;
    condition opened = none;
    double r[CALC_REGISTERS];
    bool holds;
    calc *c = q->behind <= in->top->end ? program_at(in, at, REPLAY_FULL, ')') : NULL;

    if (!c || c->kind != VALUE_NUMBER || !calc_try(in, in->top->tokens, at, c, r))
        return false;
    holds = expression_is_true(r[c->result[0]]);
    opened.kind = CONDITION_IF;
    opened.at = in->token.at;
    opened.has_else = !holds;
    if (!holds && q->branch == KEYWORD_END)
        return go_to(in, q->behind);
    if (condition_open(in, &opened))
        go_to(in, holds ? c->end + 1 : q->behind);
    return true;
}

static bool leave(pov_reader *in, const kept *q)
{
    const condition *c = condition_top(in);

    if (!c || c->kind != CONDITION_IF || c->has_else || q->behind > in->top->end)
        return false;
    in->conditions.count--;
    return go_to(in, q->behind);
}

static bool end(pov_reader *in, size_t index)
{
    const condition *c = condition_top(in);
    const place hash = in->token.at;

    if (!c || (c->kind != CONDITION_IF && c->kind != CONDITION_FOR))
        return false;
    if (c->kind == CONDITION_IF) {
        in->conditions.count--;
        return go_to(in, index + 2);
    }
    if (in->parentheses > c->parentheses)
        return false;
    in->top->at = index + 2;
    loop_turn(in, &hash);
    return true;
}

bool directive_kept_run(pov_reader *in)
{
    size_t index;
    const kept *q;

    if (!in->top->tokens || (in->version < 1.5 && in->version != 0.0) || !calc_index(in, &index))
        return false;
    q = kept_at(in, in->top->tokens, index);
    if (!q || index + 2 > in->top->end)
        return false;
    switch (q->head.kind) {
    case REPLAY_SET:
        if (in->top->tokens->items[index + 3].kind == '[')
            return set_element(in, q, index + 3);
        return set_name(in, q, index + 4);
    case REPLAY_IF:
        return branch(in, q, index + 3);
    case REPLAY_ELSE:
        return leave(in, q);
    case REPLAY_END:
        return end(in, index);
    default:
        return false;
    }
}
