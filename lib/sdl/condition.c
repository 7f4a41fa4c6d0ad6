#include "sdl/condition.h"

#include "base/vec.h"
#include "sdl/array.h"
#include "sdl/directive.h"
#include "sdl/expression.h"
#include "sdl/frame.h"
#include "sdl/loop.h"
#include "sdl/report.h"

bool condition_is_branch(keyword_id keyword)
{
    return keyword == KEYWORD_ELSE || keyword == KEYWORD_ELSEIF || keyword == KEYWORD_CASE || keyword == KEYWORD_RANGE;
}

bool condition_holds(pov_reader *in)
{
    bool holds;

    state_advance(in);
    state_open(in, '(');
    holds = expression_condition(in);
    if (state_require(in, ')'))
        in->nesting--;
    return holds && !in->failed;
}

bool condition_open(pov_reader *in, const condition *c)
{
    if (!in->failed && !VEC_PUSH(in->model->env, &in->conditions, *c))
        report_memory(in);
    return !in->failed;
}

condition *condition_top(pov_reader *in)
{
    size_t i = in->frames.count, least = 0;

    while (i > 0 && in->frames.items[i - 1].kind != FRAME_MACRO)
        i--;
    if (i > 0)
        least = in->frames.items[i - 1].conditions;
    return in->conditions.count > least ? &in->conditions.items[in->conditions.count - 1] : NULL;
}

static bool open(pov_reader *in, condition_kind kind, const place *at, double wanted)
{
    static const condition none;
    condition c = none;

    c.kind = kind;
    c.at = *at;
    c.value = wanted;
    return condition_open(in, &c);
}

/* ---- branches ---- */

static bool is_chosen_case(pov_reader *in, const condition *c)
{
    const bool is_range = in->token.symbol->id == KEYWORD_RANGE;
    const double wanted = c->value;
    double first, last;

    state_advance(in);
    state_open(in, '(');
    first = last = is_range ? expression_number(in) : expression_full_number(in);
    if (is_range) {
        state_accept(in, ',');
        last = expression_number(in);
    }
    if (state_require(in, ')'))
        in->nesting--;
    if (in->failed)
        return false;
    return is_range ? first <= wanted && wanted <= last : fabs(first - wanted) <= EXPRESSION_NEAR || first == wanted;
}

static bool take_else(pov_reader *in, condition *c)
{
    if (c->has_else)
        report_fail(in, &in->token.at, POV_E_SYNTAX, "a second \"#else\"");
    c->has_else = true;
    return true;
}

static void misplaced(pov_reader *in, const place *at)
{
    report_fail(in, at, POV_E_SYNTAX, "there is nothing open that this \"#%s\" belongs to", in->token.symbol->name);
}

static void close_condition(pov_reader *in)
{
    in->conditions.count--;
    directive_step(in);
}

/* The words of a branch have been found: does it begin here? Its last token is the next one then. */
static bool begins(pov_reader *in, condition *c)
{
    const bool is_switch = c->kind == CONDITION_SWITCH;

    switch (in->token.symbol->id) {
    case KEYWORD_ELSE:
        return take_else(in, c);
    case KEYWORD_ELSEIF:
        if (is_switch || c->has_else) {
            misplaced(in, &in->token.at);
            return false;
        }
        return condition_holds(in);
    default:
        if (!is_switch) {
            misplaced(in, &in->token.at);
            return false;
        }
        return is_chosen_case(in, c);
    }
}

/* From a branch that is not taken to the one that is, or behind the end. */
static void find_branch(pov_reader *in)
{
    while (!in->failed) {
        const size_t index = in->conditions.count - 1;
        condition *c = &in->conditions.items[index];
        const token t = directive_skip(in, &c->at, 1, true);

        if (in->failed)
            return;
        in->token = t;
        if (t.symbol->id == KEYWORD_END) {
            close_condition(in);
            return;
        }
        if (begins(in, &in->conditions.items[index])) {
            directive_step(in);
            return;
        }
    }
}

static void choose(pov_reader *in, bool holds)
{
    if (in->failed)
        return;
    if (holds)
        directive_step(in);
    else
        find_branch(in);
}

/* ---- directives ---- */

void condition_if(pov_reader *in, const place *at)
{
    bool holds = condition_holds(in);

    if (open(in, CONDITION_IF, at, 0.0))
        choose(in, holds);
}

void condition_ifdef(pov_reader *in, const place *at)
{
    const bool wanted = in->token.symbol->id == KEYWORD_IFDEF;
    bool is_there;

    state_advance(in);
    is_there = array_reads_defined(in);
    if (!in->failed)
        in->nesting--;
    if (open(in, CONDITION_IF, at, 0.0))
        choose(in, is_there == wanted);
}

/* The branch before it has been read: the rest is left out. */
static void leave_branches(pov_reader *in, const place *at)
{
    condition *c = condition_top(in);

    if (!c || c->kind != CONDITION_IF || c->has_else) {
        misplaced(in, at);
        return;
    }
    while (!in->failed && in->token.symbol->id != KEYWORD_END) {
        if (in->token.symbol->id == KEYWORD_ELSE)
            take_else(in, c);
        else if (c->has_else || in->token.symbol->id != KEYWORD_ELSEIF)
            misplaced(in, at);
        if (!in->failed)
            in->token = directive_skip(in, &c->at, 1, true);
    }
    if (!in->failed)
        close_condition(in);
}

void condition_elseif(pov_reader *in, const place *at)
{
    leave_branches(in, at);
}

void condition_else(pov_reader *in, const place *at)
{
    condition *c = condition_top(in);

    if (c && c->kind == CONDITION_SWITCH) {
        take_else(in, c);
        directive_step(in);
        return;
    }
    leave_branches(in, at);
}

void condition_end(pov_reader *in, const place *at)
{
    condition *c = condition_top(in);

    if (!c)
        misplaced(in, at);
    else if (c->kind == CONDITION_WHILE || c->kind == CONDITION_FOR)
        loop_turn(in, at);
    else
        close_condition(in);
}

/* The word of the #case or #range that must stand behind #switch. */
static bool find_case(pov_reader *in)
{
    frame_fetch(in, &in->token);
    state_require(in, '#');
    frame_fetch(in, &in->token);
    if (state_keyword(in) != KEYWORD_CASE && state_keyword(in) != KEYWORD_RANGE)
        report_expected(in, "\"case\" or \"range\"");
    return !in->failed;
}

static void take_case(pov_reader *in)
{
    const size_t index = in->conditions.count - 1;

    if (is_chosen_case(in, &in->conditions.items[index]))
        directive_step(in);
    else if (!in->failed)
        find_branch(in);
}

void condition_switch(pov_reader *in, const place *at)
{
    double wanted;

    state_advance(in);
    state_open(in, '(');
    wanted = expression_full_number(in);
    if (state_require(in, ')'))
        in->nesting--;
    if (open(in, CONDITION_SWITCH, at, wanted) && find_case(in))
        take_case(in);
}

/* The branch before it runs on into this one. */
void condition_case(pov_reader *in, const place *at)
{
    condition *c = condition_top(in);

    if (!c || c->kind != CONDITION_SWITCH) {
        misplaced(in, at);
        return;
    }
    is_chosen_case(in, c);
    directive_step(in);
}
