/* ball_block.h - filters up to eight spheres at once, in floats: possible and definite hits, with bounds on their
 * distances. */
#ifndef KIT_BALL_BLOCK_H
#define KIT_BALL_BLOCK_H

#include "kit/ball.h"

/* In the frame. Two cache lines: a sphere must take less than 220 bytes of a process that draws a million of them, and
 * data of missed shapes should be close together. */
typedef struct kit_ball_block {
    float x[POV_BLOCK_MAX], y[POV_BLOCK_MAX], z[POV_BLOCK_MAX];
    float radius[POV_BLOCK_MAX];    /* NaN in lanes without a sphere */
} kit_ball_block;

/* selves: kit_balls. */
bool kit_ball_pack(void *block, const pov_frame *frame, const void *const *selves, uint32_t n);
uint32_t kit_ball_filter(const void *block, const uint32_t *owners, const pov_rays *rays, uint64_t lanes, pov_meeting *out);

#endif
