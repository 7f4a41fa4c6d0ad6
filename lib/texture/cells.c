#include "texture/cube.h"
#include "texture/pattern.h"

/* POV-Ray moves points by this in the pattern's space, so that faces on whole coordinates are of one colour. */
static const double nudge = 1e-10;

/* A random number for each cube of side 1. */
static void evaluate(const pattern_input *in, double *value)
{
    const noise_tables *t = in->noise;

    for (uint32_t i = 0; i < in->n; i++)
        value[i] = t->cell[noise_hash(t, cube_of(floor(in->at->x[i] + nudge)), cube_of(floor(in->at->y[i] + nudge)),
                                      cube_of(floor(in->at->z[i] + nudge)))];
}

const pattern_class pattern_cells = {
    .keyword = "cells",
    .flags = PATTERN_NEEDS_NOISE,
    .evaluate = evaluate,
};
