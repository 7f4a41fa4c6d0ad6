/* refine.h - tracing many samples a pixel. */
#ifndef RENDER_REFINE_H
#define RENDER_REFINE_H

#include "render/cells.h"
#include "render/worker.h"

/* Additional memory of a worker. sums: as in cells. NULL: no memory. */
refinement *refinement_make(const env *e, int tile_edge, int sums);
void refinement_free(refinement *r, const env *e);

/* Trace the samples that the claimed tile's groups still need, and update its pixels and groups. False: given up. */
bool refine_more(worker *w, const settings *s, const cells *c, const encoding *e);

#endif
