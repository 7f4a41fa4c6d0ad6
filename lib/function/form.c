#include "function/form.h"

#include "base/elementary.h"
#include "function/internal.h"

enum { LANES = POV_FORMS };

/* Roundings of a step: so much of its terms; and of the bounds themselves, which are sums of a few positive numbers. TINY
 * covers products below the normal numbers. */
#define ROUNDING 0x1p-51
#define WIDER (1.0 + 0x1p-48)
#define TINY 0x1p-940

SIMD_INLINE double greater(double a, double b) { return a > b ? a : b; }
SIMD_INLINE double lesser(double a, double b) { return a < b ? a : b; }

/* The same, unknown if one of them is: comparisons alone would lose that. */
SIMD_INLINE double greater_known(double a, double b) { return greater(a, b) + 0.0 * (a + b); }
SIMD_INLINE double lesser_known(double a, double b) { return lesser(a, b) + 0.0 * (a + b); }

/* How far a value may be from the middle. */
SIMD_INLINE double reach(const pov_form *f, int l) { return fabs(f->slope[l]) + f->off[l]; }

/* ---- sums and products ---- */

static void constant(double k, pov_form *restrict to)
{
    for (int l = 0; l < LANES; l++) {
        to->middle[l] = k;
        to->slope[l] = to->off[l] = to->slope_off[l] = 0.0;
    }
}

SIMD_INLINE void sum(const pov_form *a, const pov_form *b, double sign, pov_form *restrict to)
{
    for (int l = 0; l < LANES; l++) {
        const double middle = a->middle[l] + sign * b->middle[l], slope = a->slope[l] + sign * b->slope[l];

        to->middle[l] = middle;
        to->slope[l] = slope;
        to->off[l] = (a->off[l] + b->off[l] + ROUNDING * (fabs(middle) + fabs(slope))) * WIDER;
        to->slope_off[l] = (a->slope_off[l] + b->slope_off[l] + ROUNDING * fabs(slope)) * WIDER;
    }
}

static void add(const pov_form *a, const pov_form *b, pov_form *restrict to) { sum(a, b, 1.0, to); }
static void subtract(const pov_form *a, const pov_form *b, pov_form *restrict to) { sum(a, b, -1.0, to); }

static void offset(const pov_form *a, double k, pov_form *restrict to)
{
    for (int l = 0; l < LANES; l++) {
        const double middle = a->middle[l] + k;

        to->middle[l] = middle;
        to->slope[l] = a->slope[l];
        to->off[l] = (a->off[l] + ROUNDING * fabs(middle)) * WIDER;
        to->slope_off[l] = a->slope_off[l];
    }
}

static void scale(const pov_form *a, double k, pov_form *restrict to)
{
    const double size = fabs(k);

    for (int l = 0; l < LANES; l++) {
        const double middle = a->middle[l] * k, slope = a->slope[l] * k;

        to->middle[l] = middle;
        to->slope[l] = slope;
        to->off[l] = (a->off[l] * size + ROUNDING * (fabs(middle) + fabs(slope) + TINY)) * WIDER;
        to->slope_off[l] = (a->slope_off[l] * size + ROUNDING * (fabs(slope) + TINY)) * WIDER;
    }
}

/* (a + a' u)(b + b' u): the square of u is 1/2, off by at most 1/2. */
static void multiply(const pov_form *a, const pov_form *b, pov_form *restrict to)
{
    for (int l = 0; l < LANES; l++) {
        const double am = a->middle[l], bm = b->middle[l], as = a->slope[l], bs = b->slope[l];
        const double a_reach = reach(a, l), b_reach = reach(b, l), a_size = fabs(am), b_size = fabs(bm);
        const double square = as * bs, cross = fabs(am * bs) + fabs(bm * as), product = am * bm;

        to->middle[l] = product + 0.5 * square;
        to->slope[l] = am * bs + bm * as;
        to->off[l] = (0.5 * fabs(square) + a->off[l] * (b_size + b_reach) + b->off[l] * (a_size + fabs(as)) +
                      ROUNDING * (fabs(product) + fabs(square) + cross + TINY)) * WIDER;
        to->slope_off[l] = (fabs(as) * b_reach + fabs(bs) * a_reach + a->slope_off[l] * (b_size + b_reach) + b->slope_off[l] * (a_size + a_reach) +
                       ROUNDING * (cross + TINY)) * WIDER;
    }
}

