#include "common/level.h"

/* Bounds of positions on the line, whose products and sums are rounded a few times. */
#define ROUNDED 0x1p-50
/* A function that takes longer than this on one ray has crossings without end, or none that doubles can tell: from there on
 * stretches are cut less. */
enum { WORK = 1500, ROUNDS = 100 };

/* ---- values ---- */

static void put_slope(pov_slope *to, int lane, double value, double slope)
{
    to->value[lane] = value;
    to->slope[lane] = slope;
}

double common_level_value(const pov_function_bounds *f, double threshold, pov_vec3 at, pov_slope *memory)
{
    for (int l = 0; l < POV_SLOPES; l++) {
        put_slope(&memory[0], l, at.x, 0.0);
        put_slope(&memory[1], l, at.y, 0.0);
        put_slope(&memory[2], l, at.z, 0.0);
    }
    return f->at(f, memory)->value[0] - threshold;
}

pov_vec3 common_level_gradient(const pov_function_bounds *f, pov_vec3 at, pov_slope *memory, double *value)
{
    const pov_slope *found;

    for (int l = 0; l < POV_SLOPES; l++) {
        put_slope(&memory[0], l, at.x, l == 0);
        put_slope(&memory[1], l, at.y, l == 1);
        put_slope(&memory[2], l, at.z, l == 2);
    }
    found = f->at(f, memory);
    *value = found->value[0];
    return pov_vec3_of(found->slope[0], found->slope[1], found->slope[2]);
}

/* Values and derivatives at four points of the line. */
static pov_slope sample(const common_level *n, const double t[POV_SLOPES])
{
    pov_slope *memory = n->memory, out;

    for (int l = 0; l < POV_SLOPES; l++) {
        put_slope(&memory[0], l, n->o.x + t[l] * n->d.x, n->d.x);
        put_slope(&memory[1], l, n->o.y + t[l] * n->d.y, n->d.y);
        put_slope(&memory[2], l, n->o.z + t[l] * n->d.z, n->d.z);
    }
    out = *n->f->at(n->f, memory);
    for (int l = 0; l < POV_SLOPES; l++)
        out.value[l] -= n->threshold;
    return out;
}

bool common_level_is_below(const common_level *n, double t)
{
    const double at[POV_SLOPES] = { t, t, t, t };

    if (n->from_surface && t == 0.0)
        return n->start < 0.0;
    return sample(n, at).value[0] < 0.0;
}

/* ---- the crossing of a stretch ---- */

/* The crossing lies from lo to hi; the function rises there or falls. */
typedef struct bracket { double lo, hi; bool rises; } bracket;

static void narrow(bracket *b, double t, double value)
{
    if (!(t > b->lo && t < b->hi))
        return;
    if ((value < 0.0) == b->rises)
        b->lo = t;
    else
        b->hi = t;
}

/* Where the cubic t(value) is 0 that two points and their derivatives give. */
static double between(double t0, double v0, double s0, double t1, double v1, double s1)
{
    const double h = v1 - v0, w = -v0 / h, v = 1.0 - w;

    return v * v * ((1.0 + 2.0 * w) * t0 + w * h / s0) + w * w * ((1.0 + 2.0 * v) * t1 - v * h / s1);
}

/* From four points spread over the bracket. */
static double first_guess(const common_level *n, bracket *b)
{
    const double lo = b->lo, step = 0.25 * (b->hi - lo);
    double t[POV_SLOPES];
    pov_slope s;
    int i = 0;

    for (int l = 0; l < POV_SLOPES; l++)
        t[l] = lo + (0.5 + l) * step;
    s = sample(n, t);
    for (int l = 0; l < POV_SLOPES; l++)
        narrow(b, t[l], s.value[l]);
    while (i < POV_SLOPES - 2 && (s.value[i + 1] < 0.0) == b->rises)
        i++;
    return between(t[i], s.value[i], s.slope[i], t[i + 1], s.value[i + 1], s.slope[i + 1]);
}

/* Newton's steps within the bracket, which is halved where they leave it. Each squares the error, so that the one behind a
 * short one need not be asked for. */
static double refine(const common_level *n, bracket b)
{
    const double size = b.hi - b.lo;
    double t = first_guess(n, &b);

    for (int round = 0; round < ROUNDS; round++) {
        const double fine = 0x1p-52 * (fabs(t) + fabs(b.lo) + n->shortest);
        double at[POV_SLOPES], next;
        pov_slope s;

        if (!(t > b.lo && t < b.hi))
            t = 0.5 * (b.lo + b.hi);
        if (b.hi - b.lo <= fine)
            break;
        for (int l = 0; l < POV_SLOPES; l++)
            at[l] = t;
        s = sample(n, at);
        narrow(&b, t, s.value[0]);
        if (s.value[0] == 0.0)
            break;
        next = t - s.value[0] / s.slope[0];
        if (fabs(next - t) <= 0x1p-24 * size && next >= b.lo && next <= b.hi)
            return next;
        t = next;
    }
    return t;
}

/* ---- stretches ---- */

/* A stretch from lo to hi, and the function less the threshold over it. */
typedef struct stretch { double lo, hi, middle, slope, off, slope_off; } stretch;

static double place(const stretch *s, double u) { return 0.5 * (s->lo + s->hi) + u * 0.5 * (s->hi - s->lo); }

/* Where the threshold may lie, by the form: from lo to hi, of the whole. The bounds are taken twice, so that doubles tell on
 * which side the ends are. */
