/* The formulas of internal functions, recorded from their texts: C expressions of x, y, z and p[0] on. */
#include "function/internal.h"
#include "function/tape_record.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

typedef struct reading {
    recorder *r;
    const char *at;
    const uint32_t *xyz, *p;
} reading;

enum { ARGUMENTS = 3, NAME = 16, TUBES_MAX = 64 };

static uint32_t sum(reading *in);

static char next(reading *in)
{
    while (*in->at == ' ')
        in->at++;
    return *in->at;
}

static bool accept(reading *in, char c)
{
    if (next(in) != c)
        return false;
    in->at++;
    return true;
}

static uint32_t number(reading *in, double k) { return record_constant(in->r, k); }
static uint32_t op(reading *in, char which, uint32_t a, uint32_t b) { return record_arithmetic(in->r, which, a, b); }

/* ---- functions that the texts use ---- */

static uint32_t squared(reading *in, uint32_t a) { return op(in, '*', a, a); }
static uint32_t root(reading *in, uint32_t a) { return record_one(in->r, "sqrt", a); }
static uint32_t length2(reading *in, uint32_t a, uint32_t b) { return root(in, op(in, '+', squared(in, a), squared(in, b))); }

/* v without whole multiples of `whole`, from 0 up. */
static uint32_t rest_of(reading *in, uint32_t v, uint32_t whole, double shift)
{
    const uint32_t turns = record_one(in->r, "floor", op(in, '+', op(in, '/', v, whole), number(in, shift)));

    return op(in, '-', v, op(in, '*', whole, turns));
}

static uint32_t section(reading *in, uint32_t a, uint32_t b, uint32_t t)
{
    const uint32_t power = op(in, '/', number(in, 2.0), t), inverse = op(in, '/', t, number(in, 2.0));
    double kind;

    a = record_one(in->r, "abs", a);
    b = record_one(in->r, "abs", b);
    if (!record_constant_of(in->r, t, &kind))
        record_give_up(in->r, TAPE_NONE);
    if (kind == 0.0)
        return record_two(in->r, "max", a, b);
    if (kind == 1.0)
        return length2(in, a, b);
    a = record_two(in->r, "pow", a, power);
    return record_two(in->r, "pow", op(in, '+', a, record_two(in->r, "pow", b, power)), inverse);
}

static uint32_t of_one(reading *in, const char *name, uint32_t a)
{
    const uint32_t square = squared(in, a);

    if (strcmp(name, "sq") == 0)
        return square;
    if (strcmp(name, "cube") == 0)
        return op(in, '*', square, a);
    if (strcmp(name, "fourth") == 0)
        return squared(in, square);
    if (strcmp(name, "fold") == 0)
        return rest_of(in, a, number(in, 6.28318530717958647692), 0.0);
    return record_one(in->r, strcmp(name, "fabs") == 0 ? "abs" : name, a);
}

static uint32_t of_two(reading *in, const char *name, uint32_t a, uint32_t b)
{
    if (strcmp(name, "length2") == 0)
        return length2(in, a, b);
    if (strcmp(name, "to_thread") == 0)
        return rest_of(in, a, op(in, '*', b, number(in, 2.0)), 0.5);
    return record_two(in->r, strcmp(name, "least") == 0 ? "min" : strcmp(name, "most") == 0 ? "max" : name, a, b);
}

static uint32_t of_three(reading *in, const char *name, uint32_t a, uint32_t b, uint32_t c)
{
    if (strcmp(name, "length3") == 0)
        return root(in, op(in, '+', op(in, '+', squared(in, a), squared(in, b)), squared(in, c)));
    if (strcmp(name, "section") == 0)
        return section(in, a, b, c);
    return record_choice(in->r, strcmp(name, "if_below") == 0 ? TAPE_BELOW : TAPE_ZERO, a, b, c);
}

static uint32_t call(reading *in, const char *name)
{
    uint32_t a[3] = { 0, 0, 0 }, n = 0;

    do
        a[n++] = sum(in);
    while (n < 3 && accept(in, ','));
    accept(in, ')');
    return n == 1 ? of_one(in, name, a[0]) : n == 2 ? of_two(in, name, a[0], a[1]) : of_three(in, name, a[0], a[1], a[2]);
}

/* ---- grammar ---- */

static uint32_t word(reading *in)
{
    char name[NAME];
    uint32_t n = 0, which;

    for (; *in->at == '_' || isalnum((unsigned char)*in->at); in->at++)
        if (n < NAME - 1)
            name[n++] = *in->at;
    name[n] = '\0';
    if (accept(in, '('))
        return call(in, name);
    if (accept(in, '[')) {
        which = (uint32_t)(*in->at++ - '0');
        accept(in, ']');
        return in->p[which];
    }
    return n == 1 ? in->xyz[name[0] - 'x'] : number(in, 3.14159265358979323846);
}

