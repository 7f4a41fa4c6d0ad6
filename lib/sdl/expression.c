#include "sdl/expression.h"

#include "sdl/array.h"
#include "sdl/calc.h"
#include "sdl/function.h"
#include "sdl/operator.h"
#include "sdl/report.h"
#include "sdl/spline.h"
#include "sdl/text.h"

#include <math.h>

static value nothing(void)
{
    return value_of_number(0.0);
}

static value refuse(pov_reader *in, value v, const char *wanted)
{
    report_fail(in, &in->value, POV_E_SYNTAX, "expected %s, found %s", wanted, value_name(&v));
    value_drop(&in->heap, &v);
    return nothing();
}

/* ---- operands ---- */

static value vector_literal(pov_reader *in)
{
    value v = nothing();

    v.kind = VALUE_VECTOR;
    v.size = 0;
    state_open(in, '<');
    do {
        v.as.v[v.size++] = expression_number(in);
        state_accept(in, ',');
    } while (v.size < 5 && !in->failed && (v.size < 2 || in->token.kind != '>'));
    state_close(in, '>');
    return in->failed ? nothing() : v;
}

static value parentheses(pov_reader *in)
{
    value v;

    state_open(in, '(');
    v = expression_full(in);
    state_close(in, ')');
    v.is_part = false;
    return v;
}

value *expression_element(pov_reader *in, value *slot, shared **lender)
{
    while (slot->kind == VALUE_ARRAY && in->token.kind == '[' && !in->failed) {
        array *a = value_array(slot);

        a->head.uses++;
        value_unshare(&in->heap, *lender);
        *lender = &a->head;
        slot = array_slot(in, a);
        if (!slot)
            break;
    }
    return in->failed ? NULL : slot;
}

value expression_call(pov_reader *in, value callee)
{
    if (in->token.kind != '(' || in->failed)
        return callee;
    if (callee.kind == VALUE_FUNCTION)
        return function_call(in, callee);
    if (callee.kind == VALUE_SPLINE)
        return spline_call(in, callee);
    return callee;
}

static value element(pov_reader *in, const symbol *name)
{
    value *slot = name->binding->slot, v;
    shared *lender = name->binding->lender ? name->binding->lender : &name->binding->head;
    const place at = in->token.at;

    lender->uses++;
    state_advance(in);
    slot = expression_element(in, slot, &lender);
    if (slot && slot->kind == VALUE_NOTHING)
        report_fail(in, &at, POV_E_SYNTAX, "this element of \"%s\" has no value yet", name->name);
    v = in->failed ? nothing() : value_keep(*slot);
    value_unshare(&in->heap, lender);
    return expression_call(in, v);
}

/* The value is taken before the token is: the scope may end behind it. */
static value identifier(pov_reader *in)
{
    const symbol *name = in->token.symbol;
    value v = *name->binding->slot;

    if (value_is_arithmetic(&v)) {
        state_advance(in);
        return v;
    }
    if (v.kind == VALUE_ARRAY)
        return element(in, name);
    v = value_keep(v);
    state_advance(in);
    return expression_call(in, v);
}

static void refuse_operand(pov_reader *in)
{
    const token *t = &in->token;

    if (t->kind == TOKEN_WORD && t->symbol->id == KEYWORD_OTHER)
        report_undeclared(in);
    else
        report_expected(in, in->wanted);
}

static value word(pov_reader *in)
{
    const intrinsic *row = in->token.symbol->intrinsic;
    value v = nothing();

    if (row) {
        state_note_povray(in, &in->token.at);
        state_advance(in);
        row->read(in, row, &v);
    } else if (in->token.symbol->binding) {
        v = identifier(in);
    } else {
        refuse_operand(in);
    }
    return v;
}

