/* path.h - rays on their way, and batches of them.
 *
 * The picture's value is a sum over all rays that a camera ray leads to, so none waits for another's result: a list of
 * those still to be followed takes the place of recursion. */
#ifndef SHADE_PATH_H
#define SHADE_PATH_H

#include "shade/dielectric.h"
#include "shade/geometry.h"

typedef struct path {
    coefficient factor;          /* the product of the coefficients on the way here, and of their weights */
    int level;                   /* 1: the camera ray */
    uint32_t lane;               /* whose camera ray it comes from */
    uint32_t coincident, above;  /* it starts on coincident surfaces: those of context->coincident_sets, counted from 1,
                                  * and its sides of them; coincident set 0: it does not */
    dielectric_span inside;      /* the dielectrics that it is in */
    int zero_steps;              /* crossings in a row that did not move the ray: see query/passage.h */
} path;

/* A packet of paths: of neighbouring camera rays the same way on, at most one of each, ordered by lane. So what a camera
 * ray's paths give is added up in the same order in any packet, and alone. */
enum { BATCH_MAX = WORLD_MANY };
typedef struct batch {
    uint32_t count;
    bool camera;                 /* these are camera rays: nothing has been added to their colours yet */
    path paths[BATCH_MAX];
    const pov_ray *rays[BATCH_MAX];   /* of the paths: the caller's camera rays, or those in `own` */
    SIMD_ALIGNED pov_ray own[BATCH_MAX];
    struct batch *next;          /* of those that are spare */
} batch;

#endif
