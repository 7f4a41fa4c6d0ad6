/* clip.h - the stretch of a ray within a box, with a margin that covers its own rounding. */
#ifndef COMMON_CLIP_H
#define COMMON_CLIP_H

#include "common/local.h"

typedef struct common_span { double lo, hi; } common_span;

/* Between the distances of two planes, in any order. */
static inline void common_clip_between(common_span *s, double a, double b)
{
    const double near = a < b ? a : b, far = a < b ? b : a;

    s->lo = near > s->lo ? near : s->lo;
    s->hi = far < s->hi ? far : s->hi;
}

static inline void common_clip_axis(common_span *s, double from, double d, double lo, double hi, double margin)
{
    if (d != 0.0)
        common_clip_between(s, (lo - margin - from) / d, (hi + margin - from) / d);
    else if (!(from >= lo - margin && from <= hi + margin))
        s->hi = -HUGE_VAL;
}

/* The same by the inverse of d, which is infinite for 0: planes are then infinitely far, before the ray or behind it. The margin
 * must keep them off the ray. */
static inline void common_clip_inverse(common_span *s, double from, double inverse, double lo, double hi, double margin)
{
    common_clip_between(s, (lo - margin - from) * inverse, (hi + margin - from) * inverse);
}

/* In the space of the ray; the box's coordinates are of the order of one. False: the line misses it. */
static inline bool common_clip(const common_ray *k, pov_vec3 lo, pov_vec3 hi, common_span *out)
{
    const pov_vec3 f = pov_two3_hi(k->f);
    const double margin = 0x1p-40 + 0x1p-48 * pov_largest(f);

    out->lo = -HUGE_VAL;
    out->hi = HUGE_VAL;
    common_clip_axis(out, f.x, k->d.x, lo.x, hi.x, margin);
    common_clip_axis(out, f.y, k->d.y, lo.y, hi.y, margin);
    common_clip_axis(out, f.z, k->d.z, lo.z, hi.z, margin);
    return out->lo <= out->hi;
}

/* Distances from a base: where no more than the first crossing is wanted, one beyond `enough` is the last; none beyond `far` counts,
 * and where any crossing will do, one before `within` need not be known. */
typedef struct common_wanted { double enough, far, within; } common_wanted;

/* `near`: how far the start of the ray may reach. */
static inline common_wanted common_wants(const common_ray *k, double base, double near, const pov_hits *hits)
{
    const double off = 0x1p-40 * (1.0 + fabs(base)), least = hits->tmin * k->per_unit - base + off;
    const double most = hits->tmax * k->per_unit, far = most * (1.0 + 0x1p-40) - base + off;
    const common_wanted w = { hits->want == POV_WANT_ALL ? HUGE_VAL : least > near ? least : near, far,
                              hits->want == POV_WANT_ANY ? most * (1.0 - 0x1p-40) - base - off : -HUGE_VAL };

    return w;
}

#endif
