#include "sdl/operator.h"

#include "sdl/expression.h"
#include "sdl/report.h"
#include "sdl/text.h"

#include <math.h>

/* What is no number equals all, as in POV-Ray, and so do infinite numbers of one sign. */
static double equal(double a, double b)
{
    return !(fabs(a - b) > EXPRESSION_NEAR);
}

static double operate(int op, double a, double b)
{
    switch (op) {
    case '+':
        return a + b;
    case '-':
        return a - b;
    case '*':
        return a * b;
    case '/':
        return b == 0.0 ? HUGE_VAL : a / b;
    case '<':
        return a < b;
    case '>':
        return a > b;
    case TOKEN_AT_MOST:
        return a < b || equal(a, b);
    case TOKEN_AT_LEAST:
        return a > b || equal(a, b);
    case '=':
        return equal(a, b);
    case TOKEN_UNEQUAL:
        return !equal(a, b);
    case '&':
        return expression_is_true(a) && expression_is_true(b);
    default:
        return expression_is_true(a) || expression_is_true(b);
    }
}

static double component(const value *v, int i)
{
    return v->kind == VALUE_NUMBER ? v->as.v[0] : i < v->size ? v->as.v[i] : 0.0;
}

/* A number fills all components of the other operand; behind a shorter vector stand zeros. */
static void combine_vectors(int op, value *a, const value *b)
{
    const int size = a->size > b->size ? a->size : b->size;
    value r = a->kind == VALUE_NUMBER ? value_of_number(0.0) : *a;
    int i;

    r.kind = VALUE_VECTOR;
    r.size = size;
    r.is_colour = a->is_colour || b->is_colour;
    for (i = 0; i < size; i++)
        r.as.v[i] = operate(op, component(a, i), component(b, i));
    *a = r;
}

static bool compare_strings(int op, value *a, const value *b)
{
    const int order = text_compare(value_string(a), value_string(b));

    if (op != '<' && op != '>' && op != '=' && op != TOKEN_AT_MOST && op != TOKEN_AT_LEAST && op != TOKEN_UNEQUAL)
        return false;
    *a = value_of_number(operate(op, order, 0.0));
    return true;
}

static void warn_of_zero(pov_reader *in, const place *at, const value *b)
{
    int i;

    for (i = 0; i < b->size; i++)
        if (b->as.v[i] == 0.0) {
            report_warn(in, at, "a division by 0 is infinite");
            return;
        }
}

void operator_combine(pov_reader *in, int op, const place *at, value *a, value b)
{
    if (in->failed) {
        value_drop(&in->heap, a);
        *a = value_of_number(0.0);
    } else if (a->kind == VALUE_NUMBER && b.kind == VALUE_NUMBER) {
        if (op == '/' && b.as.v[0] == 0.0)
            warn_of_zero(in, at, &b);
        a->as.v[0] = operate(op, a->as.v[0], b.as.v[0]);
    } else if (value_is_arithmetic(a) && value_is_arithmetic(&b)) {
        if (op == '/')
            warn_of_zero(in, at, &b);
        combine_vectors(op, a, &b);
    } else {
        value old = *a;

        if (a->kind != VALUE_STRING || b.kind != VALUE_STRING || !compare_strings(op, a, &b)) {
            report_fail(in, at, POV_E_SYNTAX, "%s and %s cannot be combined so", value_name(a), value_name(&b));
            *a = value_of_number(0.0);
        }
        value_drop(&in->heap, &old);
    }
    value_drop(&in->heap, &b);
}
