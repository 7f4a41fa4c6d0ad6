/* refine.h - tracing where a pixel takes many samples. */
#ifndef RENDER_REFINE_H
#define RENDER_REFINE_H

#include "render/cells.h"
#include "render/worker.h"

/* What a worker needs for it beyond the plain: the claimed tile's halves and groups, copied out. */
struct refinement {
    double *halves;
    group groups[GROUPS * TILE_CELLS_MAX];
    showing shown[GROUPS * TILE_CELLS_MAX];
};

/* NULL: no memory. */
refinement *refinement_make(const env *e, int tile_edge);
void refinement_free(refinement *r, const env *e);

/* Bring the claimed tile's groups to their targets, and its pixels and groups up to date. False: it was given up. */
bool refine_more(worker *w, const settings *s, const cells *c, const encoding *e);

#endif
