#include "texture/pattern.h"

/* mandel, julia and magnet: steps of a sequence of complex numbers, in the xy plane. */
typedef struct fractal {
    int32_t kind;                /* of magnet: 1 or 2 */
    int32_t limit, julia_limit;  /* the second of magnet: where it is given, c is too */
    double c[2];
    int32_t exponent;
    int32_t interior, exterior;
    double interior_factor, exterior_factor;
} fractal;

typedef struct complex_number { double re, im; } complex_number;

static inline complex_number complex_of(double re, double im)
{
    const complex_number z = { re, im };

    return z;
}

static inline complex_number add(complex_number a, complex_number b) { return complex_of(a.re + b.re, a.im + b.im); }
static inline complex_number scaled(complex_number a, double s) { return complex_of(s * a.re, s * a.im); }
static inline double square_of(complex_number a) { return a.re * a.re + a.im * a.im; }

static inline complex_number times(complex_number a, complex_number b)
{
    return complex_of(a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re);
}

static inline complex_number quotient(complex_number a, complex_number b)
{
    return scaled(times(a, complex_of(b.re, -b.im)), 1.0 / square_of(b));
}

/* ---- one step ---- */

static complex_number power_step(const fractal *f, complex_number z, complex_number c)
{
    complex_number power = times(z, z);

    for (int32_t k = 2; k < f->exponent; k++)
        power = times(power, z);
    return add(power, c);
}

static complex_number magnet_step1(complex_number z, complex_number c)
{
    const complex_number q = quotient(add(times(z, z), complex_of(c.re - 1.0, c.im)),
                                      add(scaled(z, 2.0), complex_of(c.re - 2.0, c.im)));

    return times(q, q);
}

static complex_number magnet_step2(complex_number z, complex_number c)
{
    const complex_number c1 = complex_of(c.re - 1.0, c.im), c2 = complex_of(c.re - 2.0, c.im), both = times(c1, c2);
    const complex_number square = times(z, z);
    const complex_number over = add(times(z, add(square, scaled(c1, 3.0))), both);
    const complex_number below = add(add(scaled(square, 3.0), scaled(times(c2, z), 3.0)), complex_of(both.re + 1.0, both.im));
    const complex_number q = quotient(over, below);

    return times(q, q);
}

static complex_number step(const fractal *f, complex_number z, complex_number c)
{
    return f->kind == 0 ? power_step(f, z, c) : f->kind == 1 ? magnet_step1(z, c) : magnet_step2(z, c);
}

static bool has_escaped(const fractal *f, complex_number z)
{
    const double square = square_of(z);

    if (f->kind == 0)
        return square > 4.0;
    return square > 1e4 || square_of(complex_of(z.re - 1.0, z.im)) < 1e-4;
}

/* ---- the value ---- */

static double component(int32_t type, complex_number z)
{
    switch (type) {
    case 2:
        return z.re;
    case 3:
        return z.im;
    case 4:
        return z.re * z.re;
    case 5:
        return z.im * z.im;
    default:
        return 0.0;
    }
}

/* In type 6 the factor is of the imaginary part alone, as POV-Ray has it. */
static double inside_value(const fractal *f, complex_number z, double least)
{
    if (f->interior == 6)
        return z.re * z.re + z.im * z.im * f->interior_factor;
    return (f->interior == 0 ? 1.0 : f->interior == 1 ? sqrt(least) : component(f->interior, z)) * f->interior_factor;
}

/* The ratio of steps has no factor. */
static double outside_value(const fractal *f, complex_number z, int32_t steps, int32_t limit)
{
    if (f->exterior == 1)
        return (double)steps / limit;
    return (f->exterior == 0 ? 1.0 : f->exterior == 6 ? sqrt(square_of(z)) : component(f->exterior, z)) * f->exterior_factor;
}

/* The start counts among the smallest, but for the 0 that a magnet's mandel begins with. */
static double value_of(const fractal *f, double x, double y)
{
    const bool has_c = f->julia_limit > 0;
    const int32_t limit = has_c ? f->julia_limit : f->limit;
    const complex_number at = complex_of(x, y), c = has_c ? complex_of(f->c[0], f->c[1]) : at;
    complex_number z = f->kind != 0 && !has_c ? complex_of(0.0, 0.0) : at;
    double least = f->kind != 0 && !has_c ? HUGE_VAL : square_of(z);

    for (int32_t k = 0; k < limit; k++) {
        z = step(f, z, c);
        if (has_escaped(f, z))
            return outside_value(f, z, k, limit);
        least = square_of(z) < least ? square_of(z) : least;
    }
    return inside_value(f, z, least);
}

