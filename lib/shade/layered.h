/* layered.h - flat stacks of one material whose layers differ by the pigments alone: all have one appearance, and what the pigments
 * make of each layer stands by lane. */
#ifndef SHADE_LAYERED_H
#define SHADE_LAYERED_H

#include "shade/shading.h"
#include "shade/surface.h"
#include "texture/points.h"

/* A layer of all surfaces. Where it is hidden it emits nothing, and is not lit. */
typedef struct layer_lanes {
    colour_lanes pigment, emitted, by;   /* by: factor of its emitted and reflected light */
    SIMD_ALIGNED float diffuse_weight[BATCH_MAX];
    uint64_t seen;               /* bit i: of surface i */
    const appearance *of;        /* the appearance of its finish */
} layer_lanes;

/* May surfaces of this texture and material be such? */
bool layered_takes(const shading *scene, const texture *of, const material *own);
/* Give them all one appearance, with this stack; the points are those of the surfaces. False: nothing is done, as light goes through
 * some stack. */
bool layered_put(const shading *scene, const texture *of, const texture_points *points, surfaces *s, struct stack *whole, layer_lanes *out);

#endif
