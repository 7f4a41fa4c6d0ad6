/* relief_walk.h - rays over a grid of heights, many side by side: from cell to cell, and past whole squares that they do not come near. */
#ifndef COMMON_RELIEF_WALK_H
#define COMMON_RELIEF_WALK_H

#include "common/relief.h"

enum { COMMON_WALK_LANES = 16, COMMON_WALK_MOST = 1 << 11 };

/* Of a relief's levels: the least height of a part, and the greatest times 65536. */
typedef struct common_relief_ranges {
    const uint32_t *at;          /* NULL: the grid is too large */
    int32_t wide, deep, top;     /* cells; the last level */
    uint32_t pitch, count;       /* of cells in memory: whole parts of the last level; a level has a sixteenth of the one before */
    float off;                   /* what a place may be off, in cells */
} common_relief_ranges;

bool common_relief_ranges_make(common_relief_ranges *g, const common_relief *r, const pov_host *host, pov_reader *in);

typedef float common_walk_lane[COMMON_WALK_LANES];
typedef int32_t common_walk_bits[COMMON_WALK_LANES];

/* By lane, in cells and 1/65536: a ray from o along d, t from 0 to `to`, which is rounded up. */
typedef struct common_walk {
    common_walk_lane o[3], d[3], to;
    common_walk_lane inverse[2], t, behind;             /* along x and z; where it is, and how much before that is looked at too */
    common_walk_bits x, z, level;
    common_walk_bits goes;                         /* all bits: on */
    common_walk_bits is_near;                      /* at a cell that it may hit */
    common_walk_bits unsure;                       /* so near a corner of cells that it may pass others */
    common_walk_bits past;                         /* the cell is known not to be hit */
} common_walk;

/* o, d, to and goes are there. */
void common_walk_begin(const common_relief_ranges *g, common_walk *w);
/* One that has begun, from lane i of others. */
void common_walk_load(common_walk *w, uint32_t lane, const common_walk *from, uint32_t i);
/* Those that go on do so, until they are near a cell, or unsure, or have passed: then they go no more. It ends as soon as `most` of them go at
 * most; which, as bits. */
uint32_t common_walk_on(const common_relief_ranges *g, common_walk *w, uint32_t most);

#endif
