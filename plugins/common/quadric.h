/* quadric.h - the ten coefficients of a quadric surface, about an anchor, in double-double. */
#ifndef COMMON_QUADRIC_H
#define COMMON_QUADRIC_H

#include "common/local.h"

/* A x^2 + B y^2 + C z^2 + D xy + E xz + F yz + G x + H y + I z + J */
enum { A, B, C, D, E, F, G, H, I, J, COEFFICIENTS };

typedef struct common_quadric {
    pov_two3 anchor;
    /* For lengths times scale, multiplied by a power of two so that the largest is of the order of one. */
    pov_two q[COEFFICIENTS];
    double sum2, sum1;             /* sums of sizes, of second and of first order */
    double scale;
    double approx[COEFFICIENTS], size[COEFFICIENTS];  /* of q */
    bool planar;                   /* no second-order terms: a plane */
    bool sizeless;                 /* only second-order terms: a cone, the same at every scale */
    bool closed;                   /* definitely an ellipsoid */
    bool whole;                    /* no coefficient is so small beside the others that q lost bits of it */
    bool stiff;                    /* second-order coefficients so far apart that double-double may lose a crossing */
    int length, largest;           /* exponents of the inverse of scale, and of the divisor */
} common_quadric;

/* From coefficients about the origin, as written. */
void common_quadric_make(common_quadric *s, const double coefficients[COEFFICIENTS]);
/* The same of coefficients in double-double. */
void common_quadric_make_two(common_quadric *s, const pov_two coefficients[COEFFICIENTS]);
/* A box around an ellipsoid. False: not an ellipsoid, or nearly degenerate. */
bool common_quadric_bounds(const common_quadric *s, pov_box *out);
/* The same of the class's member. */
bool common_quadric_ellipsoid(const common_quadric *s, pov_ellipsoid *out);
bool common_quadric_half_space(const void *self, pov_half_space *out);
bool common_quadric_outline(const void *self, pov_outline *out);
uint32_t common_quadric_hull(const void *self, const pov_half_space *within, uint32_t n, pov_half_space *out);
/* False: the map changes angles too much, and s is unchanged. */
bool common_quadric_absorb(common_quadric *s, const pov_affine *map);

/* For one set of coefficients: half the gradient; and without the linear terms the matrix times p. */
pov_two3 common_half_gradient(const pov_two *q, pov_two3 p, bool linear);
/* The value at a point with a known half gradient. */
pov_two common_value(const pov_two *q, pov_two3 p, pov_two3 half_gradient);
/* The value at a point, rounded once. */
pov_two common_exact_value(const pov_two *q, pov_two3 p);

/* The class's members. */
void common_quadric_intersect(const void *self, const pov_ray *ray, pov_hits *hits);
void common_quadric_normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out);
bool common_quadric_inside(const void *self, pov_vec3 point, pov_vec3 point_lo);
void common_quadric_intersect_pairs(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits,
                                    uint32_t n);
void common_quadric_normal_pairs(const void *const *selves, const pov_ray *const *rays, const pov_crossing *const *at,
                                 pov_vec3 *const *out, uint32_t n);

/* The same for shapes that are planes. */
void common_plane_intersect_pairs(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n);
uint64_t common_plane_cross_sure(const void *const *selves, const pov_ray *const *rays, pov_crossing *const *at, pov_contact *const *contacts,
                                 uint32_t n);

/* Many pairs at once; `one` intersects those that double precision leaves open. */
typedef void common_intersect(const void *self, const pov_ray *ray, pov_hits *hits);
typedef void common_normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out);
void common_quadric_intersect_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits,
                                   uint32_t n, common_intersect *one);
void common_quadric_normal_many(const void *const *selves, const pov_ray *const *rays, const pov_crossing *const *at,
                                pov_vec3 *const *out, uint32_t n, common_normal *one);

#endif