static void evaluate(const pattern_input *in, double *value)
{
    for (uint32_t i = 0; i < in->n; i++)
        value[i] = value_of(in->of->self, in->at->x[i], in->at->y[i]);
}

static const char *check(const void *self)
{
    const fractal *f = self;

    if (f->exponent < 2 || f->exponent > 33)
        return "the exponent must lie in 2 to 33";
    if (f->interior < 0 || f->interior > 6 || f->exterior < 0 || f->exterior > 6)
        return "types of interior and exterior are 0 to 6";
    return NULL;
}

static const char *check_magnet(const void *self)
{
    const fractal *f = self;

    return f->kind == 1 || f->kind == 2 ? check(self) : "a magnet is of type 1 or 2";
}

/* ---- the words ---- */

#define INTERIOR_AND_EXTERIOR \
    { "exponent", PATTERN_INTEGER, offsetof(fractal, exponent), false }, \
    { "interior", PATTERN_INTEGER, offsetof(fractal, interior), false }, \
    { NULL, PATTERN_NUMBER, offsetof(fractal, interior_factor), false }, \
    { "exterior", PATTERN_INTEGER, offsetof(fractal, exterior), false }, \
    { NULL, PATTERN_NUMBER, offsetof(fractal, exterior_factor), false }

static const fractal usual = { .exponent = 2, .exterior = 1, .interior_factor = 1.0, .exterior_factor = 1.0 };
static const fractal usual_magnet = { .kind = 1, .exponent = 2, .exterior = 1, .interior_factor = 1.0, .exterior_factor = 1.0 };

static const pattern_word mandel_words[] = {
    { NULL, PATTERN_INTEGER, offsetof(fractal, limit), false }, INTERIOR_AND_EXTERIOR,
};
static const pattern_word julia_words[] = {
    { NULL, PATTERN_UV, offsetof(fractal, c), false },
    { NULL, PATTERN_INTEGER, offsetof(fractal, julia_limit), false }, INTERIOR_AND_EXTERIOR,
};
static const pattern_word magnet_words[] = {
    { NULL, PATTERN_INTEGER, offsetof(fractal, kind), false },
    { "mandel", PATTERN_INTEGER, offsetof(fractal, limit), false },
    { "julia", PATTERN_UV, offsetof(fractal, c), false },
    { NULL, PATTERN_INTEGER, offsetof(fractal, julia_limit), false }, INTERIOR_AND_EXTERIOR,
};

/* Outside, little happens beyond the first hundredth of the values. */
static const colour_entry map[] = {
    { 0.0f, { .color = { 0.0f, 0.0f, 0.0f } } },   { 0.001f, { .color = { 0.0f, 0.0f, 0.0f } } },
    { 0.001f, { .color = { 0.0f, 1.0f, 1.0f } } }, { 0.012f, { .color = { 1.0f, 1.0f, 0.0f } } },
    { 0.015f, { .color = { 1.0f, 0.0f, 1.0f } } }, { 0.1f, { .color = { 0.0f, 1.0f, 1.0f } } },
    { 1.0f, { .color = { 0.0f, 1.0f, 1.0f } } },
};

/* Of the others, and of other exponents, the values are shades of grey. */
static bool has_map(const void *self)
{
    const fractal *f = self;

    return f->exponent == 2;
}

#define FRACTAL(name, own, usual_self, check_it, own_map, own_count) \
    const pattern_class pattern_##name = { \
        .keyword = #name, \
        .map = own_map, \
        .map_count = own_count, \
        .has_map = has_map, \
        .self_size = sizeof(fractal), \
        .self = usual_self, \
        .words = own, \
        .word_count = sizeof own / sizeof own[0], \
        .check = check_it, \
        .evaluate = evaluate, \
    }

FRACTAL(mandel, mandel_words, &usual, check, map, sizeof map / sizeof map[0]);
FRACTAL(julia, julia_words, &usual, check, NULL, 0);
FRACTAL(magnet, magnet_words, &usual_magnet, check_magnet, NULL, 0);