/* ---- functions of one argument ---- */

/* Around a point: value, derivative, a bound of the second derivative, all for values within reach; and what the values and
 * the derivative are within anyway. */
typedef struct curve { double value, first, second, lo, hi, steepest; } curve;

/* Taylor's form, or where it is twice as wide the range of the values, which knows no slope. */
SIMD_INLINE void compose(const pov_form *a, double k, int is_positive, curve (*of)(double at, double reach, double k, int is_positive),
                      pov_form *restrict to)
{
    for (int l = 0; l < LANES; l++) {
        const double as = a->slope[l], r = (reach(a, l) + ROUNDING * fabs(a->middle[l])) * WIDER;
        const curve c = of(a->middle[l], r, k, is_positive);
        const double slope = c.first * as, wide = c.second * r, size = fabs(c.first);
        const double rounding = 4.0 * ROUNDING * (fabs(slope) + TINY);
        const double off = (size * a->off[l] + 0.5 * wide * r + rounding + 4.0 * ROUNDING * fabs(c.value)) * WIDER;
        const double half = 0.5 * (c.hi - c.lo), middle = c.lo + half;
        const int is_taylor = fabs(slope) + off <= 2.0 * half;
        const double turned = lesser(size + wide, c.steepest);

        to->middle[l] = is_taylor ? c.value : middle;
        to->slope[l] = is_taylor ? slope : 0.0;
        to->off[l] = is_taylor ? off : half + 4.0 * ROUNDING * (fabs(c.lo) + fabs(c.hi) + TINY);
        to->slope_off[l] = is_taylor ? (turned * a->slope_off[l] + wide * fabs(as) + rounding) * WIDER
                                : (c.steepest * (fabs(as) + a->slope_off[l]) + 4.0 * ROUNDING * TINY) * WIDER;
    }
}

SIMD_INLINE curve no_curve(void)
{
    const curve c = { 0.0, 0.0, HUGE_VAL, -HUGE_VAL, HUGE_VAL, HUGE_VAL };

    return c;
}

/* The second derivative is the value itself. */
SIMD_INLINE curve curve_wave(double value, double first, double reach)
{
    const double second = fabs(value) + reach;
    const curve c = { value, first, second < 1.0 ? second : 1.0, -1.0, 1.0, 1.0 };

    return c;
}

SIMD_INLINE curve curve_sin(double at, double reach, double k, int is_positive)
{
    (void)k;
    (void)is_positive;
    return curve_wave(elementary_sin(at), elementary_cos(at), reach);
}

SIMD_INLINE curve curve_cos(double at, double reach, double k, int is_positive)
{
    (void)k;
    (void)is_positive;
    return curve_wave(elementary_cos(at), -elementary_sin(at), reach);
}

SIMD_INLINE curve curve_exp(double at, double reach, double k, int is_positive)
{
    const double value = elementary_exp(at), most = elementary_exp(at + reach) * WIDER;
    const curve c = { value, value, most, 0.0, most, most };

    (void)k;
    (void)is_positive;
    return c;
}

SIMD_INLINE curve curve_ln(double at, double reach, double k, int is_positive)
{
    const double lo = at - reach;
    curve c = no_curve();

    (void)k;
    (void)is_positive;
    c.value = elementary_log(at);
    c.first = 1.0 / at;
    c.second = lo > 0.0 ? WIDER / (lo * lo) : HUGE_VAL;
    c.steepest = lo > 0.0 ? WIDER / lo : HUGE_VAL;
    return c;
}

/* Where the root itself stays below 2^-400, as of the sum of squares that are all 0 there, no double shows its slope. */
SIMD_INLINE curve curve_sqrt(double at, double reach, double k, int is_positive)
{
    const double lo = at - reach, root = sqrt(at), low = sqrt(greater(lo, 0.0));
    curve c;

    (void)k;
    c.value = root;
    c.first = 0.5 / root;
    c.steepest = at + reach < 0x1p-800 ? 0.0 : lo > 0.0 ? 0.5 * WIDER / low : HUGE_VAL;
    c.second = lo > 0.0 ? 0.25 * WIDER / (lo * low) : HUGE_VAL;
    c.lo = lo >= 0.0 || is_positive ? low : -HUGE_VAL;
    c.hi = sqrt(at + reach);
    return c;
}

