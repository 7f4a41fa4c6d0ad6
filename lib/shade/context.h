/* context.h - shared by all of shading: the scene, and one thread's state. */
#ifndef SHADE_CONTEXT_H
#define SHADE_CONTEXT_H

#include "query/query.h"
#include "shade/dielectric.h"
#include "shade/interrupt.h"
#include "shade/random.h"
#include "shade/shading.h"

#include <povtrace/render.h>

struct photon_maps;
struct photon_view;

typedef struct coincident_stack { coincident_set *items; size_t count, capacity; } coincident_stack;

/* Light that the first surface of a camera ray gathers: see window.h. */
typedef struct lent_light { colour light; bool known; } lent_light;

typedef struct shade_context {
    const env *env;
    const shading *scene;
    query_context *context;
    float *alpha;                /* by lane of the camera ray: how much of the background it hides; NULL: the background is
                                  * opaque */
    const sample_id *samples;    /* by lane of the camera ray; NULL: nothing is random */
    const lent_light *lent;      /* by lane of the camera ray; NULL: nothing is known */
    pov_counts counts;
    interrupt interrupt;
    const bool *blocks;          /* by target of photons: it blocks straight light of the present light source; NULL: none
                                  * does */
    const struct photon_maps *const *photons;   /* by lane of the camera ray; NULL: there are none */
    const struct photon_view *views;   /* the same: see photon/map.h */
    bool photons_fly;            /* photons are traced, and not camera rays */
    bool failed;                 /* out of memory, or exhausted: later results are invalid */
    bool exhausted;              /* more rays followed from one camera ray than may */
    dielectric_stack dielectrics;   /* of the present paths and of waiting ones */
    coincident_stack coincident_sets;   /* of paths and of surfaces, in their order */
} shade_context;

#endif
