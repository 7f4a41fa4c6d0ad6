/* leaf_layout.h - laying out what rays ask: runs of shapes, and instances side by side in the order of the leaf
 * batches.
 *
 * First every leaf batch's size is asked, then memory is found, then they are filled. Both passes go by parts, each
 * of which may have a thread of its own; where things come to lie depends on the order of the parts only. */
#ifndef WORLD_LEAF_LAYOUT_H
#define WORLD_LEAF_LAYOUT_H

#include "world/compile.h"

/* Of a part: its objects and the transformations of its placed ones, among all; the next of both to be looked at, and
 * of what was placed last how many there are and are used. */
typedef struct leaf_layout_slice {
    uint32_t ids, next_id;
    size_t maps, next;
    int ready, used;
} leaf_layout_slice;

typedef struct leaf_layout {
    compile_state *state;
    uint32_t slices;
    leaf_layout_slice *of;       /* by part, and one behind the last */
    unsigned char *maps;         /* see leaf_layout_take_maps(); NULL: the model still has them */
    instance_xform *ready;       /* by part TRANSFORM_MANY: made before they are wanted, for many are composed at once */
    uint32_t *at;                /* by part and group: how many instances; then the place of the next */
    const unsigned char *base;   /* what runs are being filled, and the bit that tells which */
    uint32_t mark;
} leaf_layout;

/* The slot of a shape that is placed, or whose instance stays where it was made: where its leaf batch is, in lines of
 * memory from the start of the leaves or, with the other bit, of the lists. Else its place among its group's
 * instances. */
#define LEAF_SINGLE 0x40000000u
#define LEAF_IN_LISTS 0x80000000u
enum { LEAF_LINE = 64 };

bool leaf_layout_init(leaf_layout *r, compile_state *f, uint32_t slices);
/* How many bytes the leaf batches of these objects take. ids are put in order. Parts but the first are of the flat's
 * finite objects, one after the other. rest: so many ids may be read ahead. */
size_t leaf_layout_size(leaf_layout *r, uint32_t slice, uint32_t *ids, uint32_t count, uint32_t rest);
/* When all sizes have been asked: room for the instances. */
bool leaf_layout_allocate(leaf_layout *r);
/* The same objects in the same order within each part, into `base`; memory need not be zeroed. frame: what they stand in,
 * or NULL. */
void leaf_layout_fill(leaf_layout *r, uint32_t slice, const bvh_frame *frame, const uint32_t *ids, uint32_t count,
                      void *at);
/* Before the first fill of part `first`, if all parts from there on are of the flat's finite objects one after the other
 * and this is the model's last world: their transformations are put in the order in which they are wanted, so that
 * the model's can go before the leaves come, and they themselves bit by bit. */
bool leaf_layout_take_maps(leaf_layout *r, uint32_t first);
/* That part and all behind it are filled. */
void leaf_layout_filled(leaf_layout *r, uint32_t slice);
void leaf_layout_free(leaf_layout *r);

#endif
