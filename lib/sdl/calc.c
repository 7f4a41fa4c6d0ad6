#include "sdl/calc.h"

/* Names that lead elsewhere again and again are not worth a program. */
enum { MISSES_MAX = 3 };

bool calc_index(const pov_reader *in, size_t *index)
{
    const frame *f = in->top;

    if (!f->tokens || f->at == 0 || f->has_saved || f->tokens->items[f->at - 1].at.start != in->token.at.start)
        return false;
    *index = f->at - 1;
    return true;
}

bool calc_is_argument(const pov_reader *in)
{
    size_t index;
    int next;

    if (!calc_index(in, &index) || index + 1 >= in->top->end)
        return false;
    next = in->top->tokens->items[index + 1].kind;
    return next == ',' || next == ')';
}

static calc *renew(pov_reader *in, token_buffer *b, size_t index, replay_kind grammar, replay **slot, unsigned misses)
{
    calc *c = misses > MISSES_MAX ? NULL : calc_compile(in, b, index, grammar);

    *slot = c ? &c->head : &b->none;
    if (c)
        c->misses = misses;
    return c;
}

calc *calc_at(pov_reader *in, token_buffer *b, size_t index, replay_kind grammar)
{
    replay **slot = token_buffer_replay(&in->buffers, b, index);

    if (!slot)
        return NULL;
    if (!*slot)
        *slot = &b->met;
    else if (*slot == &b->met)
        return renew(in, b, index, grammar, slot, 0);
    else if ((*slot)->kind == grammar)
        return (calc *)*slot;
    return NULL;
}

bool calc_try(pov_reader *in, token_buffer *b, size_t index, calc *c, double r[CALC_REGISTERS])
{
    const unsigned misses = c->misses;

    if (calc_run(in, c, r))
        return true;
    if (c->misses > misses)
        renew(in, b, index, c->head.kind, token_buffer_replay(&in->buffers, b, index), c->misses);
    return false;
}

/* The token at `end` is the next one. */
static void go_to(pov_reader *in, frame *f, size_t end)
{
    const token *behind = &f->tokens->items[end];

    if (behind->kind >= TOKEN_NUMBER) {
        in->token = behind[-1];
        f->at = end;
        state_advance(in);
        return;
    }
    in->last = behind[-1].at;
    in->token = *behind;
    in->tried_count = 0;
    f->at = end + 1;
}

bool calc_read(pov_reader *in, replay_kind grammar, value *out)
{
    double r[CALC_REGISTERS];
    token_buffer *b = in->top->tokens;
    size_t index;
    calc *c;

    if (in->failed || (in->version < 1.5 && in->version != 0.0) || !calc_index(in, &index))
        return false;
    c = calc_at(in, b, index, grammar);
    if (!c || !calc_try(in, b, index, c, r))
        return false;
    *out = calc_value(c, r);
    go_to(in, in->top, c->end);
    return true;
}
