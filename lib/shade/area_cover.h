/* area_cover.h - parts of an area light that a solid certainly hides from a point, and parts that it certainly does not. */
#ifndef SHADE_AREA_COVER_H
#define SHADE_AREA_COVER_H

#include "base/simd.h"
#include "light/grid.h"
#include "query/query.h"

/* The solid, a little smaller, from the point: along the direction to the place u, v of the light's plane, lo <= t (rate . (1, u, v)) <= hi,
 * and constant + 2 t (along . (1, u, v)) + t^2 (square . (1, u, v, u u, v v, u v)) <= 0. */
typedef struct area_cover {
    double lo[3], hi[3], rate[3][3];
    double constant, along[3], square[6];
    double wide_lo[3], wide_hi[3], wide_constant;   /* the same of the solid, a little larger */
    uint32_t slabs;
    bool round;
    bool outside;                /* the point certainly is outside */
    bool apart;                  /* and beyond the quadric, by more than all roundings */
} area_cover;

/* from: the point; to: the direction to the light's position, from which places are measured along the axes. False: nothing can be
 * told. */
bool area_cover_make(area_cover *c, const pov_outline *solid, pov_vec3 from, pov_vec3 to, const pov_vec3 axes[2]);
/* Do the segments to all places of the part start outside of the solid, which is convex, and enter it well before their ends? */
bool area_cover_hides(const area_cover *c, const grid_part *part);
/* Do all of them certainly pass its surface? */
bool area_cover_misses(const area_cover *c, const grid_part *part);

/* Do all rays to places of the part, which start in the solid or on its surface, stay within it until they have left the other solid, from
 * the same point? */
bool area_cover_holds(const area_cover *c, const area_cover *other, const grid_part *part);

/* Parts side by side, in groups of so many; points: each is one place. */
enum { AREA_PARTS = 64, AREA_TOGETHER = 16 };
typedef struct area_parts { SIMD_ALIGNED double lo[2][AREA_PARTS], hi[2][AREA_PARTS]; uint32_t count; bool points; } area_parts;
/* Those of the grid from the k-th one on. */
void area_parts_find(const light_grid *g, uint32_t k, area_parts *out);
area_parts area_parts_of(const grid_part *one);
/* All of them, as bits. */
static inline uint64_t area_parts_all(const area_parts *parts) { return ~(uint64_t)0 >> (AREA_PARTS - parts->count); }
/* Which of these, of those that `which` selects. */
uint64_t area_cover_hides_of(const area_cover *c, const area_parts *parts, uint64_t which);
uint64_t area_cover_misses_of(const area_cover *c, const area_parts *parts, uint64_t which);
/* Which of them overlap another part. */
uint64_t area_parts_overlap(const area_parts *parts, const grid_part *other);

#endif
