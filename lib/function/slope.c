#include "function/slope.h"

#include "base/elementary.h"
#include "function/internal.h"

enum { LANES = POV_SLOPES };

SIMD_INLINE double lesser(double a, double b) { return b < a ? b : a; }
SIMD_INLINE double greater(double a, double b) { return b > a ? b : a; }

/* ---- functions of one argument ---- */

typedef struct tangent { double value, slope; } tangent;

SIMD_INLINE tangent tangent_of(double value, double slope)
{
    const tangent t = { value, slope };

    return t;
}

SIMD_INLINE tangent tangent_abs(double a, double k) { (void)k; return tangent_of(fabs(a), a < 0.0 ? -1.0 : 1.0); }
SIMD_INLINE tangent tangent_sqrt(double a, double k) { (void)k; return tangent_of(sqrt(a), 0.5 / sqrt(a)); }
SIMD_INLINE tangent tangent_sin(double a, double k) { (void)k; return tangent_of(elementary_sin(a), elementary_cos(a)); }
SIMD_INLINE tangent tangent_cos(double a, double k) { (void)k; return tangent_of(elementary_cos(a), -elementary_sin(a)); }
SIMD_INLINE tangent tangent_exp(double a, double k)
{
    const double value = elementary_exp(a);

    (void)k;
    return tangent_of(value, value);
}
SIMD_INLINE tangent tangent_ln(double a, double k) { (void)k; return tangent_of(elementary_log(a), 1.0 / a); }
SIMD_INLINE tangent tangent_asin(double a, double k) { (void)k; return tangent_of(elementary_asin(a), 1.0 / sqrt((1.0 - a) * (1.0 + a))); }
SIMD_INLINE tangent tangent_atan(double a, double k) { (void)k; return tangent_of(elementary_atan(a), 1.0 / (1.0 + a * a)); }
SIMD_INLINE tangent tangent_asinh(double a, double k)
{
    const double size = fabs(a), root = sqrt(size * size + 1.0);

    (void)k;
    return tangent_of(copysign(elementary_log(size + root), a), 1.0 / root);
}
SIMD_INLINE tangent tangent_power(double a, double k)
{
    const double value = elementary_pow(a, k);

    return tangent_of(value, a == 0.0 ? 0.0 : k * value / a);
}
SIMD_INLINE tangent tangent_floor(double a, double k) { (void)k; return tangent_of(floor(a), 0.0); }
SIMD_INLINE tangent tangent_ceil(double a, double k) { (void)k; return tangent_of(ceil(a), 0.0); }
SIMD_INLINE tangent tangent_cut(double a, double k)
{
    (void)k;
    return tangent_of(a > -2147483649.0 && a < 2147483648.0 ? (double)(int32_t)a : -2147483648.0, 0.0);
}

SIMD_INLINE void apply(const pov_slope *a, double k, tangent (*of)(double at, double k), pov_slope *restrict to)
{
    for (int l = 0; l < LANES; l++) {
        const tangent t = of(a->value[l], k);

        to->value[l] = t.value;
        to->slope[l] = a->slope[l] == 0.0 ? 0.0 : t.slope * a->slope[l];   /* however steep a root is at 0 */
    }
}

#define APPLY(name) \
    static void slope_##name(const pov_slope *a, double k, pov_slope *restrict to) { apply(a, k, tangent_##name, to); }
APPLY(abs)
APPLY(sqrt)
APPLY(sin)
APPLY(cos)
APPLY(exp)
APPLY(ln)
APPLY(asin)
APPLY(atan)
APPLY(asinh)
APPLY(power)
APPLY(floor)
APPLY(ceil)
APPLY(cut)

/* ---- functions of two ---- */

SIMD_INLINE void pair(tape_op op, const pov_slope *a, const pov_slope *b, pov_slope *restrict to)
{
    for (int l = 0; l < LANES; l++) {
        const double av = a->value[l], bv = b->value[l], as = a->slope[l], bs = b->slope[l];
        double value, slope = 0.0;

        switch (op) {
        case TAPE_ADD: value = av + bv; slope = as + bs; break;
        case TAPE_SUBTRACT: value = av - bv; slope = as - bs; break;
        case TAPE_MULTIPLY: value = av * bv; slope = av * bs + bv * as; break;
        case TAPE_DIVIDE: value = av / bv; slope = (as - value * bs) / bv; break;
        case TAPE_MIN: value = lesser(av, bv); slope = bv < av ? bs : as; break;
        case TAPE_MAX: value = greater(av, bv); slope = bv > av ? bs : as; break;
        case TAPE_MOD: value = fmod(av, bv); slope = as - bs * ((av - value) / bv); break;
        case TAPE_ATAN2: value = elementary_atan2(av, bv); slope = (bv * as - av * bs) / (av * av + bv * bv); break;
        case TAPE_LESS: value = av < bv; break;
        case TAPE_AT_MOST: value = av <= bv; break;
        case TAPE_EQUAL: value = av == bv; break;
        case TAPE_AND: value = av != 0.0 && bv != 0.0; break;
        default: value = av != 0.0 || bv != 0.0; break;
        }
        to->value[l] = value;
        to->slope[l] = slope;
    }
}

