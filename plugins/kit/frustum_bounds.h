/* frustum_bounds.h - a ray and a cylinder or cone of a block, in plain double: does its line surely miss, and bounds on
 * where it enters and leaves. Everything stands in loops over lanes, of shapes or of rays, so it has no branches.
 *
 * The ray is taken about its point nearest to the middle of the shape, in local coordinates, where all is as large as
 * one. There it is off by less than half of sigma = 64 u N (O + R) in each coordinate, with N the largest entry of the
 * rows and O + R what origin and shape can be: docs/numerics.md has the count. All bounds are made of that. */
#ifndef KIT_FRUSTUM_BOUNDS_H
#define KIT_FRUSTUM_BOUNDS_H

#include "kit/frustum.h"
#include "kit/simd.h"

/* A shape of a block. size: the largest entry of the rows. */
typedef struct kit_one { pov_vec3 anchor, row[3]; double radius, slope, height, size; } kit_one;

KIT_INLINE pov_vec3 kit_one_vector(const double v[3][POV_BLOCK_MAX], uint32_t i)
{
    return pov_vec3_of(v[0][i], v[1][i], v[2][i]);
}

KIT_INLINE kit_one kit_one_of(const kit_frustum_block *b, uint32_t i)
{
    kit_one s;

    s.anchor = kit_one_vector(b->anchor, i);
    s.row[0] = kit_one_vector(b->row[0], i);
    s.row[1] = kit_one_vector(b->row[1], i);
    s.row[2] = kit_one_vector(b->row[2], i);
    s.radius = b->radius[i];
    s.slope = b->slope[i];
    s.height = b->height[i];
    s.size = b->size[i];
    return s;
}

/* What a ray is to a shape. Where sigma is no small thing, or not a number, nothing is certain; g is the shape's size
 * times the direction's. */
typedef struct kit_blur { double sigma, g; } kit_blur;

#define KIT_BLURRED 0x1p-8
/* Times the sum of what origin and shape can be. */
#define KIT_BLUR (64.0 * KIT_U)

/* A ray of ordinary length and a shape as small as that leave room for the sixth power of either. */
KIT_INLINE int kit_is_ordinary(double speed) { return (int)(speed > 1e-40) & (int)(speed < 1e40); }

/* A ray in local coordinates about its point at `middle`, and the discriminant of the side there. */
typedef struct kit_line { pov_vec3 p, d; double middle, discriminant; } kit_line;

KIT_INLINE double kit_dot(pov_vec3 a, pov_vec3 b) { return kit_sum_of(a.z, b.z, kit_sum_of(a.y, b.y, a.x * b.x)); }

KIT_INLINE pov_vec3 kit_turned(const kit_one *s, pov_vec3 v)
{
    return pov_vec3_of(kit_dot(s->row[0], v), kit_dot(s->row[1], v), kit_dot(s->row[2], v));
}

KIT_INLINE kit_line kit_find_line(const kit_one *s, pov_vec3 org, pov_vec3 dir)
{
    const pov_vec3 d = kit_turned(s, dir), f = kit_turned(s, pov_sub(org, s->anchor));
    const double middle = -kit_dot(pov_vec3_of(f.x, f.y, f.z - 0.5 * s->height), d) / kit_dot(d, d);
    const double x = kit_sum_of(middle, d.x, f.x), y = kit_sum_of(middle, d.y, f.y), z = kit_sum_of(middle, d.z, f.z);
    const double r = kit_sum_of(s->slope, z, s->radius), grow = s->slope * d.z;
    const double p = kit_sum_of(r, d.x, -(grow * x)), q = kit_sum_of(r, d.y, -(grow * y));
    const double m = kit_sum_of(x, d.y, -(y * d.x));
    kit_line l;

    l.p = pov_vec3_of(x, y, z);
    l.d = d;
    l.middle = middle;
    l.discriminant = kit_sum_of(p, p, kit_sum_of(q, q, -(m * m)));
    return l;
}

/* A local point off by sigma / 2 moves the value x^2 + y^2 - r(z)^2 by less than 12 sigma, and so the discriminant by
 * that times its leading coefficient, which is below 4 G^2; G, size times speed, is no less than a component of the
 * direction. Its own roundings are below 13 sigma G^2. */
KIT_INLINE double kit_doubt(const kit_blur *b) { return 64.0 * b->sigma * b->g * b->g; }

