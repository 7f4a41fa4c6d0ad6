/* second_order_block.h - filters up to eight quadric surfaces at once, in double: possible and definite hits, with
 * bounds on their distances. */
#ifndef KIT_SECOND_ORDER_BLOCK_H
#define KIT_SECOND_ORDER_BLOCK_H

#include "kit/second_order.h"

typedef struct kit_second_order_block {
    double q[COEFFICIENTS][POV_BLOCK_MAX];   /* for world lengths; D to I halved */
    double anchor[3][POV_BLOCK_MAX];
    double reach[POV_BLOCK_MAX];             /* the anchor's largest component, never zero */
    double sum2[POV_BLOCK_MAX], half1[POV_BLOCK_MAX], sum0[POV_BLOCK_MAX];   /* sums of sizes, by order; the first order
                                                                              * halved */
    int64_t lanes;                           /* by bits */
    bool flat;                               /* all of them are planes */
} kit_second_order_block;

/* selves: kit_second_orders. False: out of range. */
bool kit_second_order_pack(void *block, const pov_frame *frame, const void *const *selves, uint32_t n);
uint32_t kit_second_order_filter(const void *block, const uint32_t *owners, const pov_rays *rays, uint64_t lanes, pov_meeting *out);

#endif
