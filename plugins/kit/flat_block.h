/* flat_block.h - filters up to eight planar figures at once, in floats: possible and definite hits, with bounds on
 * their distances. */
#ifndef KIT_FLAT_BLOCK_H
#define KIT_FLAT_BLOCK_H

#include "kit/local.h"

#include <stddef.h>

enum { KIT_SIDES = 4 };

/* Lengths are scaled and relative to the anchor; corners are below 2. The figure lies within all half planes side . p
 * >= offset; `sure` if it is exactly their intersection. Sides are unit vectors within the plane. */
typedef struct kit_flat {
    pov_vec3 anchor, normal;     /* the normal's largest component is in [1, 2) */
    double scale;
    pov_vec3 side[KIT_SIDES];
    double offset[KIT_SIDES];
    bool sure;
} kit_flat;

/* Three or four corners of a convex figure without short edges; false if they are not that. */
bool kit_flat_outline(kit_flat *f, const pov_vec3 *corner, uint32_t n);

/* A rectangle around any figure: begun with one corner and a direction in the plane, and extended by the other
 * corners. */
void kit_flat_begin(kit_flat *f, pov_vec3 corner, pov_vec3 way);
void kit_flat_extend(kit_flat *f, pov_vec3 corner);

/* Anchor, normal, sides, their offsets, and the figure's own error: in the frame, with unit normals and sides. Stored
 * by lane, or one behind the other for a block of a single figure. Rows begin with whole vectors. */
enum { KIT_FLAT_NUMBERS = 3 + 3 + 3 * KIT_SIDES + KIT_SIDES + 1 };

typedef struct kit_flat_block {
    uint32_t count, sure, unused[6];   /* sure: by bits */
    float number[KIT_FLAT_NUMBERS][POV_BLOCK_MAX];
} kit_flat_block;

enum { KIT_FLAT_ALONE = offsetof(kit_flat_block, number) + KIT_FLAT_NUMBERS * sizeof(float) };

/* False: out of range. */
bool kit_flat_pack(kit_flat_block *b, const pov_frame *frame, const kit_flat *figures, uint32_t n);
uint32_t kit_flat_filter(const void *block, const uint32_t *owners, const pov_rays *rays, uint64_t lanes, pov_meeting *out);

#endif
