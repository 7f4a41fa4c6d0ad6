/* build.h - between the steps of a build: splitting (split.c), growing the draft of a tree (build.c),
 * laying it out (layout.c). */
#ifndef BVH_BUILD_H
#define BVH_BUILD_H

#include "base/arena.h"
#include "bvh/bvh.h"

/* A thing to be sorted into the tree: its box in the frame's floats, rounded outward. Two vectors of four. */
typedef struct bvh_ref {
    float lo[3];
    uint32_t id;
    float hi[3];
    uint32_t slots;              /* of BVH_WIDTH in a leaf: all, if it stands alone */
} bvh_ref;

/* refs[begin..end) with the box around them and the box around twice their centres. */
typedef struct bvh_range {
    uint32_t begin, end;
    float lo[3], hi[3], centre_lo[3], centre_hi[3];
    float area;                  /* half the surface of the box */
    bool is_leaf;
} bvh_range;

/* The draft is what most of the memory of a build goes for: nothing stands in it but what the layout asks. */
typedef struct bvh_draft_child {
    struct bvh_draft_node *node; /* NULL: a leaf */
    bvh_frame *frame;            /* its own frame, or NULL */
    float lo[3], hi[3];          /* its box in the frame that it is met in */
    uint32_t begin, count;       /* its things */
} bvh_draft_child;

typedef struct bvh_draft_node {
    int count;
    bvh_draft_child child[];
} bvh_draft_node;

static inline uint32_t bvh_range_count(const bvh_range *r) { return r->end - r->begin; }

/* What a binary tree is made of on the way to one of wide nodes. The first is the root. */
typedef struct bvh_build_node {
    bvh_range range;             /* begin, end: of an end, or as it was cut */
    uint32_t half[2];           /* further on in the list */
    int depth;                   /* of the tree, were it a node */
    bool is_end;                 /* not divided here */
    uint8_t to_left[BVH_WIDTH];
    float cost[BVH_WIDTH];       /* of at most 1 to 8 nodes side by side for all below: their surfaces' sum */
} bvh_build_node;

/* Find what nodes cost least (Ylitie, Karras, Laine 2017: Efficient incoherent ray traversal on GPUs through compressed
 * wide BVHs). */
void bvh_weigh_nodes(bvh_build_node *nodes, uint32_t count);
/* The children of the node that build node `which` becomes, which is no end. */
int bvh_children_of(const bvh_build_node *nodes, uint32_t which, uint32_t out[BVH_WIDTH]);

/* threads: who may help, with the same result for any number. */
void bvh_range_measure(bvh_range *r, const bvh_ref *refs, int threads);
/* Cut in two where the surface area heuristic says, or in halves where it says nothing. Reorders refs. */
void bvh_split(const bvh_range *r, bvh_ref *refs, int threads, bvh_range *a, bvh_range *b);
/* Cut in two of equal count, in the order in which they stand. */
void bvh_halve(const bvh_range *r, const bvh_ref *refs, bvh_range *a, bvh_range *b);

/* The frame for what lies within the box. */
bvh_frame bvh_frame_around(const pov_box *all);
/* The box around refs[begin..end), from their true boxes. */
pov_box bvh_box_around(const bvh_input *in, const bvh_ref *refs, uint32_t begin, uint32_t end);
/* Give them their boxes in the frame. */
void bvh_frame_convert(const bvh_frame *frame, const bvh_input *in, bvh_ref *refs, uint32_t begin, uint32_t end);

/* A leaf: the input's ids from `begin` to where the next one begins, where it lies in the leaves' memory, and what frame
 * it stands in. */
typedef struct bvh_leaf { uint32_t begin, at, frame; } bvh_leaf;

/* Turn the draft below `root` into nodes and frames, with leaves counted where places will be, and the input's ids into
 * the order of the leaves. One leaf more marks their end. */
bool bvh_layout(bvh *out, const bvh_input *in, const bvh_draft_child *root, const bvh_ref *refs, bvh_leaf **leaves);
/* Size, place and fill them. The list of leaves is cut as they are filled. */
bool bvh_fill_leaves(bvh *out, const bvh_input *in, bvh_leaf **leaves);

#endif
