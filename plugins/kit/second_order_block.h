/* second_order_block.h - up to eight surfaces of the second order at once, in plain double: which of them a ray may
 * meet, which surely, and where. */
#ifndef KIT_SECOND_ORDER_BLOCK_H
#define KIT_SECOND_ORDER_BLOCK_H

#include "kit/second_order.h"

typedef struct kit_second_order_block {
    double q[COEFFICIENTS][POV_BLOCK_MAX];   /* for the world's lengths; of D to I half */
    double anchor[3][POV_BLOCK_MAX];
    double reach[POV_BLOCK_MAX];             /* the anchor's largest component, and never zero */
    double sum2[POV_BLOCK_MAX], half1[POV_BLOCK_MAX], sum0[POV_BLOCK_MAX];   /* of sizes, by order; half of the first */
    int64_t lanes;                           /* by bits */
    bool flat;                               /* planes, all of them */
} kit_second_order_block;

/* selves: each a kit_second_order. False: out of range. */
bool kit_second_order_pack(void *block, const pov_frame *frame, const void *const *selves, uint32_t n);
uint32_t kit_second_order_filter(const void *block, const uint32_t *owners, const pov_rays *rays, uint64_t lanes, pov_meeting *out);

#endif
