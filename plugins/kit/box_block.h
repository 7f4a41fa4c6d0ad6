/* box_block.h - up to eight boxes along the axes at once, in plain double: which of them a ray may meet, which surely,
 * where. */
#ifndef KIT_BOX_BLOCK_H
#define KIT_BOX_BLOCK_H

#include "kit/local.h"

typedef struct kit_box_block {
    double plane[6][POV_BLOCK_MAX];  /* lower and upper by axis; a lane without a box has its upper ones below its lower */
    double reach[3];                 /* by axis: no plane is further from the origin */
    uint32_t lanes;                  /* by bits: holds a box */
    bool few;                        /* half of the lanes are enough */
} kit_box_block;

/* For n boxes, the planes of which are then put there. False: out of range. */
void kit_box_begin(kit_box_block *b, uint32_t n);
bool kit_box_put(kit_box_block *b, uint32_t lane, uint32_t plane, double at);
uint32_t kit_box_filter(const void *block, const uint32_t *owners, const pov_rays *rays, uint64_t lanes, pov_meeting *out);

#endif
