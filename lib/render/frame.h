/* frame.h - the pixels of a job, and how they look while some are missing. */
#ifndef RENDER_FRAME_H
#define RENDER_FRAME_H

#include "model/model.h"
#include "render/encode.h"
#include "render/tiles.h"

enum { LATTICES_MAX = 5 };       /* steps 16, 8, 4, 2, 1 */

typedef struct frame {
    const tiles *tiles;
    int first_step, passes;      /* the coarsest lattice; 1 + log2 of it */
    float *pixels;               /* red, green, blue, alpha as computed; only what `done` vouches for */
    uint8_t *done;               /* for each tile a bit for each pass that is in */
} frame;

/* False: no memory. The tiles must outlive the frame. */
bool frame_make(frame *f, const env *e, const tiles *t, int first_step);
void frame_free(frame *f, const env *e);
void frame_clear(frame *f);
lattice frame_lattice(const frame *f, int pass);
/* Take in a pass of a tile; pixels are the tile's, row by row, of which those of the pass's lattice count. */
void frame_put(frame *f, size_t tile, int pass, const float *pixels);
/* Memory for one of `parts` parts of the picture is asked for from the system. Needs no lock. */
void frame_touch(const frame *f, size_t part, size_t parts);
/* Memory that will soon be written to is sent for. Needs no lock. */
void frame_expect(const frame *f, pov_rect part);
/* Take in all pixels of a tile whose passes are all in. */
void frame_replace(frame *f, size_t tile, const float *pixels);
bool frame_has(const frame *f, size_t tile);
/* A row from here on, of which every pass is in. */
const float *frame_pixels(const frame *f, int x, int y);
/* What stands for a part of a row that lies in one tile: the pixels of the tile's finest whole lattice at or before it.
 * Returns the lattice's step: each of them stands for all columns to the next multiple of it, counted from the tile's
 * corner. Nothing is in yet: zeros, for the whole of the tile. */
int frame_row(const frame *f, size_t tile, int x, int y, int width, float *out);

/* From values as computed to what is read: linear light, and bytes as the scene asks. */
typedef struct encoding { double decode; encoder display; } encoding;

void encoding_make(encoding *e, const gamma *g);
/* In place. */
void encoding_linear(const encoding *e, float *rgba, int count);
/* The row is used up. Alpha is full, but for pixels of which nothing is known yet. */
void encoding_display(const encoding *e, float *rgba, unsigned char *out, int count);

#endif
