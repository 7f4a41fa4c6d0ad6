/* blend.h - which members of a map, a list or an average count at each point, and how much. */
#ifndef TEXTURE_BLEND_H
#define TEXTURE_BLEND_H

#include "base/lanes.h"
#include "texture/texture.h"

/* Lane i has the share 1 - between[i] of member low[i], and the rest of the next one; of an average each lane has a
 * share of all. */
typedef struct blending {
    blend kind;
    const float *values;
    float total;                 /* of an average's weights */
    const texture_part *parts;
    uint32_t last;               /* the member of lanes without parts */
    uint32_t n;
    uint64_t present;            /* bit k: lanes may have a share of member k, or of k and a multiple of 64 */
    uint32_t low[LANES_MAX];
    double between[LANES_MAX];
} blending;

/* From the values of a pattern at n points; an average needs none. Lanes up to lanes_whole(n) may be read. */
void blend_find(blending *b, blend kind, const float *values, uint32_t count, const double *value, uint32_t n);
/* Find which members are there, for blend_lanes() to be quicker. */
void blend_mark(blending *b);
/* From the parts that n points are on, of `count` members. */
void blend_find_parts(blending *b, const texture_part *parts, uint32_t count, uint32_t n);
/* The lanes that have a share of a member, and it. Returns how many. */
uint32_t blend_lanes(const blending *b, uint32_t member, uint8_t *lane, float *share);

#endif
