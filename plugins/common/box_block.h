/* box_block.h - filters up to eight axis-aligned boxes at once, in floats: possible and definite hits, with bounds on
 * their distances. */
#ifndef COMMON_BOX_BLOCK_H
#define COMMON_BOX_BLOCK_H

#include "common/local.h"

#include <stddef.h>

/* Planes in the frame, lower and upper by axis. Stored by lane, or one behind the other for a block of a single box.
 * Rows begin with whole vectors. */
typedef struct common_box_block {
    uint32_t count, thin, unused[6];   /* thin: some are thinner than floats can tell, or planar */
    float plane[6][POV_BLOCK_MAX];
} common_box_block;

enum { COMMON_BOX_SINGLE = offsetof(common_box_block, plane) + 6 * sizeof(float) };

/* Prepare a block for n boxes, whose planes are stored afterwards. */
void common_box_begin(common_box_block *b, uint32_t n);
void common_box_put(common_box_block *b, uint32_t lane, uint32_t plane, double at);
uint32_t common_box_filter(const void *block, const uint32_t *owners, const pov_rays *rays, uint64_t lanes,
                           pov_candidate *out);

#endif
