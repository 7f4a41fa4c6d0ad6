/* families.h - where the probes come from: the stiff and extreme cases, one family a kind of trouble. */
#ifndef NUMERICS_FAMILIES_H
#define NUMERICS_FAMILIES_H

#include "numerics/probe.h"

typedef struct family {
    const char *name;
    double parameter;
    uint32_t kinds;                 /* bit k: kind k has it */
    void (*make)(probe *p, double parameter);   /* the shape and the ray, but for p->kind, which is set */
} family;

/* Ends with a NULL name. The last ones, named "torture", mix all the others. */
extern const family families[];

/* A generator of its own, so that a seed gives the same probes everywhere. */
void families_seed(uint64_t seed);
double families_uniform(void);      /* 0 <= x < 1 */
pov_vec3 families_direction(void);  /* unit, all directions alike */

/* A shape of the kind of p->kind, of size about `size`, about a place. */
void families_shape(probe *p, double size, pov_vec3 place);
/* A point on it and the normal there, near enough, in double. */
void families_point(const probe *p, pov_vec3 place, pov_vec3 *at, pov_vec3 *normal);

#endif
