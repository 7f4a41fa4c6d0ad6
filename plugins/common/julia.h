/* julia.h - points of a slice through numbers of four components whose first places under q -> f(q) + c stay within a sphere.
 *
 * Along a ray a number is a + u b, and so is its image under q -> q^2 + c or q^3 + c but for a remainder that is known to be small. So
 * whole stretches of a ray are found to be inside, outside, or to be crossed once; the others are divided. Hypercomplex numbers are
 * pairs of complex ones, on which f acts one by one; of these only spheres are followed. */
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
    double first, shrink, grow;  /* of a ray the first stretch; of a stretch that is open, and of one that is not, the next */
    uint32_t places;             /* n */
    common_julia_function *f;    /* of hypercomplex numbers; NULL: of quaternions, sqr or cube */
    disc power;                  /* of pwr */
    bool is_power, cube, squares;   /* squares: f is the square */
} common_julia;

/* All of it inside or outside, or some of it maybe. A sphere of radius 0 is one or the other. */
typedef enum common_side { COMMON_IN, COMMON_OUT, COMMON_OPEN } common_side;

/* Points side by side, or stretches from p - d to p + d and what is up to `off` beside them. Of each the last place that was looked at,
 * its middle's square of size there, and what is known of it. All bits or none: it is not all outside; some of it may be; it is inside at all
 * places but the last, where the square of size has the sign of its slope. The slope is that for a step of d. */
enum { COMMON_PROBES = 16 };
typedef struct common_probes {
    double p[3][COMMON_PROBES], d[3][COMMON_PROBES], off[COMMON_PROBES];
    int64_t wide[COMMON_PROBES];                            /* a stretch */
    double square[COMMON_PROBES], place[COMMON_PROBES], slope[COMMON_PROBES];
    int64_t left[COMMON_PROBES], open[COMMON_PROBES], sure[COMMON_PROBES];
} common_probes;

static inline void common_probe_put(common_probes *s, uint32_t i, pov_vec3 p, pov_vec3 d, double off, bool wide)
{
    s->p[0][i] = p.x;
    s->p[1][i] = p.y;
    s->p[2][i] = p.z;
    s->d[0][i] = d.x;
    s->d[1][i] = d.y;
    s->d[2][i] = d.z;
    s->off[i] = off;
    s->wide[i] = -(int64_t)wide;
}

static inline common_side common_probe_side(const common_probes *s, uint32_t i)
{
    return !s->left[i] ? COMMON_OUT : s->open[i] ? COMMON_OPEN : COMMON_IN;
}

/* Follow the first n through some places, where the size of what is inside is at most `reach`. Hypercomplex numbers have no slopes, and
 * of their stretches nothing is sure. */
void common_julia_follow(const common_julia *j, uint32_t places, double reach, common_probes *s, uint32_t n);

/* How the square of the number's size at a place changes. */
pov_vec3 common_julia_slope(const common_julia *j, pov_vec3 p, uint32_t place);

/* As the class's functions. */
void common_julia_intersect(const void *self, const pov_ray *ray, pov_hits *hits);
void common_julia_intersect_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n);

#endif