/* The line's nearest point lies no further out than the shape's corners, of which the square is below 6. */
KIT_INLINE int kit_line_misses(const kit_one *s, const kit_line *l, const kit_blur *b)
{
    const pov_vec3 out = pov_vec3_of(l->p.x, l->p.y, l->p.z - 0.5 * s->height);

    return ((int)(l->discriminant < -kit_doubt(b)) | (int)(kit_dot(out, out) > 8.0)) & (int)(b->sigma < KIT_BLURRED);
}

/* Bounds on where a ray enters and leaves something: before `lo` and after `hi` it is outside, from `late` to `soon` it
 * is inside. */
typedef struct kit_reach { double lo, late, soon, hi; } kit_reach;

/* The side. With a coefficient a of one sign or the other the roots are (-b -+ sqrt D) / a. Where a is all but zero, or
 * below zero and the ray comes near to the apex, nothing is said. */
KIT_INLINE kit_reach kit_side(const kit_one *s, const kit_line *l, const kit_blur *b)
{
    const double r = kit_sum_of(s->slope, l->p.z, s->radius), grow = s->slope * l->d.z, g = b->g;
    const pov_vec3 d = pov_vec3_of(l->d.x, l->d.y, grow), back = pov_vec3_of(d.x, d.y, -grow);
    const double a = kit_dot(d, back), half = kit_dot(pov_vec3_of(l->p.x, l->p.y, r), back), doubt = kit_doubt(b);
    const double least = l->discriminant - doubt, most = l->discriminant + doubt;
    const double small = sqrt(kit_greater(least, 0.0)), large = sqrt(kit_greater(most, 0.0));
    const double inverse = 1.0 / a, gain = g * inverse;
    /* Of half 100 u g, of a 20 u g^2, of quotient and root 3 u; both parts of the numerator together are below 50 g. */
    const double slack = 4096.0 * KIT_U * g * gain * gain + 4.0 * KIT_U * fabs(l->middle);
    /* By their signs: is anything known, is there an entry, an exit? Conditions joined in other ways stop compilers. */
    const double known = kit_lesser(fabs(a) - 0x1p-26 * g * g, kit_greater(a, least));
    const double enters = kit_greater(a, grow), leaves = kit_greater(a, -grow);
    const double wide = a > 0.0 ? large : small, deep = a > 0.0 ? small : large;
    const double lo = l->middle + (-half - wide) * inverse - slack, late = l->middle + (-half - deep) * inverse + slack;
    const double soon = l->middle + (-half + deep) * inverse - slack, hi = l->middle + (-half + wide) * inverse + slack;
    const double first = enters > 0.0 ? lo : -HUGE_VAL, entry = enters > 0.0 ? late : -HUGE_VAL;
    const double exit = leaves > 0.0 ? soon : HUGE_VAL, last = leaves > 0.0 ? hi : HUGE_VAL;
    kit_reach out;

    out.lo = known > 0.0 ? first : -HUGE_VAL;
    out.late = known > 0.0 ? entry : HUGE_VAL;
    out.soon = kit_lesser(known, least) > 0.0 ? exit : -HUGE_VAL;
    out.hi = known > 0.0 ? last : HUGE_VAL;
    return out;
}

/* Between the ends. The inner one stays so far from an apex that the radius there is above zero for certain. Along the
 * ends a slope too small to matter stands for none. */
KIT_INLINE kit_reach kit_slab(const kit_one *s, const kit_line *l, const kit_blur *b)
{
    const double sigma = b->sigma, least = 0x1p-200 * b->g, z = l->p.z;
    const double dz = fabs(l->d.z) > least ? l->d.z : least, inverse = 1.0 / dz;
    const double slack = 4.0 * KIT_U * fabs(l->middle);
    const double base_out = (-sigma - z) * inverse, base_in = (8.0 * sigma - z) * inverse;
    const double top_out = (s->height + sigma - z) * inverse, top_in = (s->height - sigma - z) * inverse;
    const int up = dz > 0.0;
    kit_reach out;

    out.lo = l->middle + (up ? base_out : top_out) - slack;
    out.late = l->middle + (up ? base_in : top_in) + slack;
    out.soon = l->middle + (up ? top_in : base_in) - slack;
    out.hi = l->middle + (up ? top_out : base_out) + slack;
    return out;
}

#endif
