/* framebuffer.h - the pixels of a job, and their preview while some are missing. */
#ifndef RENDER_FRAMEBUFFER_H
#define RENDER_FRAMEBUFFER_H

#include "model/model.h"
#include "render/encode.h"
#include "render/tiles.h"

enum { LATTICES_MAX = 5 };       /* steps 16, 8, 4, 2, 1 */

typedef struct framebuffer {
    const tiles *tiles;
    int first_step, passes;      /* the coarsest lattice; 1 + log2 of it */
    bool again;                  /* the last pass traces all pixels: what they show depends on their neighbours in it */
    float *pixels;               /* red, green, blue, alpha as computed; valid where `done` says so */
    uint8_t *done;               /* for each tile one bit for each finished pass */
} framebuffer;

/* False: no memory. The tiles must outlive the frame. */
bool framebuffer_make(framebuffer *f, const env *e, const tiles *t, int first_step);
void framebuffer_free(framebuffer *f, const env *e);
void framebuffer_clear(framebuffer *f);
lattice framebuffer_lattice(const framebuffer *f, int pass);
/* Store a pass of a tile; pixels are the tile's, row by row, of which the pixels of the pass's lattice are valid. */
void framebuffer_put(framebuffer *f, size_t tile, int pass, const float *pixels);
/* Ask the system for the memory of one of `parts` parts of the picture. Needs no lock. */
void framebuffer_touch(const framebuffer *f, size_t part, size_t parts);
/* Prefetch memory that will soon be written to. Needs no lock. */
void framebuffer_prefetch(const framebuffer *f, pov_rect part);
/* Store all pixels of a tile whose passes are finished. */
void framebuffer_replace(framebuffer *f, size_t tile, const float *pixels);
bool framebuffer_has(const framebuffer *f, size_t tile);
/* The row from here on; all passes of it are finished. */
const float *framebuffer_pixels(const framebuffer *f, int x, int y);
/* Preview of a part of a row within one tile: the pixels of the tile's finest complete lattice at or before it. Returns
 * the lattice's step: each pixel stands for all columns up to the next multiple of the step, counted from the tile's
 * corner. No lattice is complete: zeros, for the width of the tile. */
int framebuffer_row(const framebuffer *f, size_t tile, int x, int y, int width, float *out);

/* From computed values to the formats that programs read: linear light, and bytes as the scene asks. */
typedef struct encoding { double decode; bool decodes_srgb; encoder display; } encoding;

void encoding_make(encoding *e, const gamma *g);
/* In place. What shines before a background that alpha lets through is decoded as the opaque light that it is part of. */
void encoding_linear(const encoding *e, float *rgba, int count);
/* The row is overwritten. Alpha is full, but for pixels of which nothing is known yet. */
void encoding_display(const encoding *e, float *rgba, unsigned char *out, int count);

#endif
