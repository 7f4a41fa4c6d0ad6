/* planar_block.h - filters up to eight planar figures at once, in floats: possible and definite hits, with bounds on
 * their distances. */
#ifndef COMMON_PLANAR_BLOCK_H
#define COMMON_PLANAR_BLOCK_H

#include "common/local.h"

#include <stddef.h>

enum { COMMON_SIDES = 4 };

/* Lengths are scaled and relative to the anchor; corners are below 2. The figure lies within all half planes side . p
 * >= offset; `sure` if it is exactly their intersection. Sides are unit vectors within the plane. */
typedef struct common_planar {
    pov_vec3 anchor, normal;     /* the normal's largest component is in [1, 2) */
    double scale;
    pov_vec3 side[COMMON_SIDES];
    double offset[COMMON_SIDES];
    bool sure;
} common_planar;

/* Three or four corners of a convex figure without short edges; false if they are not that. */
bool common_planar_outline(common_planar *f, const pov_vec3 *corner, uint32_t n);

/* A rectangle around any figure: begun with one corner and a direction in the plane, and extended by the other
 * corners. */
void common_planar_begin(common_planar *f, pov_vec3 corner, pov_vec3 dir);
void common_planar_extend(common_planar *f, pov_vec3 corner);

/* Anchor, normal, sides, their offsets, and the figure's own error: in the frame, with unit normals and sides. Stored
 * by lane, or one behind the other for a block of a single figure. Rows begin with whole vectors. */
enum { COMMON_PLANAR_NUMBERS = 3 + 3 + 3 * COMMON_SIDES + COMMON_SIDES + 1 };

typedef struct common_planar_block {
    uint32_t count, sure, unused[6];   /* sure: by bits */
    float number[COMMON_PLANAR_NUMBERS][POV_BLOCK_MAX];
} common_planar_block;

enum { COMMON_PLANAR_SINGLE = offsetof(common_planar_block, number) + COMMON_PLANAR_NUMBERS * sizeof(float) };

/* False: out of range. */
bool common_planar_pack(common_planar_block *b, const pov_frame *frame, const common_planar *figures, uint32_t n);
uint32_t common_planar_filter(const void *block, const uint32_t *owners, const pov_rays *rays, uint64_t lanes,
                              pov_candidate *out);

#endif
