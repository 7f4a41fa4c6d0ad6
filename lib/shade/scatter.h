/* scatter.h - reflected and transmitted rays of surfaces. */
#ifndef SHADE_SCATTER_H
#define SHADE_SCATTER_H

#include "shade/batch.h"
#include "shade/surface.h"

/* Add the reflected and the transmitted rays of completed surfaces to the branches. */
void scatter(shade_context *c, const surfaces *on, batch_queue *q);

#endif
