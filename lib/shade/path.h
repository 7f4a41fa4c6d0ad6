/* path.h - paths, and batches of them.
 *
 * The picture's value is a sum over all rays that follow from a camera ray, so no ray waits for another's result: a
 * list of rays to be traced replaces recursion. */
#ifndef SHADE_PATH_H
#define SHADE_PATH_H

#include "shade/dielectric.h"
#include "shade/geometry.h"

typedef struct path {
    coefficient factor;          /* product of the coefficients along the path, and of their weights */
    int level;                   /* 1: the camera ray */
    uint32_t lane;               /* lane of its camera ray */
    uint32_t coincident, above;  /* it starts on coincident surfaces: index in context->coincident_sets, counted from 1,
                                  * and its sides of them; 0: it does not */
    dielectric_span inside;      /* the dielectrics around it */
    int zero_steps;              /* consecutive steps of length zero: see query/passage.h */
} path;

/* A packet of paths: of neighbouring camera rays with the same history, at most one of each, ordered by lane. So
 * contributions to a camera ray are added in the same order in any packet, and alone. */
enum { BATCH_MAX = WORLD_MANY };
typedef struct batch {
    uint32_t count;
    bool camera;                 /* these are camera rays: nothing has been added to their colours yet */
    path paths[BATCH_MAX];
    const pov_ray *rays[BATCH_MAX];   /* rays of the paths: the caller's camera rays, or those in `own` */
    SIMD_ALIGNED pov_ray own[BATCH_MAX];
    struct batch *next;          /* next of the spare batches */
} batch;

#endif
