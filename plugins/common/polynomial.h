/* polynomial.h - surfaces where a polynomial of x, y and z is zero; inside where it is below. */
#ifndef COMMON_POLYNOMIAL_H
#define COMMON_POLYNOMIAL_H

#include "common/local.h"

enum { COMMON_ORDER_MAX = 35 };

/* The terms with x^i y^j that are not zero: from first[row] on to first[row + 1]. */
typedef struct common_term { double c; int k; } common_term;

/* Coefficients by falling power of x, then of y, then of z. */
typedef struct common_polynomial {
    int order;
    uint32_t count;
    double *at;
    common_term *term;
    uint32_t *first;             /* by row, in the order of the coefficients */
    int *highest;                /* by i, the largest j that is there; -1: none */
    int highest_x, highest_z;
    double *size;                /* by i + j + k, the sum of the sizes of the coefficients */
    double off;                  /* what coefficients along a ray are off by, in sums of the sizes of their terms */
    bool bounded;                /* all of the surface, and of what is inside, is in the box */
    pov_box box;
    double wide, reach;          /* its largest side, and no less than any coordinate and a side together */
    double sizes;                /* of the terms up to there */
} common_polynomial;

/* Memory for all coefficients, zero. False after an error. */
bool common_polynomial_make(common_polynomial *p, const pov_host *host, pov_reader *in, int order);
/* The place of a term: x^i y^j z^k. */
uint32_t common_polynomial_place(int order, int i, int j, int k);
/* All coefficients between < and >, and `sturm`. */
void common_polynomial_read(common_polynomial *p, const pov_host *host, pov_reader *in, int order);

/* To be called when all coefficients are there. */
void common_polynomial_close(common_polynomial *p, const pov_host *host, pov_reader *in);
/* Looks for a box around it. False: none was found. */
bool common_polynomial_find_box(const common_polynomial *p, pov_box *out);

/* ---- along a ray ---- */

/* No less than the sum of the sizes of all terms where no coordinate is larger than `reach`. */
static inline double common_polynomial_size(const common_polynomial *p, double reach)
{
    double sum = p->size[p->order];

    for (int m = p->order - 1; m >= 0; m--)
        sum = sum * reach + p->size[m];
    return sum;
}

/* No coordinate is larger along a stretch, with what rounding makes of where it begins. */
static inline double common_polynomial_reach(const common_ray *k, pov_vec3 from, double length)
{
    return pov_largest(from) + pov_largest(k->d) * length + common_far_slack(k);
}

/* Of a ray to a surface without end: it comes as far beyond the origin as it is before it. What is farther is searched by the inverse of the
 * distance. */
static inline double common_polynomial_ahead(const common_ray *k) { return 2.0 * pov_largest(pov_two3_hi(k->f)); }

/* Coefficients in the distance from o along d, order + 1 of them; the last ones may be zero. */
void common_polynomial_along(const common_polynomial *p, pov_vec3 o, pov_vec3 d, double *out);
/* For coefficients along a ray, a power of two about as large as the nearer roots are. */
double common_polynomial_near(const double *c, int degree);

/* The value at a point, and the slope. */
double common_polynomial_at(const common_polynomial *p, pov_vec3 at, pov_vec3 *slope);

/* A crossing as double has it, at a distance t from a base, and the slope there along the ray. On a stretch of that length, `size` is no less
 * than the sum of the terms' sizes. */
typedef struct common_polynomial_root { double base, t, slope, size, length; } common_polynomial_root;

/* What a distance may be off by, from the start of the ray at a point. */
COMMON_INLINE double common_polynomial_allowed(const common_polynomial *p, double at, double reach)
{
    const double wide = reach < p->wide ? reach : p->wide, near = 0x1p-48 * fabs(at), all = 0x1p-44 * wide;

    return near < all ? near : all;
}

/* A value at a point that was rounded twice is off by n sums and n products of Horner's schemes, and 2 n factors; one more is for what those
 * make of each other. */
COMMON_INLINE double common_polynomial_value_off(const common_polynomial *p, double sizes) { return COMMON_U * (4.0 * p->order + 1.0) * sizes; }

/* By the value at the crossing: is the distance certainly as good as is allowed? Where the slope is known to a half, and so far does not change
 * by more. Above 0: yes. */