static void add(const pov_slope *a, const pov_slope *b, pov_slope *to) { pair(TAPE_ADD, a, b, to); }
static void subtract(const pov_slope *a, const pov_slope *b, pov_slope *to) { pair(TAPE_SUBTRACT, a, b, to); }
static void multiply(const pov_slope *a, const pov_slope *b, pov_slope *to) { pair(TAPE_MULTIPLY, a, b, to); }
static void divide(const pov_slope *a, const pov_slope *b, pov_slope *to) { pair(TAPE_DIVIDE, a, b, to); }
static void least(const pov_slope *a, const pov_slope *b, pov_slope *to) { pair(TAPE_MIN, a, b, to); }
static void largest(const pov_slope *a, const pov_slope *b, pov_slope *to) { pair(TAPE_MAX, a, b, to); }
static void angle(const pov_slope *a, const pov_slope *b, pov_slope *to) { pair(TAPE_ATAN2, a, b, to); }
static void rest_of(const pov_slope *a, const pov_slope *b, pov_slope *to) { pair(TAPE_MOD, a, b, to); }
static void compare(tape_op op, const pov_slope *a, const pov_slope *b, pov_slope *to)
{
    switch (op) {
    case TAPE_LESS: pair(TAPE_LESS, a, b, to); break;
    case TAPE_AT_MOST: pair(TAPE_AT_MOST, a, b, to); break;
    case TAPE_EQUAL: pair(TAPE_EQUAL, a, b, to); break;
    case TAPE_AND: pair(TAPE_AND, a, b, to); break;
    default: pair(TAPE_OR, a, b, to); break;
    }
}

static void linear(const pov_slope *a, double factor, double k, pov_slope *restrict to)
{
    for (int l = 0; l < LANES; l++) {
        to->value[l] = a->value[l] * factor + k;
        to->slope[l] = a->slope[l] * factor;
    }
}

static void choose(tape_op op, const pov_slope *a, const pov_slope *b, const pov_slope *c, pov_slope *restrict to)
{
    for (int l = 0; l < LANES; l++) {
        const int first = op == TAPE_BELOW ? a->value[l] < 0.0 : a->value[l] == 0.0;

        to->value[l] = first ? b->value[l] : c->value[l];
        to->slope[l] = first ? b->slope[l] : c->slope[l];
    }
}

static void hexagon(tape_op op, const pov_slope *x, const pov_slope *y, pov_slope *restrict to)
{
    for (int l = 0; l < LANES; l++) {
        internal_hex h;

        internal_hexagon(x->value[l], y->value[l], &h);
        to->value[l] = op == TAPE_HEX_ALONG ? h.along : h.across;
        to->slope[l] = op == TAPE_HEX_ALONG ? h.x * x->slope[l] + h.y * y->slope[l] : h.side * (h.x * y->slope[l] - h.y * x->slope[l]);
    }
}

/* ---- running ---- */

void slope_run(const tape *t, pov_slope *r)
{
    for (const tape_step *s = t->steps, *const end = s + t->count; s < end; s++) {
        const pov_slope *a = &r[s->a], *b = &r[s->b];
        pov_slope *to = &r[s->to];

        switch ((tape_op)s->op) {
        case TAPE_CONSTANT: linear(a, 0.0, s->k, to); break;
        case TAPE_ADD: add(a, b, to); break;
        case TAPE_SUBTRACT: subtract(a, b, to); break;
        case TAPE_MULTIPLY: multiply(a, b, to); break;
        case TAPE_DIVIDE: divide(a, b, to); break;
        case TAPE_OFFSET: linear(a, 1.0, s->k, to); break;
        case TAPE_SCALE: linear(a, s->k, 0.0, to); break;
        case TAPE_ABS: slope_abs(a, s->k, to); break;
        case TAPE_MIN: least(a, b, to); break;
        case TAPE_MAX: largest(a, b, to); break;
        case TAPE_MOD: rest_of(a, b, to); break;
        case TAPE_SQRT: slope_sqrt(a, s->k, to); break;
        case TAPE_POWER: slope_power(a, s->k, to); break;
        case TAPE_SIN: slope_sin(a, s->k, to); break;
        case TAPE_COS: slope_cos(a, s->k, to); break;
        case TAPE_EXP: slope_exp(a, s->k, to); break;
        case TAPE_LN: slope_ln(a, s->k, to); break;
        case TAPE_ASIN: slope_asin(a, s->k, to); break;
        case TAPE_ATAN: slope_atan(a, s->k, to); break;
        case TAPE_ASINH: slope_asinh(a, s->k, to); break;
        case TAPE_ATAN2: angle(a, b, to); break;
        case TAPE_FLOOR: slope_floor(a, s->k, to); break;
        case TAPE_CEIL: slope_ceil(a, s->k, to); break;
        case TAPE_CUT: slope_cut(a, s->k, to); break;
        case TAPE_LESS: case TAPE_AT_MOST: case TAPE_EQUAL: case TAPE_AND: case TAPE_OR: compare((tape_op)s->op, a, b, to); break;
        case TAPE_BELOW: case TAPE_ZERO: choose((tape_op)s->op, a, b, &r[s->c], to); break;
        case TAPE_HEX_ALONG: case TAPE_HEX_ACROSS: hexagon((tape_op)s->op, a, b, to); break;
        }
    }
}
