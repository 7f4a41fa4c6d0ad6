/* box_block.h - up to eight boxes along the axes at once, in floats: which of them a ray may meet, which surely, where. */
#ifndef KIT_BOX_BLOCK_H
#define KIT_BOX_BLOCK_H

#include "kit/local.h"

typedef struct kit_box_block {
    float plane[6][POV_BLOCK_MAX];   /* in the frame: lower and upper by axis */
    uint32_t count;
} kit_box_block;

/* For n boxes, the planes of which are then put there. */
void kit_box_begin(kit_box_block *b, uint32_t n);
void kit_box_put(kit_box_block *b, uint32_t lane, uint32_t plane, double at);
uint32_t kit_box_filter(const void *block, const uint32_t *owners, const pov_rays *rays, uint64_t lanes, pov_meeting *out);

#endif
