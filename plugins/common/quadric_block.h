/* quadric_block.h - filters up to eight quadric surfaces at once, in double: possible and definite hits, with
 * bounds on their distances. */
#ifndef COMMON_QUADRIC_BLOCK_H
#define COMMON_QUADRIC_BLOCK_H

#include "common/quadric.h"

typedef struct common_quadric_block {
    double q[COEFFICIENTS][POV_BLOCK_MAX];   /* for world lengths; D to I halved */
    double anchor[3][POV_BLOCK_MAX];
    double reach[POV_BLOCK_MAX];             /* the anchor's largest component, never zero */
    double sum2[POV_BLOCK_MAX], half1[POV_BLOCK_MAX], sum0[POV_BLOCK_MAX];   /* sums of sizes, by order; the first order
                                                                              * halved */
    int64_t lanes;                           /* by bits */
    bool planar;                             /* all of them are planes */
} common_quadric_block;

/* selves: common_second_orders. False: out of range. */
bool common_quadric_pack(void *block, const pov_frame *frame, const void *const *selves, uint32_t n);
uint32_t common_quadric_filter(const void *block, const uint32_t *owners, const pov_rays *rays, uint64_t lanes, pov_candidate *out);
/* block_bounds() of planes. */
void common_plane_bounds(const void *block, uint32_t lane, const pov_rays *rays, uint64_t lanes, double *lo, double *hi);

#endif