/* a^k of a >= 0, its range and its derivatives monotonous. */
SIMD_INLINE curve curve_power(double at, double reach, double k, int is_positive)
{
    const double lo = greater(at - reach, 0.0), hi = at + reach, least = elementary_pow(lo, k), most = elementary_pow(hi, k);
    const double second = k >= 2.0 ? most / (hi * hi) : least / (lo * lo), first = k >= 1.0 ? most / hi : least / lo;
    const int is_known = (at >= reach || is_positive) && k > 0.0;
    curve c;

    c.value = elementary_pow(at, k);
    c.first = k * c.value / at;
    c.second = fabs(k * (k - 1.0)) * second * WIDER;
    c.steepest = fabs(k) * first * WIDER;
    c.lo = is_known ? least * (2.0 - WIDER) : at > reach ? most * (2.0 - WIDER) : -HUGE_VAL;
    c.hi = is_known ? most * WIDER : at > reach ? least * WIDER : HUGE_VAL;
    return c;
}

SIMD_INLINE curve curve_asin(double at, double reach, double k, int is_positive)
{
    const double most = fabs(at) + reach, rest = (1.0 - most) * (1.0 + most), quarter = 1.5707963267948968;
    curve c = no_curve();

    (void)k;
    (void)is_positive;
    c.value = elementary_asin(at);
    c.first = 1.0 / sqrt((1.0 - at) * (1.0 + at));
    c.steepest = rest > 0.0 ? WIDER / sqrt(rest) : HUGE_VAL;
    c.second = rest > 0.0 ? most * WIDER / (rest * sqrt(rest)) : HUGE_VAL;
    c.lo = most <= 1.0 ? -quarter : -HUGE_VAL;
    c.hi = most <= 1.0 ? quarter : HUGE_VAL;
    return c;
}

SIMD_INLINE curve curve_atan(double at, double reach, double k, int is_positive)
{
    const curve c = { elementary_atan(at), 1.0 / (1.0 + at * at), 0.65, -1.5707963267948968, 1.5707963267948968, 1.0 };

    (void)reach;
    (void)k;
    (void)is_positive;
    return c;
}

SIMD_INLINE curve curve_asinh(double at, double reach, double k, int is_positive)
{
    const double size = fabs(at), root = sqrt(size * size + 1.0);
    curve c = no_curve();

    (void)reach;
    (void)k;
    (void)is_positive;
    c.value = copysign(elementary_log(size + root), at);
    c.first = 1.0 / root;
    c.second = 0.39;
    c.steepest = 1.0;
    return c;
}

SIMD_INLINE curve curve_inverse(double at, double reach, double k, int is_positive)
{
    const double lo = fabs(at) - reach, value = 1.0 / at;
    curve c = no_curve();

    (void)k;
    (void)is_positive;
    c.value = value;
    c.first = -value * value;
    c.steepest = lo > 0.0 ? WIDER / (lo * lo) : HUGE_VAL;
    c.second = lo > 0.0 ? 2.0 * WIDER / (lo * lo * lo) : HUGE_VAL;
    return c;
}

