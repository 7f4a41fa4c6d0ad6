/* build.h - interfaces between the steps of a build: splitting (split.c), the draft of the tree (build.c), its layout
 * (layout.c). */
#ifndef BVH_BUILD_H
#define BVH_BUILD_H

#include "base/arena.h"
#include "bvh/bvh.h"

/* An object to be sorted into the tree: its box in the frame's floats, rounded outward. Two vectors of four. */
typedef struct bvh_ref {
    float lo[3];
    uint32_t id;
    float hi[3];
    uint32_t slots;              /* slots of the BVH_WIDTH in a leaf: all, if it shares no leaf */
} bvh_ref;

/* refs[begin..end), with the box around them and the box around their centres times two. */
typedef struct bvh_range {
    uint32_t begin, end;
    float lo[3], hi[3], centre_lo[3], centre_hi[3];
    float area;                  /* half the surface of the box */
    bool is_leaf;
} bvh_range;

/* The draft takes most of the memory of a build: it holds only what the layout needs. */
typedef struct bvh_draft_child {
    struct bvh_draft_node *node; /* NULL: a leaf */
    bvh_frame *frame;            /* its own frame, or NULL */
    float lo[3], hi[3];          /* its box in the parent's frame */
    uint32_t begin, count;       /* its objects */
} bvh_draft_child;

typedef struct bvh_draft_node {
    int count;
    bvh_draft_child child[];
} bvh_draft_node;

static inline uint32_t bvh_range_count(const bvh_range *r) { return r->end - r->begin; }

/* Node of the binary tree that is collapsed to wide nodes. The first one is the root. */
typedef struct bvh_build_node {
    bvh_range range;             /* begin, end: range of a leaf's items, or of the node before it was split */
    uint32_t half[2];           /* further on in the list */
    int depth;                   /* its depth in the tree */
    bool is_end;                 /* not split further */
    uint8_t to_left[BVH_WIDTH];
    float cost[BVH_WIDTH];       /* cost of at most 1 to 8 nodes side by side that hold all descendants: the sum of
                                  * their surfaces */
} bvh_build_node;

/* Find the collapse of least cost (Ylitie, Karras, Laine 2017: Efficient incoherent ray traversal on GPUs through
 * compressed wide BVHs). */
void bvh_weigh_nodes(bvh_build_node *nodes, uint32_t count);
/* The children of the wide node for build node `which`, which is no leaf. */
int bvh_children_of(const bvh_build_node *nodes, uint32_t which, uint32_t out[BVH_WIDTH]);

/* threads: how many may help; the result is the same for any number. */
void bvh_range_measure(bvh_range *r, const bvh_ref *refs, int threads);
/* Split by the surface area heuristic, or in halves where it does not apply. Reorders refs. */
void bvh_split(const bvh_range *r, bvh_ref *refs, int threads, bvh_range *a, bvh_range *b);
/* Split into two halves of equal count, in the present order. */
void bvh_halve(const bvh_range *r, const bvh_ref *refs, bvh_range *a, bvh_range *b);

/* The frame for the contents of the box. */
bvh_frame bvh_frame_around(const pov_box *all);
/* The box around refs[begin..end), from their exact boxes. */
pov_box bvh_box_around(const bvh_input *in, const bvh_ref *refs, uint32_t begin, uint32_t end);
/* Convert their boxes to the frame. */
void bvh_frame_convert(const bvh_frame *frame, const bvh_input *in, bvh_ref *refs, uint32_t begin, uint32_t end);

/* A leaf: the input's ids from `begin` to the begin of the next leaf, its position in the leaves' memory, and its
 * frame. */
typedef struct bvh_leaf { uint32_t begin, at, frame; } bvh_leaf;

/* Turn the draft below `root` into nodes and frames; the input's ids are in the order of its ranges. References hold
 * numbers of leaves at first. An additional leaf marks the end. */
bool bvh_layout(bvh *out, const bvh_input *in, const bvh_draft_child *root, bvh_leaf **leaves);
/* Size, place and fill the leaves. The list of leaves is shortened as they are filled. */
bool bvh_fill_leaves(bvh *out, const bvh_input *in, bvh_leaf **leaves);

#endif