static bracket window(const stretch *s)
{
    const double a = (-s->middle - 2.0 * s->off) / s->slope, b = (-s->middle + 2.0 * s->off) / s->slope;
    const double near = a < b ? a : b, far = a < b ? b : a;
    bracket w = { s->lo, s->hi, s->slope > 0.0 };

    if (near > -1.0 && near < 1.0)
        w.lo = place(s, near);
    if (far < 1.0 && far > -1.0)
        w.hi = place(s, far);
    return w;
}

/* On which side an end is (u: -1 or 1): by the form if it tells, else by asking. */
static bool is_below(const common_level *n, const stretch *s, double u)
{
    const double value = s->middle + u * s->slope, t = u < 0.0 ? s->lo : s->hi;

    if (n->from_surface && t == 0.0)
        return n->start < 0.0;
    return fabs(value) > 2.0 * s->off ? value < 0.0 : common_level_is_below(n, t);
}

/* One crossing at most. */
static bool cross(const common_level *n, const stretch *s)
{
    bracket b = window(s);

    if (is_below(n, s, -1.0) != b.rises || is_below(n, s, 1.0) == b.rises)
        return true;
    if (b.lo > s->lo && b.hi < s->hi && b.lo > n->approx_from && b.hi < n->approx_to)
        return n->found(n->user, 0.5 * (b.lo + b.hi));
    if (!(b.hi > b.lo))
        b.lo = s->lo, b.hi = s->hi;
    return n->found(n->user, refine(n, b));
}

static bool divide(common_level *n, const stretch *s)
{
    const bracket w = window(s);
    const bracket b = { n->from_surface && s->lo == 0.0 ? 0.0 : w.lo, w.hi, w.rises };
    const double step = (b.hi - b.lo) * (1.0 / POV_FORMS);
    double lo[POV_FORMS], hi[POV_FORMS];

    for (int i = 0; i < POV_FORMS; i++)
        lo[i] = i > 0 ? hi[i - 1] : b.lo, hi[i] = i < POV_FORMS - 1 ? b.lo + (1 + i) * step : b.hi;
    return common_level_search(n, lo, hi, POV_FORMS);
}

static bool is_short(const common_level *n, const stretch *s)
{
    const double size = s->hi - s->lo;

    if (n->work > WORK)
        return size <= n->shortest * (n->work > 2 * WORK ? 0x1p40 : 0x1p30);
    return size <= n->shortest || size <= 0x1p-49 * fabs(s->hi);
}

/* No number at all, as the root of what is negative, is not below the threshold. Bounds do not tell; places do. */
static bool is_nowhere(const common_level *n, const stretch *s)
{
    const double at[POV_SLOPES] = { s->lo, place(s, -0.4), place(s, 0.4), s->hi };
    pov_slope found;
    int known = 0;

    if (s->middle == s->middle || !(s->hi - s->lo <= 0x1p40 * n->shortest))
        return false;
    found = sample(n, at);
    for (int l = 0; l < POV_SLOPES; l++)
        known += found.value[l] == found.value[l];
    return known == 0;
}

/* Where the function has no value on one side, there is no surface, as in POV-Ray. */
static bool is_at_border(const common_level *n, const stretch *s)
{
    const double at[POV_SLOPES] = { s->lo, s->lo, s->hi, s->hi };
    const pov_slope found = sample(n, at);

    return found.value[0] != found.value[0] || found.value[2] != found.value[2];
}

static bool judge_stretch(common_level *n, const stretch *s)
{
    const double reach = (fabs(s->slope) + s->off) * (1.0 + 0x1p-48) + 0x1p-51 * fabs(s->middle);

    if (s->middle - reach >= 0.0 || s->middle + reach < 0.0)
        return true;
    if (fabs(s->slope) > s->slope_off)
        return cross(n, s);
    if (is_nowhere(n, s))
        return true;
    if (!is_short(n, s))
        return divide(n, s);
    if (common_level_is_below(n, s->lo) == common_level_is_below(n, s->hi) || is_at_border(n, s))
        return true;
    return n->found(n->user, 0.5 * (s->lo + s->hi));
}

/* o + t d for t from lo to hi. */
static void put_axis(pov_form *to, int lane, double o, double d, double middle, double half)
{
    to->middle[lane] = o + middle * d;
    to->slope[lane] = half * d;
    to->off[lane] = ROUNDED * (fabs(o) + fabs(middle * d) + fabs(half * d));
    to->slope_off[lane] = ROUNDED * fabs(half * d);
}

bool common_level_search(common_level *n, const double *lo, const double *hi, int count)
{
    pov_form *memory = n->memory, f;

    for (int l = 0; l < POV_FORMS; l++) {
        const int i = l < count ? l : count - 1;
        const double middle = 0.5 * (lo[i] + hi[i]), half = 0.5 * (hi[i] - lo[i]);

        put_axis(&memory[0], l, n->o.x, n->d.x, middle, half);
        put_axis(&memory[1], l, n->o.y, n->d.y, middle, half);
        put_axis(&memory[2], l, n->o.z, n->d.z, middle, half);
    }
    f = *n->f->over(n->f, memory);
    n->work++;
    for (int l = 0; l < count; l++) {
        const stretch s = { lo[l], hi[l], f.middle[l] - n->threshold, f.slope[l], f.off[l], f.slope_off[l] };

        if (!judge_stretch(n, &s))
            return false;
    }
    return true;
}
