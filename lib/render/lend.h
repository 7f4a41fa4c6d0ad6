/* lend.h - radiosity: what neighbouring pixels of a claimed tile gather together; see shade/window.h. */
#ifndef RENDER_LEND_H
#define RENDER_LEND_H

#include "render/worker.h"

/* Find it for the first samples of the tile's pixels, if the scene's rays may lend; w->lends says so. False: given up, or the tracer
 * failed. */
bool lend_find(worker *w, const settings *s);

#endif
