/* scatter.h - reflected and transmitted rays of surfaces. */
#ifndef SHADE_SCATTER_H
#define SHADE_SCATTER_H

#include "shade/batch.h"
#include "shade/layers.h"

/* Add the reflected and the transmitted rays of completed surfaces to the branches. */
void scatter(shade_context *c, surfaces *on, batch_queue *q);
/* The same of a chunk of layers. Rays of one hit with the same direction and weight are one. */
void scatter_layers(shade_context *c, layers *l, batch_queue *q);

#endif
