/* context.h - what all of shading works with: the scene, and one thread's state. */
#ifndef SHADE_CONTEXT_H
#define SHADE_CONTEXT_H

#include "query/query.h"
#include "shade/dielectric.h"
#include "shade/interrupt.h"
#include "shade/shading.h"

#include <povtrace/render.h>

typedef struct spot_stack { spot *items; size_t count, capacity; } spot_stack;

typedef struct shade_context {
    const env *env;
    const shading *scene;
    walker *walker;
    pov_counts counts;
    interrupt interrupt;
    bool failed;                 /* memory ended; what was computed since is worth nothing */
    dielectric_stack dielectrics;   /* of the paths being followed and of those that wait */
    spot_stack spots;            /* of paths and of surfaces, in their order */
} shade_context;

#endif
