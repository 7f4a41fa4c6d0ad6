/* cone_bounds.h - a ray and a cylinder or cone of a block, in floats: whether its line definitely misses, and bounds
 * on its entry and exit. All functions stand in loops over lanes, of shapes or of rays, so they have no branches.
 *
 * The ray is transformed to local coordinates, relative to the centre of the axis. Its parameter is measured from its
 * point closest to the centre, which is `middle` away from its start; near the shape all numbers are of the order of
 * one there. Points of the ray near the shape are off by less than 12 e N (S + 2 + |middle|) in a coordinate, N being
 * the sum of the entries of that coordinate's row: docs/numerics.md has the count. Enlarging and shrinking the radius,
 * and moving the ends by that much makes the bounds safe. */
#ifndef COMMON_CONE_BOUNDS_H
#define COMMON_CONE_BOUNDS_H

#include "common/floats.h"
#include "common/cone.h"

/* A shape of a block. */
typedef struct common_one { common_three centre, row[3]; float radius, slope, half, wide, high, closed; } common_one;

/* With a larger error in local coordinates, radius and ends are too uncertain for a definite hit; above one, for any
 * statement. */
#define COMMON_BLURRED 0x1p-4f

COMMON_INLINE common_three common_turned(const common_one *s, common_three v)
{
    const common_three r = { common_dot(s->row[0], v), common_dot(s->row[1], v), common_dot(s->row[2], v) };
    return r;
}

/* A ray in local coordinates about its point at `middle`, and the discriminant of the side there with the larger
 * radius. */
typedef struct common_line { common_three p, d; float middle, discriminant; } common_line;

/* Errors of radius and ends. */
COMMON_INLINE float common_widening(const common_one *s, const common_beam *ray, float middle)
{
    return s->wide * (ray->size + 2.0f + fabsf(middle));
}

COMMON_INLINE float common_heightening(const common_one *s, const common_beam *ray, float middle)
{
    return s->high * (ray->size + 2.0f + fabsf(middle));
}

/* Discriminant of a line and a side of this radius at the line's point. */
COMMON_INLINE float common_discriminant(const common_line *l, float r, float grow)
{
    const float p = common_float_sum(r, l->d.x, -(grow * l->p.x)), q = common_float_sum(r, l->d.y, -(grow * l->p.y));
    const float m = common_float_sum(l->p.x, l->d.y, -(l->p.y * l->d.x));

    return common_float_sum(p, p, common_float_sum(q, q, -(m * m)));
}

COMMON_INLINE common_line common_find_line(const common_one *s, const common_beam *ray)
{
    const common_three from = { ray->org.x - s->centre.x, ray->org.y - s->centre.y, ray->org.z - s->centre.z };
    const common_three d = common_turned(s, ray->dir), f = common_turned(s, from);
    common_line l;

    l.middle = -common_dot(f, d) / common_dot(d, d);
    l.d = d;
    l.p.x = common_float_sum(l.middle, d.x, f.x);
    l.p.y = common_float_sum(l.middle, d.y, f.y);
    l.p.z = common_float_sum(l.middle, d.z, f.z);
    l.discriminant = common_discriminant(&l, common_float_sum(s->slope, l.p.z, s->radius
                                                              + common_widening(s, ray, l.middle)), s->slope * d.z);
    return l;
}

/* Largest rate of change between the side and the ray; and the rounding errors of a discriminant. */
COMMON_INLINE float common_speed(const common_one *s, const common_line *l)
{
    return fabsf(l->d.x) + fabsf(l->d.y) + fabsf(s->slope * l->d.z);
}

COMMON_INLINE float common_doubt(float speed) { return 2048.0f * COMMON_E * speed * speed; }

COMMON_INLINE float common_blur(const common_one *s, const common_beam *ray, float middle)
{
    return common_float_greater(common_widening(s, ray, middle), common_heightening(s, ray, middle));
}

/* The line's closest point is no further from the axis than the shape's corners, whose squared distance is then below
 * 14. */
COMMON_INLINE int common_line_misses(const common_one *s, const common_beam *ray, const common_line *l)
{
    return ((int)(l->discriminant < -common_doubt(common_speed(s, l))) | (int)(common_dot(l->p, l->p) > 16.0f))
           & (int)(common_blur(s, ray, l->middle) < 1.0f);
}

