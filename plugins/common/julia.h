/* julia.h - points of a slice through numbers of four components whose first places under q -> f(q) + c stay within a sphere.
 *
 * A sphere of numbers has an image under f that lies in a sphere that is known, so that whole stretches of a ray are found to be
 * inside or outside; the others are divided. Hypercomplex numbers are pairs of complex ones, on which f acts one by one. */
#ifndef COMMON_JULIA_H
#define COMMON_JULIA_H

#include "common/complex_disc.h"
#include "common/local.h"

typedef struct common_number { double v[4]; } common_number;
typedef disc common_julia_function(disc);

typedef struct common_julia {
    common_number c, slice;      /* slice: a unit vector, the hyperplane's normal */
    double at;                   /* and its distance */
    double reach;                /* of the sphere */
    pov_box box;                 /* around it */
    double shortest;             /* stretches below this are searched no further */
    uint32_t places;             /* n */
    common_julia_function *f;    /* of hypercomplex numbers; NULL: of quaternions, sqr or cube */
    disc power;                  /* of pwr */
    bool is_power, cube;
} common_julia;

/* All of it inside or outside, or some of it maybe. A sphere of radius 0 is one or the other. */
typedef enum common_side { COMMON_IN, COMMON_OUT, COMMON_OPEN } common_side;

/* Spheres of points side by side; and of each the last place that was looked at, its middle's square of size there, and what is
 * known of it. */
enum { COMMON_SPHERES = 8 };
typedef struct common_spheres {
    double x[COMMON_SPHERES], y[COMMON_SPHERES], z[COMMON_SPHERES], off[COMMON_SPHERES];
    double square[COMMON_SPHERES], place[COMMON_SPHERES];
    int64_t left[COMMON_SPHERES], open[COMMON_SPHERES];     /* all bits or none: it is not all outside; some of it may be */
} common_spheres;

static inline void common_spheres_put(common_spheres *s, uint32_t i, pov_vec3 p, double off)
{
    s->x[i] = p.x;
    s->y[i] = p.y;
    s->z[i] = p.z;
    s->off[i] = off;
}

static inline common_side common_spheres_side(const common_spheres *s, uint32_t i)
{
    return !s->left[i] ? COMMON_OUT : s->open[i] ? COMMON_OPEN : COMMON_IN;
}

/* Follow the first n spheres through some places. A middle whose square of size is above `most` is outside. */
void common_julia_follow(const common_julia *j, uint32_t places, double most, common_spheres *s, uint32_t n);

/* How the square of the number's size at a place changes. */
pov_vec3 common_julia_slope(const common_julia *j, pov_vec3 p, uint32_t place);

/* As the class's functions. */
void common_julia_intersect(const void *self, const pov_ray *ray, pov_hits *hits);
void common_julia_intersect_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n);

#endif