#define COMPOSE(name) \
    static void form_##name(const pov_form *a, double k, int is_positive, pov_form *restrict to) \
    { \
        compose(a, k, is_positive, curve_##name, to); \
    }
COMPOSE(sin)
COMPOSE(cos)
COMPOSE(exp)
COMPOSE(ln)
COMPOSE(sqrt)
COMPOSE(power)
COMPOSE(asin)
COMPOSE(atan)
COMPOSE(asinh)
COMPOSE(inverse)

static void divide(const pov_form *a, const pov_form *b, pov_form *restrict to)
{
    pov_form inverse;

    form_inverse(b, 0.0, 0, &inverse);
    multiply(a, &inverse, to);
}

/* ---- angles ---- */

/* The second derivative of an angle is below the inverse square of the distance. Where the axis is crossed at which the
 * angle jumps, it may be any. */
static void angle(const pov_form *y, const pov_form *x, pov_form *restrict to)
{
    const double half_turn = 3.1415926535897936;

    for (int l = 0; l < LANES; l++) {
        const double ym = y->middle[l], xm = x->middle[l], ys = y->slope[l], xs = x->slope[l], y_reach = reach(y, l), x_reach = reach(x, l);
        const double dx = greater(fabs(xm) - x_reach, 0.0), dy = greater(fabs(ym) - y_reach, 0.0), near = dx * dx + dy * dy;
        const double square = xm * xm + ym * ym, to_y = xm / square, to_x = -ym / square, ahead = y_reach * y_reach + x_reach * x_reach;
        const int is_known = near > 0.0 && (xm - x_reach > 0.0 || fabs(ym) - y_reach > 0.0);
        const double middle = elementary_atan2(ym, xm), slope = to_y * ys + to_x * xs;
        const double rounding = 4.0 * ROUNDING * (fabs(to_y * ys) + fabs(to_x * xs) + TINY);
        const double off = fabs(to_y) * y->off[l] + fabs(to_x) * x->off[l] + 0.5 * WIDER * ahead / near + rounding + 4.0 * ROUNDING * fabs(middle);
        const double y_most = fabs(ys) + y->slope_off[l], x_most = fabs(xs) + x->slope_off[l];
        const double turned = sqrt(ahead * (y_most * y_most + x_most * x_most)) * WIDER / near;

        to->middle[l] = is_known ? middle : 0.0;
        to->slope[l] = is_known ? slope : 0.0;
        to->off[l] = is_known ? off * WIDER : half_turn;
        to->slope_off[l] = is_known ? (turned + fabs(to_y) * y->slope_off[l] + fabs(to_x) * x->slope_off[l] + rounding) * WIDER : HUGE_VAL;
    }
}

/* ---- functions with edges ---- */

/* a chord over the edge: max(d, 0) is w d, and up to `gap` above, where d changes its sign. */
typedef struct edge { double weight, gap; } edge;

SIMD_INLINE edge edge_of(double lo, double hi)
{
    const int up = lo >= 0.0, down = hi <= 0.0;
    const double weight = hi / (hi - lo);
    edge e;

    e.weight = up ? 1.0 : down ? 0.0 : weight;
    e.gap = up || down ? 0.0 : -weight * lo;
    return e;
}

static void size_of(const pov_form *a, pov_form *restrict to)
{
    for (int l = 0; l < LANES; l++) {
        const double middle = a->middle[l], slope = a->slope[l], r = (reach(a, l) + ROUNDING * fabs(middle)) * WIDER;
        const edge e = edge_of(middle - r, middle + r);
        const double weight = 2.0 * e.weight - 1.0, turned = (1.0 - fabs(weight)) * fabs(slope);
        const double rounding = e.gap > 0.0 ? 4.0 * ROUNDING * fabs(slope) : 0.0;

        to->middle[l] = weight * middle + e.gap;
        to->slope[l] = weight * slope;
        to->off[l] = (fabs(weight) * a->off[l] + e.gap + (e.gap > 0.0 ? 4.0 * ROUNDING * (fabs(middle) + fabs(slope)) : 0.0)) * WIDER;
        to->slope_off[l] = (a->slope_off[l] + turned + rounding + (e.gap > 0.0 ? 2.0 * fabs(weight) * fabs(slope) : 0.0)) * WIDER;
    }
}

/* max(a, b) = b + max(a - b, 0), min(a, b) = a - max(a - b, 0). */
SIMD_INLINE void extreme(const pov_form *a, const pov_form *b, double sign, pov_form *restrict to)
{
    for (int l = 0; l < LANES; l++) {
        const double am = a->middle[l], bm = b->middle[l], as = a->slope[l], bs = b->slope[l];
        const double middle = am - bm, slope = as - bs;
        const double r = (fabs(slope) + a->off[l] + b->off[l] + ROUNDING * (fabs(am) + fabs(bm) + fabs(as) + fabs(bs))) * WIDER;
        const edge e = edge_of(sign * middle - r, sign * middle + r);
        const int is_a = e.weight == 1.0 && e.gap == 0.0, is_b = e.weight == 0.0 && e.gap == 0.0;
        const double w = e.weight, v = 1.0 - w, s = w * as + v * bs;
        const double rounding = 4.0 * ROUNDING * (fabs(as) + fabs(bs));
        const double a_slope_off = fabs(as - s) + a->slope_off[l], b_slope_off = fabs(bs - s) + b->slope_off[l];

        to->middle[l] = is_a ? am : is_b ? bm : w * am + v * bm + sign * 0.5 * e.gap;
        to->slope[l] = is_a ? as : is_b ? bs : s;
        to->off[l] = is_a ? a->off[l] : is_b ? b->off[l] : (w * a->off[l] + v * b->off[l] + 0.5 * e.gap + rounding + 4.0 * ROUNDING * (fabs(am) + fabs(bm))) * WIDER;
        to->slope_off[l] = is_a ? a->slope_off[l] : is_b ? b->slope_off[l] : (greater_known(a_slope_off, b_slope_off) + rounding) * WIDER;
    }
}

static void largest(const pov_form *a, const pov_form *b, pov_form *restrict to) { extreme(a, b, 1.0, to); }
static void least(const pov_form *a, const pov_form *b, pov_form *restrict to) { extreme(a, b, -1.0, to); }

/* Between lo and hi, jumping where they differ. */
SIMD_INLINE void between(double lo, double hi, int l, pov_form *to)
{
    to->middle[l] = 0.5 * (lo + hi);
    to->slope[l] = 0.0;
    to->off[l] = 0.5 * (hi - lo);
    to->slope_off[l] = lo == hi ? 0.0 : HUGE_VAL;
}

static double cut(double a) { return a > -2147483649.0 && a < 2147483648.0 ? (double)(int32_t)a : -2147483648.0; }
static double rounded(tape_op op, double a) { return op == TAPE_FLOOR ? floor(a) : op == TAPE_CEIL ? ceil(a) : cut(a); }

static void whole(tape_op op, const pov_form *a, pov_form *restrict to)
{
    for (int l = 0; l < LANES; l++) {
        const double r = reach(a, l) * WIDER, lo = rounded(op, a->middle[l] - r), hi = rounded(op, a->middle[l] + r);
        const int is_far = op == TAPE_CUT && !(fabs(a->middle[l]) + r < 2147483000.0);

        between(is_far ? -HUGE_VAL : lo, is_far ? HUGE_VAL : hi, l, to);
    }
}

/* a - b cut(a / b). */
static void rest_of(const pov_form *a, const pov_form *b, pov_form *restrict to)
{
    pov_form turns, product;

    divide(a, b, &product);
    whole(TAPE_CUT, &product, &turns);
    multiply(b, &turns, &product);
    subtract(a, &product, to);
}

static void compare(tape_op op, const pov_form *a, const pov_form *b, pov_form *restrict to)
{
    for (int l = 0; l < LANES; l++) {
        const double ar = reach(a, l) * WIDER, br = reach(b, l) * WIDER;
        const double lo = (a->middle[l] - ar) - (b->middle[l] + br), hi = (a->middle[l] + ar) - (b->middle[l] - br);
        const int equal = op == TAPE_EQUAL;
        const int never = equal ? lo > 0.0 || hi < 0.0 : op == TAPE_LESS ? lo >= 0.0 : lo > 0.0;
        const int always = equal ? lo == 0.0 && hi == 0.0 : op == TAPE_LESS ? hi < 0.0 : hi <= 0.0;

        between(always ? 1.0 : 0.0, never ? 0.0 : 1.0, l, to);
    }
}

static void both(tape_op op, const pov_form *a, const pov_form *b, pov_form *restrict to)
{
    for (int l = 0; l < LANES; l++) {
        const int a_holds = fabs(a->middle[l]) > reach(a, l), b_holds = fabs(b->middle[l]) > reach(b, l);
        const int a_fails = a->middle[l] == 0.0 && reach(a, l) == 0.0, b_fails = b->middle[l] == 0.0 && reach(b, l) == 0.0;
        const int always = op == TAPE_AND ? a_holds && b_holds : a_holds || b_holds;
        const int never = op == TAPE_AND ? a_fails || b_fails : a_fails && b_fails;

        between(always ? 1.0 : 0.0, never ? 0.0 : 1.0, l, to);
    }
}

/* b where a is below 0, or is 0; else c. */
static void choose(tape_op op, const pov_form *a, const pov_form *b, const pov_form *c, pov_form *restrict to)
{
    for (int l = 0; l < LANES; l++) {
        const double middle = a->middle[l], r = reach(a, l) * WIDER;
        const int first = op == TAPE_BELOW ? middle + r < 0.0 : middle == 0.0 && r == 0.0;
        const int second = op == TAPE_BELOW ? middle - r >= 0.0 : fabs(middle) > r;
        const double b_reach = reach(b, l), c_reach = reach(c, l);
        const double lo = lesser_known(b->middle[l] - b_reach, c->middle[l] - c_reach), hi = greater_known(b->middle[l] + b_reach, c->middle[l] + c_reach);

        to->middle[l] = first ? b->middle[l] : second ? c->middle[l] : 0.5 * (lo + hi);
        to->slope[l] = first ? b->slope[l] : second ? c->slope[l] : 0.0;
        to->off[l] = first ? b->off[l] : second ? c->off[l] : (0.5 * (hi - lo) + ROUNDING * (fabs(lo) + fabs(hi))) * WIDER;
        to->slope_off[l] = first ? b->slope_off[l] : second ? c->slope_off[l] : HUGE_VAL;
    }
}

/* Neither changes faster than the place. */
static void hexagon(tape_op op, const pov_form *x, const pov_form *y, pov_form *restrict to)
{
    for (int l = 0; l < LANES; l++) {
        const double xr = reach(x, l), yr = reach(y, l), xs = fabs(x->slope[l]) + x->slope_off[l], ys = fabs(y->slope[l]) + y->slope_off[l];
        internal_hex h;

        internal_hexagon(x->middle[l], y->middle[l], &h);
        to->middle[l] = op == TAPE_HEX_ALONG ? h.along : h.across;
        to->slope[l] = 0.0;
        to->off[l] = (sqrt(xr * xr + yr * yr) + 8.0 * ROUNDING * (fabs(x->middle[l]) + fabs(y->middle[l]))) * WIDER;
        to->slope_off[l] = sqrt(xs * xs + ys * ys) * WIDER;
    }
}

/* ---- running ---- */

void form_run(const tape *t, pov_form *r)
{
    for (const tape_step *s = t->steps, *const end = s + t->count; s < end; s++) {
        const pov_form *a = &r[s->a], *b = &r[s->b];
        pov_form *to = &r[s->to];

        switch ((tape_op)s->op) {
        case TAPE_CONSTANT: constant(s->k, to); break;
        case TAPE_ADD: add(a, b, to); break;
        case TAPE_SUBTRACT: subtract(a, b, to); break;
        case TAPE_MULTIPLY: multiply(a, b, to); break;
        case TAPE_DIVIDE: divide(a, b, to); break;
        case TAPE_OFFSET: offset(a, s->k, to); break;
        case TAPE_SCALE: scale(a, s->k, to); break;
        case TAPE_ABS: size_of(a, to); break;
        case TAPE_MIN: least(a, b, to); break;
        case TAPE_MAX: largest(a, b, to); break;
        case TAPE_MOD: rest_of(a, b, to); break;
        case TAPE_SQRT: form_sqrt(a, s->k, s->is_positive, to); break;
        case TAPE_POWER: form_power(a, s->k, s->is_positive, to); break;
        case TAPE_SIN: form_sin(a, s->k, s->is_positive, to); break;
        case TAPE_COS: form_cos(a, s->k, s->is_positive, to); break;
        case TAPE_EXP: form_exp(a, s->k, s->is_positive, to); break;
        case TAPE_LN: form_ln(a, s->k, s->is_positive, to); break;
        case TAPE_ASIN: form_asin(a, s->k, s->is_positive, to); break;
        case TAPE_ATAN: form_atan(a, s->k, s->is_positive, to); break;
        case TAPE_ASINH: form_asinh(a, s->k, s->is_positive, to); break;
        case TAPE_ATAN2: angle(a, b, to); break;
        case TAPE_FLOOR: case TAPE_CEIL: case TAPE_CUT: whole((tape_op)s->op, a, to); break;
        case TAPE_LESS: case TAPE_AT_MOST: case TAPE_EQUAL: compare((tape_op)s->op, a, b, to); break;
        case TAPE_AND: case TAPE_OR: both((tape_op)s->op, a, b, to); break;
        case TAPE_BELOW: case TAPE_ZERO: choose((tape_op)s->op, a, b, &r[s->c], to); break;
        case TAPE_HEX_ALONG: case TAPE_HEX_ACROSS: hexagon((tape_op)s->op, a, b, to); break;
        }
    }
}
