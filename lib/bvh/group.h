/* group.h - rays of a query made ready for a tree, and divided into groups of one kind of traversal. */
#ifndef BVH_GROUP_H
#define BVH_GROUP_H

#include "base/lanes.h"
#include "bvh/traverse.h"

/* As a packet, interleaved, or one after the other. */
typedef struct bvh_group { uint64_t lanes; bvh_traverse_fn *traverse; } bvh_group;
enum { BVH_GROUPS = 9 };

/* Divide those of the first n rays that `which` selects into groups. Returns the number of groups. tree: NULL for a list. */
uint32_t bvh_divide(const bvh *tree, const bvh_kernels *by, const pov_ray *const *rays, uint32_t n, uint64_t which,
                    bool nearest, bvh_group groups[BVH_GROUPS]);

/* Take the rays that `which` selects into the lanes of a traversal: taken, and by lane the index of the caller's ray. Filters
 * look up to `end`. Returns the lanes whose numbers are out of the range that filters and packets are promised. */
uint64_t bvh_take(bvh_traversal *t, const pov_ray *taken[BVH_LANES], uint8_t of[BVH_LANES], const pov_ray *const *rays,
                  uint64_t which, double limit, double end);

/* Rays by lane; `excluded` is that of pov_rays. Those of some lanes: as bits, and their numbers in order; of is NULL: of the first ones. */
typedef struct bvh_ray_lanes {
    const vec_lanes *org, *org_lo, *dir;
    const uint32_t *excluded;
    uint64_t which;
    const uint8_t *of;
} bvh_ray_lanes;

/* Copy n rays to light into the lanes of a traversal. False: they would not be one packet in the tree, and are not copied. NULL: no tree. */
bool bvh_copy_lanes(bvh_traversal *t, const bvh *tree, const bvh_ray_lanes *rays, uint32_t n);
/* As bvh_take() of the n that were copied, of which no records are made. */
uint64_t bvh_take_copied(bvh_traversal *t, uint32_t n, double limit, double end);

#endif
