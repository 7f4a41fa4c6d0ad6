/* path.h - paths, and batches of them.
 *
 * The picture's value is a sum over all rays that follow from a camera ray, so no ray waits for another's result: a
 * list of rays to be traced replaces recursion. */
#ifndef SHADE_PATH_H
#define SHADE_PATH_H

#include "shade/dielectric.h"
#include "shade/geometry.h"

/* Members that change at each surface come first; a path that continues takes over the others as they are, from `inside` on. */
typedef struct path {
    coefficient factor;          /* product of the coefficients along the path, and of their weights */
    int level;                   /* 1: the camera ray */
    uint32_t lane;               /* lane of its camera ray */
    uint32_t coincident, above;  /* it starts on coincident surfaces: index in context->coincident_sets, counted from 1,
                                  * and its sides of them; 0: it does not */
    dielectric_span inside;      /* the dielectrics around it */
    double travelled;            /* how far a photon came until it started here, or another path from the last surface that
                                  * it sees, across others */
    uint32_t solids;             /* where there is fog or media: how many solids it is in that are not hollow */
    uint32_t branch;             /* mixed from its turns: different paths of a camera ray have different random numbers */
    float clear;                 /* in pictures with alpha: how much of what is behind it shines through; 0: it was reflected */
    float hue;                   /* its place in the spectrum, from red (0) to violet (1), since it was dispersed; or
                                  * PATH_WHITE */
    uint16_t zero_steps;         /* consecutive steps of length zero: see query/passage.h */
    bool mirrored;               /* it was reflected on its way, and not only transmitted */
    bool gathering;              /* its ray gathers light for a diffuse surface */
    bool struck;                 /* of a photon: it met its target */
    uint8_t gathers;             /* how many of its rays did */
    uint8_t draw, draws;         /* the number of the first of these, of how many */
} path;

#define PATH_WHITE (-1.0f)

/* What paths see is raised to a power before it is added to what their origin sees, or is a sample of radiosity that is not
 * added as it is: they and all that follow from them are summed up here. */
typedef struct power_sum {
    uint32_t count;
    bool gathers;                /* samples of radiosity */
    struct reuse *reuse;         /* NULL, or what they find counts for their neighbours too */
    uint32_t lane[WORLD_MANY];
    colour factor[WORLD_MANY];
    float exponent[WORLD_MANY];
    colour seen[WORLD_MANY];     /* by lane of the camera ray */
    colour *out;
    struct power_sum *next;          /* next of the spare ones */
} power_sum;

/* Where rays gather light from: their directions are drawn when their turn comes, as often as each needs it. */
typedef struct gather_origins {
    vec_lanes normal, face;      /* the shading normal, and the geometric one on the side that they leave to */
    uint8_t draws[WORLD_MANY];
    bool outside[WORLD_MANY];    /* the ray to the surface came from outside of the object */
    bool behind[WORLD_MANY];     /* they leave to the other side */
    bool reuses;                 /* what some of the rays find counts for others */
    struct gather_origins *next;         /* next of the spare ones */
} gather_origins;

/* A packet of paths: of neighbouring camera rays with the same history, at most one of each, ordered by lane. So
 * contributions to a camera ray are added in the same order in any packet, and alone. */
enum { BATCH_MAX = WORLD_MANY };
typedef struct batch {
    uint32_t count;
    uint32_t last;               /* lane of the last path; UINT32_MAX: there is none */
    bool camera;                 /* these are camera rays: nothing has been added to their colours yet */
    path paths[BATCH_MAX];
    const pov_ray *rays[BATCH_MAX];   /* rays of the paths: the caller's camera rays, or those in `own` */
    SIMD_ALIGNED pov_ray own[BATCH_MAX];
    colour *out;                 /* where its colours are added, by lane of the camera ray */
    gather_origins *gather;            /* NULL, or these are the origins of rays that gather light */
    power_sum *power;                /* NULL, or what is done with the sum of its colours: `out` is set when it begins */
    struct reuse *reuse;         /* NULL, or where what its rays find is noted */
    struct batch *next;          /* next of the spare batches */
} batch;

#endif
