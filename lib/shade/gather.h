/* gather.h - radiosity: rays that gather light for diffuse surfaces.
 *
 * From a surface that the camera sees, there and through mirrors and glass, go as many rays as the scene's settings say;
 * from those that these hit one, until there are as many bounces as the scene wants. Their directions are spread by the
 * cosine, so each sees an equal share. What comes straight from light sources is added at every hit as it is everywhere. */
#ifndef SHADE_GATHER_H
#define SHADE_GATHER_H

#include "shade/batch.h"
#include "shade/layers.h"

/* Add the origins of such rays to the queue: those of a batch's surfaces, or of layers. */
void gather_begin(shade_context *c, const surfaces *on, batch_queue *q);
void gather_begin_layers(shade_context *c, const layers *l, batch_queue *q);

/* Is there some ray that needs another draw? */
bool gather_has_draw(const batch *b, uint32_t draw);
/* Make q->now the rays of a draw from these origins. False: no memory. */
bool gather_draw(shade_context *c, batch_queue *q, batch *from, uint32_t draw);
/* Does all that rays of this scene find look the same from everywhere? */
bool gather_is_even(const shading *s);
/* What a sample counts for. */
colour gather_sample(const radiosity_settings *r, colour seen);

#endif
