/* window.h - radiosity: the light that first surfaces of neighbouring pixels gather, continuous over the picture.
 *
 * Pixels form blocks, and each corner of blocks has a window: the up to four blocks around it. Of each small cell of a block the first
 * surface of one pixel, drawn by chance, sends a ray. What the rays of a window find counts for all of its pixels that see it, as in a
 * set (see reuse.h), if it looks the same from everywhere; surfaces that may have sent the ray count by their chance. A pixel's light is
 * the mean of those of the four windows around it, by bilinear weights of its place between their corners. These depend on nothing
 * else: so the mean is the same as that of rays of the pixel's own. */
#ifndef SHADE_WINDOW_H
#define SHADE_WINDOW_H

#include "shade/tracer.h"

enum { WINDOW_BLOCK = 8, WINDOW_CELL = 2 };

typedef struct windows windows;

/* For tiles of so many pixels at most. NULL: no memory. */
windows *windows_make(const env *e, int tile_edge);
void windows_free(windows *w, const env *e);
/* Can light be found so in this scene? */
bool windows_are_possible(const shade_context *c);
/* Begin with a tile of so many blocks. Around it lies a margin of one more block to each side. */
void windows_begin(windows *w, int columns, int rows);
/* The camera rays of a block, from -1 to columns or rows: all that it has in the picture. pixels: their places in the block, row by row.
 * Blocks that are not told are not in the picture. x, y: the block's corner in the picture. */
void windows_add(windows *w, pov_tracer *t, int column, int row, uint32_t n, const pov_ray *rays, unsigned known, const sample_id *samples,
                 const uint8_t *pixels, uint64_t key);
/* Trace the rays that gather. False: given up, or the tracer failed. */
bool windows_gather(windows *w, pov_tracer *t);
/* The light of a pixel of the tile. */
lent_light windows_at(const windows *w, int x, int y);

#endif