static value primary(pov_reader *in)
{
    value v = nothing();

    state_settle(in);
    switch (in->token.kind) {
    case TOKEN_NUMBER:
        v = value_of_number(in->token.number);
        state_advance(in);
        return v;
    case '<':
        return vector_literal(in);
    case '(':
        state_note_povray(in, &in->token.at);
        return parentheses(in);
    case TOKEN_STRING:
        v = text_literal(in);
        if (!in->failed)
            state_advance(in);
        return v;
    case TOKEN_WORD:
        return word(in);
    default:
        refuse_operand(in);
        return v;
    }
}

/* ---- dots ---- */

int expression_component(keyword_id word)
{
    switch (word) {
    case KEYWORD_X: case KEYWORD_U: case KEYWORD_RED:
        return 0;
    case KEYWORD_Y: case KEYWORD_V: case KEYWORD_GREEN:
        return 1;
    case KEYWORD_Z: case KEYWORD_BLUE:
        return 2;
    case KEYWORD_T: case KEYWORD_FILTER:
        return 3;
    case KEYWORD_TRANSMIT:
        return 4;
    case KEYWORD_GRAY:
        return EXPRESSION_GRAY;
    default:
        return -1;
    }
}

double expression_part(const double v[5], int component)
{
    if (component == EXPRESSION_HEIGHT)
        return 0.996093 * (v[0] + v[1] / 255.0);   /* as measured */
    return component == EXPRESSION_GRAY ? 0.297 * v[0] + 0.589 * v[1] + 0.114 * v[2] : v[component];
}

static void refuse_component(pov_reader *in, const value *v)
{
    const char *name = in->token.symbol->name;

    if (v->kind == VALUE_VECTOR)
        report_fail(in, &in->token.at, POV_E_SYNTAX, "a vector of %d has no component \"%s\"", v->size, name);
    else
        report_fail(in, &in->token.at, POV_E_SYNTAX, "%s has no component \"%s\"", value_name(v), name);
}

/* What is not there is 0. */
static void fill_gray(value *v)
{
    int i;

    for (i = v->kind == VALUE_NUMBER ? 1 : v->size; i < 3; i++)
        v->as.v[i] = 0.0;
}

static value dot(pov_reader *in, value v)
{
    const place at = in->token.at;
    int i;

    state_note_povray(in, &at);
    state_advance(in);
    i = expression_component(state_keyword(in));
    if (i < 0) {
        report_expected(in, "a component such as \"x\" or \"red\"");
    } else if (!value_is_arithmetic(&v) || (i != EXPRESSION_GRAY && i >= v.size)) {
        refuse_component(in, &v);
    } else {
        if (i == EXPRESSION_GRAY)
            fill_gray(&v);
        /* The other components stay where they are, as in POV-Ray: the first one, changed, in the place of a vector. */
        v.as.v[0] = expression_part(v.as.v, i);
        v.is_part = v.is_part || v.kind == VALUE_VECTOR;
        v.kind = VALUE_NUMBER;
        v.is_colour = false;
        v.size = 1;
        state_advance(in);
        return v;
    }
    value_drop(&in->heap, &v);
    return nothing();
}

static value dots(pov_reader *in, value v)
{
    while (in->token.kind == '.' && !in->failed)
        v = dot(in, v);
    return v;
}

/* ---- signs ---- */

static bool is_sign(int kind)
{
    return kind == '-' || kind == '+' || kind == '!';
}

/* Of many signs only this matters: behind the first ! whether a value is true, before it how often it is negated. */
typedef struct signs { bool is_negated; int nots; } signs;

static signs read_signs(pov_reader *in)
{
    signs s = { false, 0 };

    for (; is_sign(in->token.kind) && !in->failed; state_advance(in), state_settle(in)) {
        if (in->token.kind == '!') {
            state_note_povray(in, &in->token.at);
            s.nots++;
        } else if (in->token.kind == '-' && s.nots == 0) {
            s.is_negated = !s.is_negated;
        }
    }
    return s;
}

