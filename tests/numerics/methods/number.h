/* number.h - what the kernels to compare with reckon in, and how they solve a quadratic equation.
 *
 * One source for each primitive, three methods: the textbook's, in plain double about the world's origin (no macro);
 * RECENTRED: in plain double, but about the ray's point of closest approach, and with the stable root first;
 * DOUBLE_DOUBLE: the textbook's formulas in double-double arithmetic throughout. None has an error bound. Where
 * textbooks leave out what lies nearer than an epsilon, these do for rays that left the shape itself. */
#ifndef METHODS_NUMBER_H
#define METHODS_NUMBER_H

#include <povtrace/exact.h>
#include <povtrace/shape_fast.h>

#define SHADOW_EPSILON 1e-6

#ifdef DOUBLE_DOUBLE
typedef pov_two num;
static inline num num_of(double a) { return pov_two_of(a, 0.0); }
static inline num num_of2(double a, double a_lo) { return pov_two_sum(a, a_lo); }
static inline num num_add(num a, num b) { return pov_two_add(a, b); }
static inline num num_sub(num a, num b) { return pov_two_sub(a, b); }
static inline num num_mul(num a, num b) { return pov_two_mul(a, b); }
static inline num num_div(num a, num b) { return pov_two_div(a, b); }
static inline num num_sqrt(num a) { return pov_two_sqrt(a); }
static inline double num_double(num a) { return a.hi; }
static inline double num_rest(num a) { return a.lo; }
#else
typedef double num;
static inline num num_of(double a) { return a; }
static inline num num_of2(double a, double a_lo) { (void)a_lo; return a; }
static inline num num_add(num a, num b) { return a + b; }
static inline num num_sub(num a, num b) { return a - b; }
static inline num num_mul(num a, num b) { return a * b; }
static inline num num_div(num a, num b) { return a / b; }
static inline num num_sqrt(num a) { return sqrt(a); }
static inline double num_double(num a) { return a; }
static inline double num_rest(num a) { (void)a; return 0.0; }
#endif

#ifdef RECENTRED
enum { IS_RECENTRED = 1 };
#else
enum { IS_RECENTRED = 0 };
#endif

static inline num num_neg(num a) { return num_sub(num_of(0.0), a); }
static inline bool num_less(num a, num b) { return num_double(num_sub(a, b)) < 0.0; }

typedef struct num3 { num x, y, z; } num3;

static inline num3 num3_of(pov_vec3 a, pov_vec3 a_lo)
{
    num3 r;

    r.x = num_of2(a.x, a_lo.x), r.y = num_of2(a.y, a_lo.y), r.z = num_of2(a.z, a_lo.z);
    return r;
}

static inline num3 num3_planar(pov_vec3 a) { return num3_of(a, pov_vec3_of(0.0, 0.0, 0.0)); }
static inline pov_vec3 num3_double(num3 a) { return pov_vec3_of(num_double(a.x), num_double(a.y), num_double(a.z)); }

static inline num3 num3_add(num3 a, num3 b)
{
    num3 r;

    r.x = num_add(a.x, b.x), r.y = num_add(a.y, b.y), r.z = num_add(a.z, b.z);
    return r;
}

static inline num3 num3_sub(num3 a, num3 b)
{
    num3 r;

    r.x = num_sub(a.x, b.x), r.y = num_sub(a.y, b.y), r.z = num_sub(a.z, b.z);
    return r;
}

static inline num3 num3_scale(num3 a, num s)
{
    num3 r;

    r.x = num_mul(a.x, s), r.y = num_mul(a.y, s), r.z = num_mul(a.z, s);
    return r;
}

static inline num num3_dot(num3 a, num3 b)
{
    return num_add(num_add(num_mul(a.x, b.x), num_mul(a.y, b.y)), num_mul(a.z, b.z));
}

static inline num3 num3_cross(num3 a, num3 b)
{
    num3 r;

    r.x = num_sub(num_mul(a.y, b.z), num_mul(a.z, b.y));
    r.y = num_sub(num_mul(a.z, b.x), num_mul(a.x, b.z));
    r.z = num_sub(num_mul(a.x, b.y), num_mul(a.y, b.x));
    return r;
}

/* The ray as the method sees it: `from` lies `middle` along it. */
typedef struct line { num3 from, dir; num middle; } line;

static inline line line_from(const pov_ray *ray, num3 anchor)
{
    line l;

    l.from = num3_sub(num3_of(ray->org, ray->org_lo), anchor);
    l.dir = num3_of(ray->dir, ray->dir_lo);
    l.middle = num_of(0.0);
    if (IS_RECENTRED) {
        l.middle = num_neg(num_div(num3_dot(l.from, l.dir), num3_dot(l.dir, l.dir)));
        l.from = num3_add(l.from, num3_scale(l.dir, l.middle));
    }
    return l;
}

static inline num3 line_at(const line *l, num t) { return num3_add(l->from, num3_scale(l->dir, t)); }

/* Roots of a t^2 + 2 b t + c: root[0] where the value falls, root[1] where it rises. Bits say which there are. */
static inline unsigned solve(num a, num b, num c, num root[2])
{
    const num square = num_sub(num_mul(b, b), num_mul(a, c));
    num r, q;

    if (num_double(a) == 0.0) {
        const int rises = num_double(b) > 0.0;

        root[rises] = num_neg(num_div(c, num_add(b, b)));
        return num_double(b) == 0.0 ? 0u : 1u << rises;
    }
    if (!(num_double(square) >= 0.0))
        return 0;
    r = num_sqrt(square);
    if (!IS_RECENTRED) {
        root[0] = num_div(num_neg(num_add(b, r)), a);
        root[1] = num_div(num_sub(r, b), a);
        return 3;
    }
    q = num_double(b) > 0.0 ? num_neg(num_add(b, r)) : num_sub(r, b);
    root[num_double(b) > 0.0] = num_div(c, q);
    root[!(num_double(b) > 0.0)] = num_div(q, a);
    return 3;
}

/* False: enough. */
static inline bool report(pov_hits *hits, const pov_ray *ray, const line *l, num t, uint32_t feature)
{
    const num dir = num_add(t, l->middle);
    pov_mark mark = { feature, 0, 0.0, 0.0 };

    if (ray->origin_surface == hits->owner && num_double(dir) < SHADOW_EPSILON)
        return true;
    return pov_cross(hits, num_double(dir), num_rest(dir), mark);
}

/* The point of a crossing, seen from the anchor: textbooks take it from the world's. */
static inline num3 point_of(const pov_ray *ray, const pov_crossing *at, num3 anchor)
{
    const num3 o = num3_of(ray->org, ray->org_lo), d = num3_of(ray->dir, ray->dir_lo);

    return num3_sub(num3_add(o, num3_scale(d, num_of2(at->t, at->t_lo))), anchor);
}

#define METHODS_PLUGIN(keyword, shape)                                        \
    static const pov_shape_class *const shapes[] = { &(shape), NULL };        \
    POV_PLUGIN(keyword) = { .abi = POV_PLUGIN_ABI, .size = sizeof(pov_plugin), .name = #keyword, .version = "0", \
                            .shapes = shapes }

#endif
