/* scatter.h - reflected and transmitted rays of surfaces. */
#ifndef SHADE_SCATTER_H
#define SHADE_SCATTER_H

#include "shade/surface.h"

/* The reflected and the transmitted rays of completed surfaces; the batches are overwritten. */
void scatter(shade_context *c, const surfaces *on, batch *reflected, batch *transmitted);

#endif
