/* cells.h - error estimates of a picture with many samples a pixel: the sums of both halves of the samples, and the
 * error that they show, in square cells small enough to follow the picture and large enough for a reliable mean. */
#ifndef RENDER_CELLS_H
#define RENDER_CELLS_H

#include "render/framebuffer.h"
#include "render/settings.h"

/* The pixels of a cell form two groups, like the black and the white fields of a chess board. The measurements of one
 * group decide the number of samples of the other: a pixel that looks right by chance does not get fewer samples for
 * that, so neither the picture nor the estimate is biased. */
enum { GROUPS = 2 };

/* Cells do not follow the tiles, because tile sizes depend on the number of threads and decisions made by cells must
 * not. */
enum { CELL_EDGE = 4, TILE_CELLS_MAX = (TILE_EDGE_MAX / CELL_EDGE) * (TILE_EDGE_MAX / CELL_EDGE) };

typedef struct group {
    uint32_t count, target;      /* samples that each of its pixels has, and shall have after this pass */
    uint32_t clipped;            /* pixels outside 0 .. 1 in linear light */
} group;

/* Measurements of a group: sums over its pixels. */
typedef struct showing {
    double square, fourth;       /* of the estimated squared error, and of that squared; where errors are alike, the sum's square, as
                                  * often as groups are alike */
    double light[3], light_square;   /* of linear light, and of its mean square */
    double off_square, off_max;  /* against the reference */
} showing;

/* Where each pixel has as many samples as it needs: by its place in the group. */
typedef struct singles {
    uint8_t has[CELL_EDGE * CELL_EDGE / GROUPS], gets[CELL_EDGE * CELL_EDGE / GROUPS];   /* samples now and after this pass: 1 + their binary
                                                                                          * logarithm; 0: none, or no such pixel */
    float square[CELL_EDGE * CELL_EDGE / GROUPS];   /* estimated squared error */
} singles;

/* Of some pixels: their samples, and the sum of their squared errors. */
typedef struct tally { double count, square; } tally;

typedef struct cells {
    int width, height, columns, rows;
    size_t count;
    group *groups;               /* GROUPS of each cell, one after the other */
    singles *singles;            /* the same; a group's count and target are then the most of its pixels; NULL: pixels of a group are alike */
    float *planes;               /* budget_singles.c's, and so are `ranks`; NULL as these */
    tally *ranks;
    showing *shown;              /* the same; NULL when a pixel has one sample and there is no reference */
    double *seconds;             /* processor seconds of each cell; NULL: not measured */
    int sums;                    /* numbers a pixel in `halves` */
    int alike;                   /* the errors of the pixels of so many groups are alike; 0: of none */
    double *halves;              /* the sums of both, three each, and that of alpha if there is alpha; NULL when a pixel
                                  * has one sample */
    const float *reference;      /* linear light, four channels a pixel, the caller's; or NULL */
    bool reference_clipped;      /* it holds nothing outside 0 .. 1 */
} cells;

/* The part of a picture, in cells, that a tile covers. */
typedef struct cell_range { int column, row, columns, rows; } cell_range;

/* A tile's part of all that. */
typedef struct refinement {
    double *halves;
    group groups[GROUPS * TILE_CELLS_MAX];
    showing shown[GROUPS * TILE_CELLS_MAX];
    singles singles[GROUPS * TILE_CELLS_MAX];
} refinement;

/* False: no memory. */
bool cells_make(cells *c, const env *e, const settings *s);
/* Measure the processor time of the cells from now on. False: no memory. */
bool cells_count_time(cells *c, const env *e);
/* Add the time of a pass over a tile to each of the tile's cells. */
void cells_spend(cells *c, pov_rect tile, const double *seconds);
void cells_free(cells *c, const env *e);
void cells_clear(cells *c);
cell_range cells_of(pov_rect tile);
pov_rect cells_rect(const cells *c, int column, int row);
/* Rays of radiosity use what others of their set find: the pixels of one colour of a square of cells. */
enum { SET_CELLS = 2, SET_EDGE = SET_CELLS * CELL_EDGE, SET_PIXELS = SET_EDGE * SET_EDGE / GROUPS, SET_SQUARE = 2 };

/* Light of photons is spread over discs that are several pixels wide: the pixels of a cell are alike. */
enum { ALIKE_SETS = SET_CELLS * SET_CELLS, ALIKE_PHOTONS = GROUPS };

/* Pixels of a group. A corner cell may be so narrow that its second group has none. */
size_t cells_pixels_of_edge(const cells *c, size_t number);
static inline size_t cells_pixels(const cells *c, size_t number)
{
    const bool whole = ((c->width | c->height) & (CELL_EDGE - 1)) == 0;

    return whole ? CELL_EDGE * CELL_EDGE / GROUPS : cells_pixels_of_edge(c, number);
}
/* Variance of the light of the pixels of a group that has some. */
double cells_contrast(const showing *g, size_t pixels);

/* Index of a pixel's group among those of the tile, or among those of the picture. */
static inline size_t group_of(int columns, int x, int y)
{
    return GROUPS * ((size_t)(y / CELL_EDGE) * (size_t)columns + (size_t)(x / CELL_EDGE)) + (size_t)((x ^ y) & 1);
}

/* A pixel's place in its group. */
static inline int place_of(int x, int y) { return y % CELL_EDGE * (CELL_EDGE / GROUPS) + x % CELL_EDGE / GROUPS; }

static inline uint32_t single_count(uint8_t number) { return number > 0 ? 1u << (number - 1) : 0; }
size_t singles_sum(const uint8_t *numbers);
/* Samples of all pixels of a group now and after this pass, and those of the pixel that has the fewest. */
static inline size_t cells_samples(const cells *c, size_t number)
{
    return c->singles ? singles_sum(c->singles[number].has) : cells_pixels(c, number) * c->groups[number].count;
}
size_t cells_samples_due(const cells *c, size_t number);
bool cells_are_due(const cells *c, size_t number);
uint32_t singles_fewest(const uint8_t *numbers);
static inline uint32_t cells_fewest(const cells *c, size_t number)
{
    return c->singles ? singles_fewest(c->singles[number].has) : c->groups[number].count;
}
/* Can `has` and `gets` be those of single pixels of a group? measured: all have samples. */
bool cells_are_singles_possible(const cells *c, size_t number, const uint8_t *has, const uint8_t *gets, bool measured);
static inline uint32_t cells_count(const cells *c, int x, int y)
{
    const size_t number = group_of(c->columns, x, y);

    return c->singles ? single_count(c->singles[number].has[place_of(x, y)]) : c->groups[number].count;
}

/* Copy the data of a tile out, and back in. */
void cells_take(const cells *c, pov_rect tile, refinement *r);
void cells_put(cells *c, pov_rect tile, const refinement *r);
/* The first sample of each pixel of a tile is complete: it becomes the first half's. */
void cells_first(cells *c, pov_rect tile, const framebuffer *f, const encoding *e);
/* Compute the tile's pixels from its halves, four channels each, and measure its cells. */
void cells_measure(const cells *c, pov_rect tile, const encoding *e, refinement *r, float *pixels);

#endif
