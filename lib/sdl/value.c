#include "sdl/value.h"

#include "sdl/report.h"
#include "sdl/unsupported.h"

#include <float.h>
#include <stdio.h>

static bool is_sign(int kind)
{
    return kind == '+' || kind == '-';
}

bool value_follows(const pov_reader *in)
{
    return in->token.kind == TOKEN_NUMBER || in->token.kind == '<' || is_sign(in->token.kind);
}

static bool is_operator(int kind)
{
    return is_sign(kind) || kind == '*' || kind == '/' || kind == '.';
}

/* Behind a value an operator would go on with it: "1 -2" is one number in this language, not two. */
static void refuse_operator(pov_reader *in)
{
    char mark[REPORT_QUOTE], what[REPORT_QUOTE + 64];
    place at = in->token.at;

    if (!is_operator(in->token.kind))
        return;
    report_quote(&at, mark);
    snprintf(what, sizeof what,
             is_sign(in->token.kind) ? "the operator \"%s\" (a \",\" before it begins a new value)"
                                     : "the operator \"%s\"", mark);
    unsupported_form(in, &at, what);
}

static void expected_value(pov_reader *in, const char *wanted)
{
    if (in->token.kind == '(')
        unsupported_form(in, &in->token.at, "an expression");
    else
        report_expected(in, wanted);
}

/* Signs and digits; the token is a sign or a number. */
static double signed_number(pov_reader *in, const char *wanted)
{
    bool negative = false, has_sign = is_sign(in->token.kind);
    double number;

    for (; is_sign(in->token.kind); state_advance(in))
        negative ^= in->token.kind == '-';
    if (in->token.kind != TOKEN_NUMBER) {
        if (has_sign && in->token.kind == '<')
            unsupported_form(in, &in->token.at, "a sign before a vector");
        else
            expected_value(in, wanted);
        return 0.0;
    }
    number = in->token.number;
    state_advance(in);
    refuse_operator(in);
    if (in->failed)
        return 0.0;
    return negative ? -number : number;
}

static double component(pov_reader *in)
{
    return signed_number(in, "a number");
}

double value_number(pov_reader *in)
{
    if (in->failed)
        return 0.0;
    in->value = in->token.at;
    return signed_number(in, "a number");
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

static int angle_list(pov_reader *in, int least, int most, double *out)
{
    int count = 0;

    state_advance(in);
    do {
        out[count++] = component(in);
        state_accept(in, ',');
    } while (count < most && !in->failed && (count < least || in->token.kind != '>'));
    state_expect(in, '>');
    refuse_operator(in);
    return count;
}

int value_list(pov_reader *in, const char *wanted, int least, int most, double *out)
{
    int i, count = 0;

    for (i = 0; i < most; i++)
        out[i] = 0.0;
    if (in->failed)
        return 0;
    in->value = in->token.at;
    if (in->token.kind == '<') {
        count = angle_list(in, least, most, out);
    } else {
        out[0] = signed_number(in, wanted);
        count = 1;
    }
    for (i = 0; i < most && in->failed; i++)
        out[i] = 0.0;
    return in->failed ? 0 : count;
}

pov_vec3 value_vector(pov_reader *in)
{
    double v[VALUE_LIST_MAX];
    bool is_list = in->token.kind == '<';

    value_list(in, "a vector", 2, 3, v);
    return is_list ? pov_vec3_of(v[0], v[1], v[2]) : pov_vec3_of(v[0], v[0], v[0]);
}