/* Bounds on the entry and the exit of a ray: before `lo` and after `hi` it is outside, from `late` to `soon` it is
 * inside. */
typedef struct common_reach { float lo, late, soon, hi; } common_reach;

/* The side. Its roots are (-b -+ sqrt D) / a, for either sign of a. Where a is nearly zero, or negative and the ray
 * comes near the apex, the result is unknown. */
COMMON_INLINE common_reach common_side(const common_one *s, const common_beam *ray, const common_line *l)
{
    const float wide = common_widening(s, ray, l->middle), r = common_float_sum(s->slope, l->p.z, s->radius),
        grow = s->slope * l->d.z;
    const float a = common_float_sum(l->d.x, l->d.x, common_float_sum(l->d.y, l->d.y, -(grow * grow))),
        inverse = 1.0f / a;
    const float across = common_float_sum(l->p.x, l->d.x, l->p.y * l->d.y), speed = common_speed(s, l),
        doubt = common_doubt(speed);
    const float outer = common_float_sum(grow, r + wide, -across), inner = common_float_sum(grow, r - wide, -across);
    const float more = a > 0.0f ? doubt : -doubt, separation = l->discriminant + more;
    const float within = common_discriminant(l, r - wide, grow) - more;
    const float large = sqrtf(common_float_greater(separation, 0.0f)),
        small = sqrtf(common_float_greater(within, 0.0f));
    /* Errors: 50 e g of b, 4 e g^2 of a, 3 e of quotient and root; both terms of the numerator together are below 31
     * g. */
    const float gain = speed * inverse,
        slack = 512.0f * COMMON_E * speed * gain * gain + 2.0f * COMMON_E * fabsf(l->middle);
    /* The signs tell: is anything known, is there an entry, an exit? (Compilers do not vectorise other ways to combine
     * these conditions.) */
    const float known = common_float_lesser(fabsf(a) - common_float_sum(0x1p-8f * speed, speed, 1e-36f),
                                            common_float_greater(a, l->discriminant - doubt));
    const float sure = common_float_lesser(known, within);
    const float enters = common_float_greater(a, grow), leaves = common_float_greater(a, -grow);
    const float lo = l->middle + (outer - large) * inverse - slack, late = l->middle + (inner - small) * inverse + slack;
    const float soon = l->middle + (inner + small) * inverse - slack, hi = l->middle + (outer + large) * inverse + slack;
    const float first = enters > 0.0f ? lo : -HUGE_VALF, entry = enters > 0.0f ? late : -HUGE_VALF;
    const float exit = leaves > 0.0f ? soon : HUGE_VALF, last = leaves > 0.0f ? hi : HUGE_VALF;
    common_reach out;

    out.lo = known > 0.0f ? first : -HUGE_VALF;
    out.late = sure > 0.0f ? entry : HUGE_VALF;
    out.soon = sure > 0.0f ? exit : -HUGE_VALF;
    out.hi = known > 0.0f ? last : HUGE_VALF;
    return out;
}

/* The slab between the ends. The inner end stays so far from an apex that the smaller radius there is certainly
 * positive. A slope along the axis that is too small to matter counts as none. */
COMMON_INLINE common_reach common_slab(const common_one *s, const common_beam *ray, const common_line *l)
{
    const float high = common_heightening(s, ray, l->middle), z = l->p.z;
    const float dz = fabsf(l->d.z) > 0x1p-40f ? l->d.z : 0x1p-40f, inverse = 1.0f / dz,
        slack = 2.0f * COMMON_E * fabsf(l->middle);
    const float base_out = (-s->half - high - z) * inverse, top_out = (s->half + high - z) * inverse;
    const float base_in = (4.0f * common_widening(s, ray, l->middle) + high - s->half - z) * inverse,
        top_in = (s->half - high - z) * inverse;
    common_reach out;

    out.lo = l->middle + common_float_lesser(base_out, top_out) - slack;
    out.late = l->middle + (dz > 0.0f ? base_in : top_in) + slack;
    out.soon = l->middle + (dz > 0.0f ? top_in : base_in) - slack;
    out.hi = l->middle + common_float_greater(base_out, top_out) + slack;
    return out;
}

#endif