static value apply_signs(pov_reader *in, signs s, value v)
{
    int i;

    if (!s.is_negated && s.nots == 0)
        return v;
    if (!value_is_arithmetic(&v))
        return refuse(in, v, "a number or a vector behind the sign");
    for (i = 0; i < v.size; i++) {
        if (s.nots > 0)
            v.as.v[i] = expression_is_true(v.as.v[i]) == (s.nots % 2 == 0);
        if (s.is_negated)
            v.as.v[i] = -v.as.v[i];
    }
    return v;
}

/* A number, or the name of a number or vector: most operands are. */
static bool read_plain(pov_reader *in, value *out)
{
    const token *t = &in->token;

    if (t->kind == TOKEN_NUMBER)
        *out = value_of_number(t->number);
    else if (t->kind == TOKEN_WORD && t->symbol->binding && value_is_arithmetic(t->symbol->binding->slot))
        *out = *t->symbol->binding->slot;
    else
        return false;
    state_advance(in);
    return true;
}

static value operand(pov_reader *in)
{
    value v;
    signs s;

    if (read_plain(in, &v))
        return dots(in, v);
    v = nothing();
    if (!state_enter(in))
        return v;
    state_settle(in);
    s = read_signs(in);
    v = apply_signs(in, s, dots(in, primary(in)));
    state_exit(in);
    if (!in->failed)
        return v;
    value_drop(&in->heap, &v);
    return nothing();
}

value expression_operand(pov_reader *in)
{
    return operand(in);
}

/* ---- the additive grammar ---- */

/* Strings have no operators but comparisons. In the oldest scenes `<-1 -1 -1>` is three numbers. */
static bool has_arithmetic(const pov_reader *in, const value *v)
{
    if (v && v->kind == VALUE_STRING)
        return false;
    return in->version >= 1.5 || in->version == 0.0 || in->parentheses > 0;
}

static value product(pov_reader *in, value v)
{
    while ((in->token.kind == '*' || in->token.kind == '/') && !in->failed && has_arithmetic(in, &v)) {
        const int op = in->token.kind;
        const place at = in->token.at;

        state_note_povray(in, &at);
        state_advance(in);
        operator_combine(in, op, &at, &v, operand(in));
    }
    return v;
}

static value sum(pov_reader *in, value v)
{
    v = product(in, v);
    while ((in->token.kind == '+' || in->token.kind == '-') && !in->failed && has_arithmetic(in, &v)) {
        const int op = in->token.kind;
        const place at = in->token.at;

        state_note_povray(in, &at);
        state_advance(in);
        operator_combine(in, op, &at, &v, product(in, operand(in)));
    }
    return v;
}

bool expression_goes_on(const pov_reader *in)
{
    const int kind = in->token.kind;

    return kind == '.' || ((kind == '+' || kind == '-' || kind == '*' || kind == '/') && has_arithmetic(in, NULL));
}

value expression_go_on(pov_reader *in, value v)
{
    return sum(in, dots(in, v));
}

value expression_negative(pov_reader *in)
{
    const signs minus = { true, 0 };

    return sum(in, apply_signs(in, minus, operand(in)));
}

value expression_read(pov_reader *in)
{
    value v;

    in->value = in->token.at;
    if (in->top->tokens && calc_read(in, REPLAY_ADDITIVE, &v))
        return v;
    return sum(in, operand(in));
}

/* ---- the full grammar ---- */

static bool is_comparison(int kind)
{
    return kind == '<' || kind == '>' || kind == '=' || kind == TOKEN_AT_MOST || kind == TOKEN_AT_LEAST ||
           kind == TOKEN_UNEQUAL;
}

static value comparison(pov_reader *in)
{
    value v = sum(in, operand(in));

    while (is_comparison(in->token.kind) && !in->failed) {
        const int op = in->token.kind;
        const place at = in->token.at;

        state_advance(in);
        operator_combine(in, op, &at, &v, sum(in, operand(in)));
    }
    return v;
}

