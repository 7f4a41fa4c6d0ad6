#include "sdl/loop.h"

#include "sdl/condition.h"
#include "sdl/directive.h"
#include "sdl/expression.h"
#include "sdl/frame.h"
#include "sdl/limit.h"
#include "sdl/report.h"

/* Of a text that is being lexed the whole loop becomes tokens, which are read instead. */
static bool keep_tokens(pov_reader *in)
{
    token_buffer *b;

    if (!in->top->text)
        return !in->failed;
    b = frame_capture(in);
    if (!b)
        return false;
    frame_push_tokens(in, FRAME_LOOP, b, 0, b->count);
    token_buffer_release(&in->buffers, b);
    return !in->failed;
}

static bool open(pov_reader *in, condition_kind kind, const place *at)
{
    static const condition none;
    condition c = none;

    c.kind = kind;
    c.at = *at;
    c.frame = in->frames.count - 1;
    c.start = in->top->at;
    c.parentheses = in->parentheses;
    return condition_open(in, &c);
}

static condition *innermost(const pov_reader *in)
{
    return &in->conditions.items[in->conditions.count - 1];
}

static void leave(pov_reader *in)
{
    directive_skip_all(in, &innermost(in)->at, 1);
    in->conditions.count--;
    directive_step(in);
}

static void turn_or_leave(pov_reader *in, bool holds)
{
    if (in->failed)
        return;
    if (holds)
        directive_step(in);
    else
        leave(in);
}

void loop_while(pov_reader *in, const place *at)
{
    if (keep_tokens(in) && open(in, CONDITION_WHILE, at))
        turn_or_leave(in, condition_holds(in));
}

/* ---- #for ---- */

static bool is_within(const condition *c, double n)
{
    return c->step > 0.0 ? n <= c->last + EXPRESSION_NEAR : n >= c->last - EXPRESSION_NEAR;
}

static void read_range(pov_reader *in, condition *c, double *first)
{
    in->wants_name = true;
    state_advance(in);
    state_open(in, '(');
    in->wants_name = false;
    if (in->token.kind != TOKEN_WORD || in->token.symbol->id != KEYWORD_OTHER)
        report_expected(in, "the name of a variable");
    if (in->failed)
        return;
    c->variable = in->token.symbol;
    state_advance(in);
    state_accept(in, ',');
    *first = expression_number(in);
    state_accept(in, ',');
    c->last = expression_number(in);
    c->step = state_accept(in, ',') && in->token.kind != ')' ? expression_number(in) : 1.0;
    if (!in->failed && c->step == 0.0)
        report_fail(in, &in->value, POV_E_SYNTAX, "the step of a loop is not 0");
    if (state_require(in, ')'))
        in->nesting--;
}

void loop_for(pov_reader *in, const place *at)
{
    static const condition none;
    condition c = none;
    double first = 0.0;

    if (!keep_tokens(in))
        return;
    read_range(in, &c, &first);
    if (in->failed || !open(in, CONDITION_FOR, at))
        return;
    innermost(in)->variable = c.variable;
    innermost(in)->last = c.last;
    innermost(in)->step = c.step;
    scope_local(in, c.variable, in->scopes.count - 1, value_of_number(first));
    turn_or_leave(in, is_within(&c, first));
}

/* The body may have changed the variable. */
static bool count_on(pov_reader *in, const condition *c)
{
    const binding *b = c->variable->binding;
    const size_t level = in->scopes.count - 1;
    double n;

    if (!b || b->slot->kind != VALUE_NUMBER) {
        report_fail(in, &c->at, POV_E_SYNTAX, "\"%s\" is no number any more", c->variable->name);
        return false;
    }
    n = b->slot->as.v[0] + c->step;
    if (b->level == level)
        b->slot->as.v[0] = n;
    else
        scope_local(in, c->variable, level, value_of_number(n));
    return is_within(c, n);
}

/* ---- turns and ends ---- */

void loop_turn(pov_reader *in, const place *at)
{
    condition *c = innermost(in);
    bool is_for = c->kind == CONDITION_FOR, goes_on;

    if (in->parentheses > c->parentheses) {
        report_expected(in, "\")\"");   /* of its own condition */
        return;
    }
    if (c->frame != in->frames.count - 1) {
        report_fail(in, at, POV_E_SYNTAX, "this \"#end\" belongs to a loop that began in another text");
        return;
    }
    if (!limit_turn(in, &c->at))
        return;
    goes_on = is_for && count_on(in, c);
    if (is_for && (!goes_on || in->failed)) {
        if (!in->failed) {
            in->conditions.count--;
            directive_step(in);
        }
        return;
    }
    in->top->at = c->start;
    if (is_for)
        directive_step(in);
    else
        turn_or_leave(in, condition_holds(in));
}

/* A macro is left at its end. */
static void leave_macro(pov_reader *in)
{
    while (in->top->kind == FRAME_LOOP)
        frame_pop(in);
    in->conditions.count = in->top->conditions;
    in->top->at = in->top->end;
    directive_step(in);
}

static size_t innermost_macro(const pov_reader *in)
{
    size_t i = in->frames.count;

    while (i > 0 && in->frames.items[i - 1].kind != FRAME_MACRO)
        i--;
    return i;
}

void loop_break(pov_reader *in, const place *at)
{
    const size_t macro = innermost_macro(in), least = macro > 0 ? in->frames.items[macro - 1].conditions : 0;
    size_t i = in->conditions.count;

    while (i > least && in->conditions.items[i - 1].kind == CONDITION_IF)
        i--;
    if (i > least) {
        directive_skip_all(in, at, in->conditions.count - i + 1);
        in->conditions.count = i - 1;
        directive_step(in);
    } else if (macro > 0 && (in->top->kind == FRAME_MACRO || in->top->kind == FRAME_LOOP)) {
        leave_macro(in);
    } else {
        report_fail(in, at, POV_E_SYNTAX, "there is nothing that this \"#break\" could leave");
    }
}