/* Digits, decimals and an exponent, few enough to be exact: strtod() would ask which language the program speaks. */
static double read_number(reading *in)
{
    double value = 0.0, power = 1.0;
    int decimals = 0, exponent = 0, sign = 1;

    for (bool behind = false; *in->at == '.' || isdigit((unsigned char)*in->at); in->at++) {
        behind = behind || *in->at == '.';
        if (*in->at == '.')
            continue;
        value = 10.0 * value + (*in->at - '0');
        decimals += behind;
    }
    if (accept(in, 'e'))
        for (sign = accept(in, '-') ? -1 : 1; isdigit((unsigned char)*in->at); in->at++)
            exponent = 10 * exponent + (*in->at - '0');
    exponent = sign * exponent - decimals;
    for (int i = abs(exponent); i > 0; i--)
        power *= 10.0;
    return exponent < 0 ? value / power : value * power;
}

static uint32_t factor(reading *in)
{
    const char c = next(in);
    uint32_t a;

    if (accept(in, '-'))
        return op(in, '*', factor(in), number(in, -1.0));
    if (accept(in, '(')) {
        a = sum(in);
        accept(in, ')');
        return a;
    }
    return isdigit((unsigned char)c) ? number(in, read_number(in)) : word(in);
}

static uint32_t product(reading *in)
{
    uint32_t a = factor(in);

    for (char c = next(in); c == '*' || c == '/'; c = next(in)) {
        in->at++;
        a = op(in, c, a, factor(in));
    }
    return a;
}

static uint32_t sum(reading *in)
{
    uint32_t a = product(in);

    for (char c = next(in); c == '+' || c == '-'; c = next(in)) {
        in->at++;
        a = op(in, c, a, product(in));
    }
    return a;
}

static uint32_t read_text(recorder *r, const char *text, const uint32_t *xyz, const uint32_t *p)
{
    reading in = { r, text, xyz, p };

    return sum(&in);
}

/* ---- internal functions ---- */

/* How many tubes there are must be known. */
static uint32_t polytubes(recorder *r, const uint32_t *v)
{
    const uint32_t radius = read_text(r, internal_tube_text(), v, v + ARGUMENTS);
    reading in = { r, "", v, v + ARGUMENTS };
    uint32_t nearest = record_constant(r, 10000.0);
    double tubes;

    if (!record_constant_of(r, v[ARGUMENTS], &tubes) || tubes > TUBES_MAX)
        record_give_up(r, TAPE_NONE);
    for (int i = 0; i < (tubes <= TUBES_MAX ? (int)tubes : 0); i++) {
        const uint32_t angle = record_constant(r, 6.28318530717958647692 * i / tubes);
        const uint32_t x = op(&in, '-', v[0], op(&in, '*', radius, record_one(r, "sin", angle)));
        const uint32_t z = op(&in, '-', v[2], op(&in, '*', radius, record_one(r, "cos", angle)));

        nearest = record_two(r, "min", nearest, length2(&in, x, z));
    }
    return nearest;
}

/* The point in the plane of the curve. */
static void turn(recorder *r, const uint32_t *v, const uint32_t *p, uint32_t out[ARGUMENTS])
{
    const uint32_t flat = record_arithmetic(r, '*', p[0], record_constant(r, -1.0));

    for (int i = 0; i < 2; i++) {
        const uint32_t turned = read_text(r, internal_curve_text(i), v, p);

        out[i] = record_choice(r, TAPE_BELOW, flat, turned, v[i]);
    }
    out[2] = v[2];
}

static uint32_t limited(recorder *r, uint32_t a, uint32_t most, bool is_lower_last)
{
    const uint32_t least = record_arithmetic(r, '*', most, record_constant(r, -1.0));

    if (is_lower_last)
        return record_two(r, "max", least, record_two(r, "min", most, a));
    return record_two(r, "min", most, record_two(r, "max", least, a));
}

uint32_t tape_text_internal(recorder *r, uint32_t number, const uint32_t *v)
{
    const uint32_t *const p = v + ARGUMENTS;
    uint32_t xyz[ARGUMENTS] = { v[0], v[1], v[2] }, a;
    internal_form form;
    const char *const text = internal_text(number, &form);

    if (number == INTERNAL_HEX_X || number == INTERNAL_HEX_Y)
        return record_step(r, number == INTERNAL_HEX_X ? TAPE_HEX_ALONG : TAPE_HEX_ACROSS, v[0], v[1], 0);
    if (number == INTERNAL_POLYTUBES)
        return polytubes(r, v);
    if (!text) {
        record_give_up(r, TAPE_NONE);
        return 0;
    }
    if (form >= INTERNAL_TURNED)
        turn(r, v, v + internal_arguments(number) - ARGUMENTS, xyz);
    a = read_text(r, text, xyz, p);
    if (form == INTERNAL_PLAIN)
        return a;
    a = record_arithmetic(r, '*', a, p[0]);
    return limited(r, a, form == INTERNAL_TURNED_LIMIT ? p[1] : record_constant(r, 10.0), form == INTERNAL_TURNED_LIMIT && number == 0);
}
