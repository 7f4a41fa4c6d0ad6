/* sphere_block.h - filters up to eight spheres at once, in floats: possible and definite hits, with bounds on their
 * distances. */
#ifndef COMMON_SPHERE_BLOCK_H
#define COMMON_SPHERE_BLOCK_H

#include "common/sphere.h"

/* In the frame. Two cache lines: a sphere must take less than 220 bytes of a process that draws a million of them, and
 * data of missed shapes should be close together. */
typedef struct common_sphere_block {
    float x[POV_BLOCK_MAX], y[POV_BLOCK_MAX], z[POV_BLOCK_MAX];
    float radius[POV_BLOCK_MAX];    /* NaN in lanes without a sphere */
} common_sphere_block;

/* selves: common_spheres. */
bool common_sphere_pack(void *block, const pov_frame *frame, const void *const *selves, uint32_t n);
uint32_t common_sphere_filter(const void *block, const uint32_t *owners, const pov_rays *rays, uint64_t lanes,
                              pov_candidate *out);

#endif
