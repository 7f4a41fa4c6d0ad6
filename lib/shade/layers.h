/* layers.h - surfaces whose textures are made of several terms: stacks of layers, and shares of stacks.
 *
 * A term becomes a surface of its own at the same hit: it is lit, emits light and scatters rays by itself, by a factor.
 * The surfaces of a batch are taken in chunks; those of one hit follow one another. */
#ifndef SHADE_LAYERS_H
#define SHADE_LAYERS_H

#include "shade/batch.h"
#include "shade/paint.h"
#include "shade/stack.h"

typedef struct layers {
    surfaces on;
    layer of[BATCH_MAX];
    uint32_t surface, term;      /* the next term to be taken: of this surface */
    colour left;                 /* factor of what lies below the last layer that was taken */
} layers;

/* Begin with the first surface. */
void layers_begin(layers *l);
/* Take the next chunk. Its normals, directions, appearances and coefficients are known then. False: there is none. */
bool layers_take(const shade_context *c, layers *l, const surfaces *s, const painted *p);

#endif
