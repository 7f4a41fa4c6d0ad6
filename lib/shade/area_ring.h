/* area_ring.h - parts of an area light that a torus certainly hides from a point, and parts that it certainly does not. */
#ifndef SHADE_AREA_RING_H
#define SHADE_AREA_RING_H

#include "shade/area_cover.h"

/* All that lies at most `minor` from the circle of the radius `major` around the y axis, and the point and directions in that space: along
 * to[0] + u to[1] + v to[2] lies the place u, v of the light's plane. */
typedef struct area_ring {
    double major, minor;
    pov_vec3 from, to[3];
    double square[3];            /* of to[1], of to[2], and twice the size of their product */
    area_cover clip;             /* its surface is there within this only */
    uint32_t cuts;               /* slabs of that which are needed, as bits */
    area_cover hollow;           /* hollowed: within this it is not there */
    bool hollowed;
    bool hides;                  /* all of it stops light */
} area_ring;

/* from, to, axes: as area_cover_make() has them. clip, hollow: as that made it, or NULL. False: nothing can be told. */
bool area_ring_make(area_ring *r, const double radii[2], const pov_own_map *own, pov_vec3 from, pov_vec3 to, const pov_vec3 axes[2], const area_cover *clip,
                    const area_cover *hollow);
/* Of these parts, those that all segments to certainly pass it; and in *hidden those to which all certainly cross its surface before
 * their ends, if it hides. */
uint64_t area_ring_misses_of(const area_ring *r, const area_parts *parts, uint64_t which, uint64_t *hidden);
/* The same of one. */
bool area_ring_misses(const area_ring *r, const grid_part *part, bool *hidden);

#endif
