#include "sdl/number.h"

#include "base/simd.h"

#include <povtrace/exact.h>

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

enum {
    MANTISSA_DIGITS = 19,        /* as many always fit 64 bits */
    EXACT_POWER = 22,            /* the largest power of ten that a double holds */
    EXPONENT_LIMIT = 100000000,  /* beyond it no text is long enough to bring the number back */
    KEPT_DIGITS = 770            /* two neighbouring doubles, and their middle, differ within 768 digits */
};

/* The parts of a number's text. The value is digits * 10^exponent, where digits are those from first to last
 * without the point. */
typedef struct parts {
    const char *first, *last;    /* the mantissa, from its first digit that is not zero */
    uint64_t mantissa;           /* of the first MANTISSA_DIGITS digits */
    long digits;                 /* from the first that is not zero */
    long fraction;               /* digits behind the point */
    long exponent;               /* as written behind the e */
} parts;

static const double powers[EXACT_POWER + 1] = {
    1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
    1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22,
};

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

static bool goes_on(char c)
{
    return is_digit(c) || c == '.';
}

static const char *read_digits(const char *at, const char *end, parts *p)
{
    for (; at < end && is_digit(*at); at++) {
        if (p->digits == 0) {
            if (*at == '0')
                continue;
            p->first = at;
        }
        if (p->digits < MANTISSA_DIGITS)
            p->mantissa = 10 * p->mantissa + (uint64_t)(*at - '0');
        p->digits++;
    }
    return at;
}

/* From the e on. Where no digit follows it the exponent is 0. */
static const char *read_exponent(const char *at, const char *end, parts *p)
{
    bool negative = false;

    at++;
    if (at < end && (*at == '+' || *at == '-'))
        negative = *at++ == '-';
    for (; at < end && is_digit(*at); at++)
        if (p->exponent < EXPONENT_LIMIT)
            p->exponent = 10 * p->exponent + (*at - '0');
    if (negative)
        p->exponent = -p->exponent;
    return at;
}

/* Any length: the digits are given to strtod as a whole number with an exponent, so that no decimal point of
 * a locale comes in. What stands behind KEPT_DIGITS matters only by being zero or not. */
static double read_long(const parts *p)
{
    char text[KEPT_DIGITS + 32];
    long exponent = p->exponent - p->fraction, kept = 0, seen = 0;
    bool rest = false;
    const char *at;

    for (at = p->first; at < p->last; at++) {
        if (!is_digit(*at))
            continue;
        seen++;
        if (kept < KEPT_DIGITS)
            text[kept++] = *at;
        else if (*at != '0')
            rest = true;
    }
    exponent += seen - kept;
    if (rest) {
        text[kept++] = '1';
        exponent--;
    }
    snprintf(text + kept, sizeof text - (size_t)kept, "e%ld", exponent);
    return strtod(text, NULL);
}

/* Mantissa and power as double-double numbers. The quotient or product is within 2^-102 of the true value; unless
 * that is so near the middle of two doubles, its rounding is the right one. */
static bool read_two_part(uint64_t mantissa, long exponent, double *out)
{
    pov_two m, v;
    double slack;

    m.hi = (double)mantissa;
    m.lo = (double)(int64_t)(mantissa - (uint64_t)m.hi);
    if (exponent < 0)
        v = pov_two_div(m, pov_two_of(powers[-exponent], 0.0));
    else
        v = pov_two_mul_double(m, powers[exponent]);
    slack = v.hi * 0x1p-100;
    *out = v.hi;
    return v.hi + (v.lo + slack) == v.hi && v.hi + (v.lo - slack) == v.hi;
}

static double value_of(const parts *p)
{
    long exponent = p->exponent - p->fraction;
    double value;

    if (p->digits <= MANTISSA_DIGITS && exponent >= -EXACT_POWER && exponent <= EXACT_POWER) {
        /* Both operands exact: one rounding (Clinger 1990). */
        if (p->mantissa <= (uint64_t)1 << 53) {
            value = (double)p->mantissa;
            return exponent < 0 ? value / powers[-exponent] : value * powers[exponent];
        }
        if (read_two_part(p->mantissa, exponent, &value))
            return value;
    }
    return read_long(p);
}

static number_state malformed(const char *at, const char *end, const char **after)
{
    while (at < end && goes_on(*at))
        at++;
    *after = at;
    return NUMBER_MALFORMED;
}

static inline const char *read_run(const char *at, const char *end, uint64_t *mantissa)
{
    uint64_t sum = *mantissa;
    unsigned digit;

    for (; at < end && (digit = (unsigned)(unsigned char)*at - '0') <= 9; at++)
        sum = 10 * sum + digit;
    *mantissa = sum;
    return at;
}

/* Nearly all numbers: few digits, perhaps a point, no exponent. Both operands are exact. NULL: another number. */
static inline const char *read_plain(const char *at, const char *end, double *out)
{
    const char *const first = at, *point;
    uint64_t mantissa = 0;
    long fraction = 0;

    at = read_run(at, end, &mantissa);
    if (at < end && *at == '.') {
        point = ++at;
        at = read_run(at, end, &mantissa);
        fraction = (long)(at - point);
    }
    if (at - first > MANTISSA_DIGITS || mantissa > (uint64_t)1 << 53 || (at < end && (*at == '.' || *at == 'e' || *at == 'E')))
        return NULL;
    *out = (double)mantissa / powers[fraction];
    return at;
}

/* Any number. */
static SIMD_RARE number_state read_any(const char *at, const char *end, const char **after, double *out)
{
    parts p = { at, at, 0, 0, 0, 0 };
    const char *point;

    *out = 0.0;
    at = read_digits(at, end, &p);
    if (at < end && *at == '.') {
        point = ++at;
        at = read_digits(at, end, &p);
        p.fraction = (long)(at - point);
    }
    p.last = at;
    if (at < end && (*at == 'e' || *at == 'E'))
        at = read_exponent(at, end, &p);
    if (at < end && *at == '.')
        return malformed(at, end, after);
    *after = at;
    if (p.digits == 0)
        return NUMBER_FINE;
    *out = value_of(&p);
    if (*out > 1.7976931348623157e308)
        return NUMBER_HUGE;
    return *out == 0.0 ? NUMBER_TINY : NUMBER_FINE;
}

number_state number_read(const char *at, const char *end, const char **after, double *out)
{
    const char *const behind = read_plain(at, end, out);

    if (!behind)
        return read_any(at, end, after, out);
    *after = behind;
    return NUMBER_FINE;
}
