/* scatter.h - the rays that go on from surfaces. */
#ifndef SHADE_SCATTER_H
#define SHADE_SCATTER_H

#include "shade/surface.h"

/* The reflected and the transmitted rays of surfaces that are complete; what the batches held is overwritten. */
void scatter(shade_context *c, const surfaces *on, batch *reflected, batch *transmitted);

#endif
