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

static inline complex_number square_step(complex_number z, complex_number c) { return add(times(z, z), c); }

static complex_number power_step(const fractal *f, complex_number z, complex_number c)
{
    complex_number power = times(z, z);

    for (int32_t k = 2; k < f->exponent; k++)
        power = times(power, z);
    return add(power, c);
}

static inline complex_number magnet_step1(complex_number z, complex_number c)
{
    const complex_number q = quotient(add(times(z, z), complex_of(c.re - 1.0, c.im)),
                                      add(scaled(z, 2.0), complex_of(c.re - 2.0, c.im)));

    return times(q, q);
}

static inline complex_number magnet_step2(complex_number z, complex_number c)
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

static inline bool has_escaped(complex_number z) { return square_of(z) > 4.0; }

/* Of a magnet: it has escaped, or comes to rest at 1. */
static inline bool is_fixed(complex_number z)
{
    return (int)(square_of(z) > 1e4) | (int)(square_of(complex_of(z.re - 1.0, z.im)) < 1e-4);
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

/* What types 7 and 8 count steps by before they begin again; 0: it is not possible. Below 0 they never do, as in POV-Ray. */
static double period_of(const fractal *f) { return trunc(f->exterior_factor) + (f->exterior == 8 ? 1.0 : 0.0); }

static double repeated_steps(const fractal *f, int32_t steps)
{
    const double period = period_of(f);

    if (f->exterior_factor == 0.0)
        return 0.0;
    return (period > 0.0 ? fmod(steps, period) : steps) / f->exterior_factor;
}

/* The ratio of steps has no factor. */
static double outside_value(const fractal *f, complex_number z, int32_t steps, int32_t limit)
{
    if (f->exterior == 1)
        return (double)steps / limit;
    if (f->exterior > 6)
        return repeated_steps(f, steps);
    return (f->exterior == 0 ? 1.0 : f->exterior == 6 ? sqrt(square_of(z)) : component(f->exterior, z)) * f->exterior_factor;
}

/* ---- sequences side by side ---- */

enum { LANES = 32, GROUP = 8, STRIDE = 8, LOOK_BACK = 4 };

/* What a step needs of others comes from the step before, so several sequences take each step together. One that has ended stays
 * where it is until the end of a stride, and the next point takes its lane. */
typedef struct sequences {
    SIMD_ALIGNED double re[LANES], im[LANES];
    double c_re[LANES], c_im[LANES], least[LANES];
    int64_t steps[LANES], live[LANES];   /* that did not escape; all bits or none */
    double past_re[LANES], past_im[LANES];   /* of squares: an earlier place of each, and its steps until there */
    int64_t past[LANES];
    int64_t limit;
    int64_t lead;                /* of squares: so many steps come before the strides, so that none goes beyond the limit; else -1 */
    int stride;                  /* of squares */
    uint32_t strides, point[LANES], count;
} sequences;

/* The start counts among the smallest, but for the 0 that a magnet's mandel begins with. */
static void begin(const fractal *f, sequences *s, uint32_t l, double x, double y)
{
    const bool has_c = f->julia_limit > 0, from_zero = f->kind != 0 && !has_c;
    const complex_number z = from_zero ? complex_of(0.0, 0.0) : complex_of(x, y);

    s->re[l] = z.re;
    s->im[l] = z.im;
    s->c_re[l] = has_c ? f->c[0] : x;
    s->c_im[l] = has_c ? f->c[1] : y;
    s->least[l] = from_zero ? HUGE_VAL : square_of(z);
    s->steps[l] = s->past[l] = 0;
    s->past_re[l] = s->past_im[l] = HUGE_VAL;
    s->live[l] = s->limit > 0 ? -1 : 0;
}

static inline complex_number at_of(const sequences *s, uint32_t l) { return complex_of(s->re[l], s->im[l]); }
static inline complex_number c_of(const sequences *s, uint32_t l) { return complex_of(s->c_re[l], s->c_im[l]); }

static inline void advance(sequences *s, uint32_t l, complex_number next, bool escapes)
{
    const int64_t live = s->live[l], stays = live & ~-(int64_t)escapes;
    const double square = square_of(next), least = square < s->least[l] ? square : s->least[l];

    s->re[l] = live ? next.re : s->re[l];
    s->im[l] = live ? next.im : s->im[l];
    s->least[l] = stays ? least : s->least[l];
    s->steps[l] -= stays;
    s->live[l] = s->steps[l] < s->limit ? stays : 0;
}

/* A stride of squares of 8 sequences, whose numbers stay in registers. One that escapes goes on to its end: the number of its steps
 * is known, and what is least of it does not count; its place stays where the stride began. */
SIMD_CLONES static void square_stride(int stride, double *restrict at_re, double *restrict at_im, const double *restrict c_re,
                                      const double *restrict c_im, double *restrict at_least, int64_t *restrict at_steps,
                                      int64_t *restrict at_live)
{
    SIMD_ALIGNED double re[GROUP], im[GROUP], re_re[GROUP], im_im[GROUP], least[GROUP];
    SIMD_ALIGNED int64_t steps[GROUP], live[GROUP];

    SIMD_LOOP
    for (uint32_t l = 0; l < GROUP; l++) {
        re[l] = at_re[l];
        im[l] = at_im[l];
        re_re[l] = re[l] * re[l];
        im_im[l] = im[l] * im[l];
        least[l] = at_least[l];
        steps[l] = at_steps[l];
        live[l] = at_live[l];
    }
    for (int k = 0; k < stride; k++)
        SIMD_LOOP
        for (uint32_t l = 0; l < GROUP; l++) {
            const double both = re[l] * im[l], next = re_re[l] - im_im[l] + c_re[l];
            double square;

            im[l] = both + both + c_im[l];
            re[l] = next;
            re_re[l] = re[l] * re[l];
            im_im[l] = im[l] * im[l];
            square = re_re[l] + im_im[l];
            least[l] = square < least[l] ? square : least[l];
            live[l] &= square > 4.0 ? 0 : -1;
            steps[l] -= live[l];
        }
    SIMD_LOOP
    for (uint32_t l = 0; l < GROUP; l++) {
        at_re[l] = live[l] ? re[l] : at_re[l];
        at_im[l] = live[l] ? im[l] : at_im[l];
        at_least[l] = at_live[l] ? least[l] : at_least[l];
        at_steps[l] = steps[l];
        at_live[l] = live[l];
    }
}

/* Which are back at the very numbers of an earlier place? Such places are those after 2^n strides, as of Brent (1980). */
static bool find_rounds(sequences *s, uint32_t n, int64_t *restrict back)
{
    int64_t any = 0;

    for (uint32_t l = 0; l < n; l++) {
        const bool renews = s->steps[l] >= 2 * s->past[l];

        back[l] = ((s->re[l] == s->past_re[l]) & (s->im[l] == s->past_im[l])) ? s->live[l] : 0;
        any |= back[l];
        s->past_re[l] = renews ? s->re[l] : s->past_re[l];
        s->past_im[l] = renews ? s->im[l] : s->past_im[l];
        s->past[l] = renews & ~back[l] ? s->steps[l] : s->past[l];
    }
    return any != 0;
}

/* A sequence that is back goes round for ever. What is new is only where it is in the end, so whole rounds are left out. */
static void leave_rounds_out(sequences *s, const int64_t *back)
{
    for (uint32_t l = 0; l < s->count; l++)
        if (back[l]) {
            s->steps[l] = s->limit - (s->limit - s->steps[l]) % (s->steps[l] - s->past[l]);
            s->past[l] = s->limit;
            s->past_re[l] = HUGE_VAL;
            s->live[l] = s->steps[l] < s->limit ? -1 : 0;
        }
}

static void square_steps(sequences *s)
{
    SIMD_ALIGNED int64_t back[LANES];

    for (uint32_t l = 0; l < s->count; l += GROUP)
        square_stride(s->stride, s->re + l, s->im + l, s->c_re + l, s->c_im + l, s->least + l, s->steps + l, s->live + l);
    for (uint32_t l = 0; l < s->count; l++)
        s->live[l] &= s->steps[l] < s->limit ? -1 : 0;
    if (++s->strides % LOOK_BACK == 0 && find_rounds(s, lanes_whole(s->count), back))
        leave_rounds_out(s, back);
}

static void power_steps(const fractal *f, sequences *s, uint32_t n)
{
    double re[LANES], im[LANES];

    for (uint32_t l = 0; l < n; l++) {
        re[l] = s->re[l];
        im[l] = s->im[l];
    }
    for (int32_t k = 1; k < f->exponent; k++)
        for (uint32_t l = 0; l < n; l++) {
            const complex_number power = times(complex_of(re[l], im[l]), at_of(s, l));

            re[l] = power.re;
            im[l] = power.im;
        }
    for (uint32_t l = 0; l < n; l++) {
        const complex_number next = add(complex_of(re[l], im[l]), c_of(s, l));

        advance(s, l, next, has_escaped(next));
    }
}

static void magnet_steps1(sequences *s, uint32_t n)
{
    for (uint32_t l = 0; l < n; l++) {
        const complex_number next = magnet_step1(at_of(s, l), c_of(s, l));

        advance(s, l, next, is_fixed(next));
    }
}

static void magnet_steps2(sequences *s, uint32_t n)
{
    for (uint32_t l = 0; l < n; l++) {
        const complex_number next = magnet_step2(at_of(s, l), c_of(s, l));

        advance(s, l, next, is_fixed(next));
    }
}

static void take_steps(const fractal *f, sequences *s)
{
    const uint32_t n = lanes_whole(s->count);

    if (f->kind == 0)
        power_steps(f, s, n);
    else if (f->kind == 1)
        magnet_steps1(s, n);
    else
        magnet_steps2(s, n);
}

/* One sequence by itself, until it has taken so many steps. */
static void go_alone(const fractal *f, sequences *s, uint32_t l, int64_t until)
{
    const complex_number c = c_of(s, l);
    complex_number z = at_of(s, l);
    double least = s->least[l];
    int64_t k = s->steps[l];
    bool escaped = !s->live[l];

    for (; !escaped && k < until; k += !escaped) {
        z = step(f, z, c);
        escaped = f->kind == 0 ? has_escaped(z) : is_fixed(z);
        least = !escaped && square_of(z) < least ? square_of(z) : least;
    }
    s->re[l] = z.re;
    s->im[l] = z.im;
    s->least[l] = least;
    s->steps[l] = k;
    s->live[l] = !escaped && k < s->limit ? -1 : 0;
}

static void move_lane(sequences *s, uint32_t from, uint32_t to)
{
    s->re[to] = s->re[from];
    s->im[to] = s->im[from];
    s->c_re[to] = s->c_re[from];
    s->c_im[to] = s->c_im[from];
    s->least[to] = s->least[from];
    s->steps[to] = s->steps[from];
    s->live[to] = s->live[from];
    s->past[to] = s->past[from];
    s->past_re[to] = s->past_re[from];
    s->past_im[to] = s->past_im[from];
    s->point[to] = s->point[from];
}

/* Where a sequence of squares escaped, from where its last stride began. */
static complex_number find_escape(const sequences *s, uint32_t l)
{
    complex_number z = at_of(s, l);

    for (int64_t k = (s->steps[l] - s->lead) % s->stride; k >= 0; k--)
        z = square_step(z, c_of(s, l));
    return z;
}

static double value_of(const fractal *f, const sequences *s, uint32_t l)
{
    const bool is_placed = s->lead < 0 || s->steps[l] < s->lead || f->exterior < 2 || f->exterior > 6;

    if (s->steps[l] >= s->limit)
        return inside_value(f, at_of(s, l), s->least[l]);
    return outside_value(f, is_placed ? at_of(s, l) : find_escape(s, l), (int32_t)s->steps[l], (int32_t)s->limit);
}

static void evaluate(const pattern_input *in, double *value)
{
    const fractal *f = in->of->self;
    sequences s = { .limit = f->julia_limit > 0 ? f->julia_limit : f->limit };

    s.stride = s.limit % 10 == 0 ? 10 : STRIDE;   /* most limits are round numbers */
    s.lead = f->kind == 0 && f->exponent == 2 && s.limit > 0 ? s.limit % s.stride : -1;
    for (uint32_t next = 0; next < in->n || s.count > 0;) {
        for (; s.count < LANES && next < in->n; next++, s.count++) {
            s.point[s.count] = next;
            begin(f, &s, s.count, in->at->x[next], in->at->y[next]);
            if (s.lead > 0)
                go_alone(f, &s, s.count, s.lead);
        }
        if (s.count == 1 && s.lead < 0)
            go_alone(f, &s, 0, s.limit);
        if (s.lead >= 0)
            square_steps(&s);
        for (int k = 0; s.lead < 0 && s.count > 1 && k < STRIDE; k++)
            take_steps(f, &s);
        for (uint32_t l = s.count; l-- > 0;)
            if (!s.live[l]) {
                value[s.point[l]] = value_of(f, &s, l);
                if (l < --s.count)
                    move_lane(&s, s.count, l);
            }
    }
}

static const char *check(const void *self)
{
    const fractal *f = self;

    if (f->exponent < 2 || f->exponent > 33)
        return "the exponent must lie in 2 to 33";
    if (f->interior < 0 || f->interior > 6 || f->exterior < 0 || f->exterior > 8)
        return "types of interior are 0 to 6, of exterior 0 to 8";
    if (f->exterior > 6 && period_of(f) == 0.0)
        return "the factor of exterior 7 must be 1 at least, that of 8 must not be -1";
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
