/* frustum_bounds.h - a ray and a cylinder or cone of a block, in floats: whether its line definitely misses, and bounds
 * on its entry and exit. All functions stand in loops over lanes, of shapes or of rays, so they have no branches.
 *
 * The ray is transformed to local coordinates, relative to the centre of the axis. Its parameter is measured from its
 * point closest to the centre, which is `middle` away from its start; near the shape all numbers are of the order of
 * one there. Points of the ray near the shape are off by less than 12 e N (S + 2 + |middle|) in a coordinate, N being
 * the sum of the entries of that coordinate's row: docs/numerics.md has the count. Enlarging and shrinking the radius,
 * and moving the ends by that much makes the bounds safe. */
#ifndef KIT_FRUSTUM_BOUNDS_H
#define KIT_FRUSTUM_BOUNDS_H

#include "kit/floats.h"
#include "kit/frustum.h"

/* A shape of a block. */
typedef struct kit_one { kit_three centre, row[3]; float radius, slope, half, wide, high, closed; } kit_one;

/* With a larger error in local coordinates, radius and ends are too uncertain for a definite hit; above one, for any
 * statement. */
#define KIT_BLURRED 0x1p-4f

KIT_INLINE kit_three kit_turned(const kit_one *s, kit_three v)
{
    const kit_three r = { kit_dot(s->row[0], v), kit_dot(s->row[1], v), kit_dot(s->row[2], v) };
    return r;
}

/* A ray in local coordinates about its point at `middle`, and the discriminant of the side there with the larger
 * radius. */
typedef struct kit_line { kit_three p, d; float middle, discriminant; } kit_line;

/* Errors of radius and ends. */
KIT_INLINE float kit_widening(const kit_one *s, const kit_beam *ray, float middle)
{
    return s->wide * (ray->size + 2.0f + fabsf(middle));
}

KIT_INLINE float kit_heightening(const kit_one *s, const kit_beam *ray, float middle)
{
    return s->high * (ray->size + 2.0f + fabsf(middle));
}

/* Discriminant of a line and a side of this radius at the line's point. */
KIT_INLINE float kit_discriminant(const kit_line *l, float r, float grow)
{
    const float p = kit_float_sum(r, l->d.x, -(grow * l->p.x)), q = kit_float_sum(r, l->d.y, -(grow * l->p.y));
    const float m = kit_float_sum(l->p.x, l->d.y, -(l->p.y * l->d.x));

    return kit_float_sum(p, p, kit_float_sum(q, q, -(m * m)));
}

KIT_INLINE kit_line kit_find_line(const kit_one *s, const kit_beam *ray)
{
    const kit_three from = { ray->org.x - s->centre.x, ray->org.y - s->centre.y, ray->org.z - s->centre.z };
    const kit_three d = kit_turned(s, ray->dir), f = kit_turned(s, from);
    kit_line l;

    l.middle = -kit_dot(f, d) / kit_dot(d, d);
    l.d = d;
    l.p.x = kit_float_sum(l.middle, d.x, f.x);
    l.p.y = kit_float_sum(l.middle, d.y, f.y);
    l.p.z = kit_float_sum(l.middle, d.z, f.z);
    l.discriminant = kit_discriminant(&l, kit_float_sum(s->slope, l.p.z, s->radius + kit_widening(s, ray, l.middle)), s->slope * d.z);
    return l;
}

/* Largest rate of change between the side and the ray; and the rounding errors of a discriminant. */
KIT_INLINE float kit_speed(const kit_one *s, const kit_line *l)
{
    return fabsf(l->d.x) + fabsf(l->d.y) + fabsf(s->slope * l->d.z);
}

KIT_INLINE float kit_doubt(float speed) { return 2048.0f * KIT_E * speed * speed; }

KIT_INLINE float kit_blur(const kit_one *s, const kit_beam *ray, float middle)
{
    return kit_float_greater(kit_widening(s, ray, middle), kit_heightening(s, ray, middle));
}

/* The line's closest point is no further from the axis than the shape's corners, whose squared distance is then below
 * 14. */
KIT_INLINE int kit_line_misses(const kit_one *s, const kit_beam *ray, const kit_line *l)
{
    return ((int)(l->discriminant < -kit_doubt(kit_speed(s, l))) | (int)(kit_dot(l->p, l->p) > 16.0f))
           & (int)(kit_blur(s, ray, l->middle) < 1.0f);
}