static value logic(pov_reader *in)
{
    value v = comparison(in);

    while ((in->token.kind == '&' || in->token.kind == '|') && !in->failed) {
        const int op = in->token.kind;
        const place at = in->token.at;

        state_advance(in);
        operator_combine(in, op, &at, &v, comparison(in));
    }
    return v;
}

/* Both branches are read; the condition is a number. */
static value choice(pov_reader *in, value chooser)
{
    bool is_true;
    value a, b;

    if (!state_enter(in))
        return chooser;
    is_true = expression_is_true(expression_to_number(in, chooser));
    state_advance(in);
    a = expression_full(in);
    state_expect(in, ':');
    b = expression_full(in);
    state_exit(in);
    if (!in->failed && (a.kind == VALUE_STRING || b.kind == VALUE_STRING))
        report_fail(in, &in->value, POV_E_SYNTAX, "strings have no \"? :\"");
    value_drop(&in->heap, is_true ? &b : &a);
    if (in->failed)
        value_drop(&in->heap, is_true ? &a : &b);
    return in->failed ? nothing() : is_true ? a : b;
}

value expression_full(pov_reader *in)
{
    value v;

    in->value = in->token.at;
    if (in->top->tokens && calc_read(in, REPLAY_FULL, &v))
        return v;
    in->parentheses++;
    v = logic(in);
    if (in->token.kind == '?' && !in->failed)
        v = choice(in, v);
    in->parentheses--;
    return v;
}

/* ---- kinds ---- */

double expression_to_number(pov_reader *in, value v)
{
    double number;

    if (v.kind != VALUE_NUMBER)
        v = refuse(in, v, "a number");
    number = v.as.v[0];
    return in->failed ? 0.0 : number;
}

/* A number fills all three, but a component stands in the first place before its vector's others; two have a 0 behind them; a
 * colour is no vector. */
bool expression_to_vector(pov_reader *in, value *v)
{
    if (v->kind == VALUE_NUMBER) {
        if (!v->is_part)
            v->as.v[1] = v->as.v[2] = v->as.v[0];
    } else if (v->kind == VALUE_VECTOR && v->size <= 3) {
        if (v->size == 2)
            v->as.v[2] = 0.0;
    } else if (v->kind == VALUE_VECTOR && !v->is_colour) {
        report_fail(in, &in->value, POV_E_SYNTAX, "expected a vector, found one of %d components", v->size);
    } else {
        *v = refuse(in, *v, "a vector");
    }
    return !in->failed;
}

string *expression_to_string(pov_reader *in, value v)
{
    if (v.kind == VALUE_STRING)
        return value_string(&v);
    refuse(in, v, "a string");
    return NULL;
}

double expression_number(pov_reader *in)
{
    const char *wanted = in->wanted;
    double number;

    if (in->token.kind == TOKEN_NUMBER && !in->failed && calc_is_argument(in)) {
        in->value = in->token.at;
        number = in->token.number;
        state_advance(in);
        return number;
    }
    in->wanted = "a number";
    number = expression_to_number(in, expression_read(in));
    in->wanted = wanted;
    return number;
}

double expression_full_number(pov_reader *in)
{
    const char *wanted = in->wanted;
    double number;

    in->wanted = "a number";
    number = expression_to_number(in, expression_full(in));
    in->wanted = wanted;
    return number;
}

bool expression_condition(pov_reader *in)
{
    return expression_is_true(expression_full_number(in));
}

pov_vec3 expression_vector(pov_reader *in)
{
    const char *wanted = in->wanted;
    value v;

    in->wanted = "a vector";
    v = expression_read(in);
    in->wanted = wanted;
    if (!expression_to_vector(in, &v))
        return pov_vec3_of(0.0, 0.0, 0.0);
    return pov_vec3_of(v.as.v[0], v.as.v[1], v.as.v[2]);
}

int32_t expression_integer(double number)
{
    return number > -2147483649.0 && number < 2147483648.0 ? (int32_t)number : INT32_MIN;
}