COMMON_INLINE double common_polynomial_trust(const common_polynomial *p, const common_polynomial_root *r, double value, double sizes, double step)
{
    const double n = p->order, per = 1.0 / r->length, slope = fabs(r->slope);
    const double straight = slope > n * r->size * per * (2.0 * n * per * step + 4.0 * p->off) ? 1.0 : 0.0;

    return fabs(value) + common_polynomial_value_off(p, sizes) <= 0.5 * step * slope ? straight : 0.0;
}

/* A root as the value and the slope at a place near by have it, where no coordinate is larger than `reach`, nor one of the ray's direction
 * than two. */
COMMON_INLINE common_polynomial_root common_polynomial_step(double t, double value, double slope, double sizes, double reach)
{
    const common_polynomial_root next = { 0.0, t - value / slope, slope, sizes, 0.5 * reach };

    return next;
}

/* The point at a distance. */
COMMON_INLINE pov_vec3 common_polynomial_point(const common_ray *k, pov_two at)
{
    const pov_vec3 w = common_along(k, at.hi);

    return pov_vec3_of(w.x + at.lo * k->d.x, w.y + at.lo * k->d.y, w.z + at.lo * k->d.z);
}

/* The distance from the base in double-double: the only root between lo and hi. */
pov_two common_polynomial_complete(const common_polynomial *p, const common_ray *k, const common_polynomial_root *root, double lo, double hi, bool rising);
bool common_polynomial_is_inside_two(const common_polynomial *p, pov_two3 at);
/* All crossings. */
void common_polynomial_intersect_two(const common_polynomial *p, const pov_ray *ray, pov_hits *hits);
/* A crossing in the ray's local units. False: nothing more is wanted. */
static inline bool common_polynomial_report(const common_ray *k, pov_two at, uint32_t flags, pov_hits *hits)
{
    const pov_mark mark = { 0, flags, 0.0, 0.0 };

    return pov_cross(hits, at.hi * k->unit, at.lo * k->unit, mark);
}

/* Functions of the class. */
bool common_polynomial_bounds(const void *self, pov_box *out);
void common_polynomial_intersect(const void *self, const pov_ray *ray, pov_hits *hits);
/* Without lanes. */
void common_polynomial_intersect_single(const void *self, const pov_ray *ray, pov_hits *hits);
void common_polynomial_intersect_between(const void *self, const pov_ray *ray, pov_hits *hits);
void common_polynomial_normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out);
void common_polynomial_intersect_between_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n);
void common_polynomial_intersect_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n);
void common_polynomial_normal_many(const void *const *selves, const pov_ray *const *rays, const pov_crossing *const *at,
                                   pov_vec3 *const *out, uint32_t n);
bool common_polynomial_inside(const void *self, pov_vec3 point, pov_vec3 point_lo);

#define COMMON_POLYNOMIAL_CLASS(word, reader)                                                                              \
    static const pov_shape_fast fast = { .size = sizeof(pov_shape_fast),                                                   \
                                         .normal_many = common_polynomial_normal_many,                                     \
                                         .intersect_many = common_polynomial_intersect_many,                               \
                                         .intersect_between = common_polynomial_intersect_between,                         \
                                         .intersect_between_many = common_polynomial_intersect_between_many };             \
    static const void *extension(const char *name) { return common_is_fast(name) ? &fast : NULL; }                         \
    static const pov_shape_class word##_class = {                                                                          \
        .size = sizeof(pov_shape_class),                                                                                   \
        .flags = POV_SHAPE_SOLID | POV_SHAPE_CERTIFIED,                                                                                      \
        .keyword = #word,                                                                                                  \
        .instance_size = sizeof(common_polynomial),                                                                        \
        .parse = reader,                                                                                                   \
        .bounds = common_polynomial_bounds,                                                                                \
        .intersect = common_polynomial_intersect,                                                                          \
        .normal = common_polynomial_normal,                                                                                \
        .inside = common_polynomial_inside,                                                                                \
        .extension = extension,                                                                                            \
    };                                                                                                                     \
    static const pov_shape_class *const shapes[] = { &word##_class, NULL };                                                \
    POV_PLUGIN(word) = { .abi = POV_PLUGIN_ABI, .size = sizeof(pov_plugin), .name = #word, .version = "1", .shapes = shapes }

#endif
