/* relief.h - the cells of a grid of heights over the unit square that a ray may hit.
 *
 * Squares of four times four cells, and of four times four such squares, know the least and the greatest height in each of their
 * sixteen parts. A ray is held against sixteen parts side by side, in floats that are rounded outward; no step is taken through
 * parts that it cannot hit. */
#ifndef COMMON_RELIEF_H
#define COMMON_RELIEF_H

#include "common/clip.h"

enum { COMMON_RELIEF_SIDE = 4, COMMON_RELIEF_PARTS = 16, COMMON_RELIEF_LEVELS = 8 };

/* The least heights by part, x + 4 z, and then the greatest, in 1/65536. Of what no ray hits the least is above the greatest. */
typedef struct common_relief_square { uint16_t height[2 * COMMON_RELIEF_PARTS]; } common_relief_square;

typedef struct common_relief_level { uint32_t wide, deep; const common_relief_square *at; } common_relief_level;

typedef struct common_relief {
    uint32_t wide, deep;         /* corners along x and z */
    double cell_wide, cell_deep;
    uint32_t levels;
    common_relief_level level[COMMON_RELIEF_LEVELS];   /* of cells first; the last one is a single square */
} common_relief;

/* Of heights by rows along x. Cells with no corner as high as `water`, in 1/65536, are never met. False after an error. */
bool common_relief_make(common_relief *r, const pov_host *host, pov_reader *in, const uint16_t *height, uint32_t wide, uint32_t deep,
                        double water);

/* False: nothing more is wanted. */
typedef bool common_relief_visit(void *user, uint32_t x, uint32_t z);

/* Cells that the line o + t d may hit for t from 0 to `to`. Those that it does pass come in the order in which it does. The largest
 * component of d is in 1..2. */
void common_relief_search(const common_relief *r, pov_vec3 o, pov_vec3 d, double to, common_relief_visit *visit, void *user);

#endif
