#include "sdl/value.h"

#include "sdl/expression.h"
#include "sdl/report.h"

#include <float.h>

static bool is_sign(int kind)
{
    return kind == '+' || kind == '-';
}

static bool is_value_kind(const value *v)
{
    return v->kind == VALUE_NUMBER || v->kind == VALUE_VECTOR || v->kind == VALUE_ARRAY || v->kind == VALUE_FUNCTION ||
           v->kind == VALUE_SPLINE;
}

static bool is_value_word(const symbol *word)
{
    return word->intrinsic || (word->binding && is_value_kind(word->binding->slot));
}

bool value_follows(const pov_reader *in)
{
    const token *t = &in->token;

    return t->kind == TOKEN_NUMBER || t->kind == '<' || is_sign(t->kind) || t->kind == '(' || t->kind == '!' ||
           (t->kind == TOKEN_WORD && is_value_word(t->symbol));
}

static double finite(pov_reader *in, double number)
{
    if (fabs(number) <= DBL_MAX)
        return number;
    report_fail(in, &in->value, POV_E_SYNTAX, "%g is no number that can stand here", number == number ? number : fabs(number));
    return 0.0;
}

/* What goes on behind a literal. */
static double go_on(pov_reader *in, double number)
{
    if (!expression_goes_on(in))
        return number;
    return expression_to_number(in, expression_go_on(in, value_of_number(number)));
}

/* A literal, with or without a minus. */
static bool read_literal(pov_reader *in, double *out)
{
    const bool is_negative = in->token.kind == '-';
    double number;

    if (is_negative)
        state_advance(in);
    if (in->token.kind != TOKEN_NUMBER) {
        if (is_negative)
            *out = expression_to_number(in, expression_negative(in));
        return is_negative;
    }
    number = is_negative ? -in->token.number : in->token.number;
    state_advance(in);
    *out = go_on(in, number);
    return true;
}

static double component(pov_reader *in)
{
    double number;

    if (!read_literal(in, &number))
        number = expression_number(in);
    return number;
}

double value_number(pov_reader *in)
{
    if (in->failed)
        return 0.0;
    in->value = in->token.at;
    return finite(in, component(in));
}

double value_optional(pov_reader *in, double otherwise)
{
    return value_follows(in) ? value_number(in) : otherwise;
}

float value_float(pov_reader *in)
{
    double number = value_number(in);

    if (number > FLT_MAX || number < -FLT_MAX) {
        report_fail(in, &in->value, POV_E_SYNTAX, "a number beyond %g has no use here", (double)FLT_MAX);
        return 0.0f;
    }
    return (float)number;
}

/* Its numbers may be anything. */
static int angle_list(pov_reader *in, int least, int most, double *out)
{
    int count = 0;

    state_open(in, '<');
    do {
        out[count++] = component(in);
        state_accept(in, ',');
    } while (count < most && !in->failed && (count < least || in->token.kind != '>'));
    state_close(in, '>');
    return count;
}

int value_list(pov_reader *in, const char *wanted, int least, int most, double *out)
{
    int i, count = 0;

    for (i = 0; i < most; i++)
        out[i] = 0.0;
    if (in->failed)
        return 0;
    state_settle(in);
    in->value = in->token.at;
    if (in->token.kind == '<')
        count = angle_list(in, least, most, out);
    else
        report_expected(in, wanted);
    for (i = 0; i < most; i++)
        out[i] = in->failed ? 0.0 : finite(in, out[i]);
    return in->failed ? 0 : count;
}

value value_read(pov_reader *in, const char *wanted_name)
{
    const char *wanted = in->wanted;
    value result = value_of_number(0.0);
    double number;

    if (in->token.kind == '<') {
        result.kind = VALUE_VECTOR;
        result.size = angle_list(in, 2, 5, result.as.v);
        return expression_goes_on(in) ? expression_go_on(in, result) : result;
    }
    if (in->token.kind == TOKEN_NUMBER) {
        number = in->token.number;
        state_advance(in);
        result = value_of_number(number);
        return expression_goes_on(in) ? expression_go_on(in, result) : result;
    }
    in->wanted = wanted_name;
    result = expression_read(in);
    in->wanted = wanted;
    return result;
}

/* Its components may be anything. */
static pov_vec3 any_vector(pov_reader *in)
{
    place at = in->token.at;
    value v;

    if (in->failed)
        return pov_vec3_of(0.0, 0.0, 0.0);
    in->value = at;
    v = value_read(in, "a vector");
    in->value = at;
    if (!expression_to_vector(in, &v))
        return pov_vec3_of(0.0, 0.0, 0.0);
    return pov_vec3_of(v.as.v[0], v.as.v[1], v.as.v[2]);
}

pov_vec3 value_vector(pov_reader *in)
{
    const pov_vec3 v = any_vector(in);

    return pov_vec3_of(finite(in, v.x), finite(in, v.y), finite(in, v.z));
}

pov_vec3 value_vector_of_face(pov_reader *in)
{
    const pov_vec3 v = any_vector(in);

    if (fabs(v.x) <= DBL_MAX && fabs(v.y) <= DBL_MAX && fabs(v.z) <= DBL_MAX)
        return v;
    report_warn(in, &in->value, "faces with a corner that is no number are left out; such a normal counts for nothing");
    return pov_vec3_of(NAN, NAN, NAN);
}

static double component_of(const value *v, int i)
{
    if (v->kind == VALUE_NUMBER)
        return v->as.v[v->is_part ? i : 0];
    return i < v->size ? v->as.v[i] : 0.0;
}

static void refuse_size(pov_reader *in, const place *at, int least, int most, const value *found)
{
    if (found->kind == VALUE_VECTOR && least == most)
        report_fail(in, at, POV_E_SYNTAX, "expected a vector of %d components, found one of %d", least, (int)found->size);
    else if (found->kind == VALUE_VECTOR)
        report_fail(in, at, POV_E_SYNTAX, "expected a vector of %d to %d components, found one of %d", least, most, (int)found->size);
    else
        report_fail(in, at, POV_E_SYNTAX, "expected a vector, found %s", value_name(found));
}

int value_components(pov_reader *in, int least, int most, double *out)
{
    place at = in->token.at;
    value v = value_of_number(0.0);
    int i;

    if (!in->failed) {
        in->value = at;
        v = value_read(in, "a vector");
        in->value = at;
    }
    if (!in->failed && v.kind != VALUE_NUMBER && (v.kind != VALUE_VECTOR || v.size > most || v.size < least))
        refuse_size(in, &at, least, most, &v);
    for (i = 0; i < most; i++)
        out[i] = in->failed ? 0.0 : finite(in, component_of(&v, i));
    if (value_is_shared(&v))
        value_drop(&in->heap, &v);
    return v.kind == VALUE_VECTOR ? v.size : 1;
}

const string *value_text(pov_reader *in)
{
    const char *wanted = in->wanted;
    string *s;

    in->wanted = "a string";
    s = expression_to_string(in, expression_read(in));
    in->wanted = wanted;
    return s;
}