/* Bounds on the entry and the exit of a ray: before `lo` and after `hi` it is outside, from `late` to `soon` it is
 * inside. */
typedef struct kit_reach { float lo, late, soon, hi; } kit_reach;

/* The side. Its roots are (-b -+ sqrt D) / a, for either sign of a. Where a is nearly zero, or negative and the ray
 * comes near the apex, the result is unknown. */
KIT_INLINE kit_reach kit_side(const kit_one *s, const kit_beam *ray, const kit_line *l)
{
    const float wide = kit_widening(s, ray, l->middle), r = kit_float_sum(s->slope, l->p.z, s->radius), grow = s->slope * l->d.z;
    const float a = kit_float_sum(l->d.x, l->d.x, kit_float_sum(l->d.y, l->d.y, -(grow * grow))), inverse = 1.0f / a;
    const float across = kit_float_sum(l->p.x, l->d.x, l->p.y * l->d.y), speed = kit_speed(s, l), doubt = kit_doubt(speed);
    const float outer = kit_float_sum(grow, r + wide, -across), inner = kit_float_sum(grow, r - wide, -across);
    const float more = a > 0.0f ? doubt : -doubt, apart = l->discriminant + more;
    const float within = kit_discriminant(l, r - wide, grow) - more;
    const float large = sqrtf(kit_float_greater(apart, 0.0f)), small = sqrtf(kit_float_greater(within, 0.0f));
    /* Errors: 50 e g of b, 4 e g^2 of a, 3 e of quotient and root; both terms of the numerator together are below 31
     * g. */
    const float gain = speed * inverse, slack = 512.0f * KIT_E * speed * gain * gain + 2.0f * KIT_E * fabsf(l->middle);
    /* The signs tell: is anything known, is there an entry, an exit? (Compilers do not vectorise other ways to combine
     * these conditions.) */
    const float known = kit_float_lesser(fabsf(a) - kit_float_sum(0x1p-8f * speed, speed, 1e-36f),
                                         kit_float_greater(a, l->discriminant - doubt));
    const float sure = kit_float_lesser(known, within);
    const float enters = kit_float_greater(a, grow), leaves = kit_float_greater(a, -grow);
    const float lo = l->middle + (outer - large) * inverse - slack, late = l->middle + (inner - small) * inverse + slack;
    const float soon = l->middle + (inner + small) * inverse - slack, hi = l->middle + (outer + large) * inverse + slack;
    const float first = enters > 0.0f ? lo : -HUGE_VALF, entry = enters > 0.0f ? late : -HUGE_VALF;
    const float exit = leaves > 0.0f ? soon : HUGE_VALF, last = leaves > 0.0f ? hi : HUGE_VALF;
    kit_reach out;

    out.lo = known > 0.0f ? first : -HUGE_VALF;
    out.late = sure > 0.0f ? entry : HUGE_VALF;
    out.soon = sure > 0.0f ? exit : -HUGE_VALF;
    out.hi = known > 0.0f ? last : HUGE_VALF;
    return out;
}

/* The slab between the ends. The inner end stays so far from an apex that the smaller radius there is certainly
 * positive. A slope along the axis that is too small to matter counts as none. */
KIT_INLINE kit_reach kit_slab(const kit_one *s, const kit_beam *ray, const kit_line *l)
{
    const float high = kit_heightening(s, ray, l->middle), z = l->p.z;
    const float dz = fabsf(l->d.z) > 0x1p-40f ? l->d.z : 0x1p-40f, inverse = 1.0f / dz, slack = 2.0f * KIT_E * fabsf(l->middle);
    const float base_out = (-s->half - high - z) * inverse, top_out = (s->half + high - z) * inverse;
    const float base_in = (4.0f * kit_widening(s, ray, l->middle) + high - s->half - z) * inverse, top_in = (s->half - high - z) * inverse;
    kit_reach out;

    out.lo = l->middle + kit_float_lesser(base_out, top_out) - slack;
    out.late = l->middle + (dz > 0.0f ? base_in : top_in) + slack;
    out.soon = l->middle + (dz > 0.0f ? top_in : base_in) - slack;
    out.hi = l->middle + kit_float_greater(base_out, top_out) + slack;
    return out;
}

#endif
