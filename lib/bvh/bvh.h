/* bvh.h - a tree of boxes, eight to a node.
 *
 * Boxes are floats in the coordinates of a frame: the world moved to the frame's centre and scaled by a power of two
 * so that the frame's contents lie in the cube -1..1. A part of the scene that is tiny against its frame gets a frame
 * of its own, so that floats are fine enough at every scale. All rounding is outward; see traverse.h for the rays. */
#ifndef BVH_BVH_H
#define BVH_BVH_H

#include "base/env.h"

#include <povtrace/math.h>

enum { BVH_WIDTH = 8 };

/* A reference: two bits of kind, the rest counts nodes, frames, or units of leaf memory. */
#define BVH_KIND 0xc0000000u
#define BVH_NODE 0x00000000u
#define BVH_LEAF 0x40000000u
#define BVH_FRAME 0x80000000u
#define BVH_RETURN 0xc0000000u   /* on a traversal's stack only: return to that frame */
enum { BVH_UNIT = 64 };          /* bytes; leaves start at multiples of it */

/* Limit of the depth, and so of a traversal's stack: each step down pushes at most seven siblings and one return. */
enum { BVH_DEPTH = 56, BVH_STACK = BVH_DEPTH * BVH_WIDTH };

/* Rows of bounds: x low, x high, y low, y high, z low, z high. An unused slot has low = +inf, high = -inf. */
typedef struct bvh_node {
    float bounds[6][BVH_WIDTH];
    uint32_t child[BVH_WIDTH];
} bvh_node;

typedef struct bvh_frame {
    pov_vec3 centre;
    double scale;                /* frame = (world - centre) * scale */
    uint32_t root;
} bvh_frame;

typedef struct bvh {
    bvh_node *nodes;
    bvh_frame *frames;           /* the first is the whole scene's */
    unsigned char *leaves;
    size_t node_count, frame_count, leaf_count, leaf_bytes;
    int depth;
} bvh;

/* The caller defines the contents of leaves. First all sizes are queried, then `allocate` is called once, then all
 * leaves are filled. Calls for leaves of one slice come one at a time and in the same order both times, those of
 * different slices from several threads. Leaves hold up to BVH_WIDTH objects; size may reorder ids, and fill gets them
 * so. Slices are filled from the last to the first, and `filled` reports progress. */
enum { BVH_SLICES = 512 };

typedef struct bvh_leaves {
    /* Size of a leaf of the first `count` of the slice's `rest` remaining ids; no other thread reads these
     * meanwhile. */
    size_t (*size)(void *user, uint32_t slice, uint32_t *ids, uint32_t count, uint32_t rest);
    bool (*allocate)(void *user, const void *leaves);   /* leaves: the memory to be filled */
    void (*fill)(void *user, uint32_t slice, const bvh_frame *frame, const uint32_t *ids, uint32_t count, void *at);
    void (*filled)(void *user, uint32_t slice);  /* that slice and all behind it are filled */
    void *user;
} bvh_leaves;

typedef struct bvh_input {
    const env *env;
    /* By id: finite, within +-1e150. Any thread. */
    void (*box)(void *user, uint32_t id, pov_box *out);
    void (*drop)(void *user);    /* boxes are not needed any more; may be NULL */
    void *box_user;
    pov_box bounds;              /* around all of them */
    uint32_t *ids;               /* objects of the tree, at least one; left in the order of the leaves */
    uint32_t count;
    /* Objects of one group share leaves if the group allows it; others get leaves of their own. By id, and by group. */
    const uint16_t *group;
    const bool *shares_leaf;
    bool bounds_leaf;            /* where all is one leaf: a node above it holds its box, as nothing else tells who misses it */
    int threads;
    bvh_leaves leaves;
} bvh_input;

/* Builds the same tree for any number of threads. False: no memory. */
bool bvh_build(bvh *out, const bvh_input *in);
void bvh_free(bvh *b, const env *e);

#endif
