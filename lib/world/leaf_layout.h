/* leaf_layout.h - lays out the data that rays read: leaf batches, and instances side by side in the order of the
 * batches.
 *
 * First the sizes of all leaf batches are computed, then memory is allocated, then they are filled. Both passes work by
 * slices, which may run in several threads; positions depend on the order of the slices only. */
#ifndef WORLD_LEAF_LAYOUT_H
#define WORLD_LEAF_LAYOUT_H

#include "world/compile.h"

/* State of a slice: offsets of its objects and of the packed transformations of its instanced ones; the next of both;
 * and the number of instance transforms made in advance and used. */
typedef struct leaf_layout_slice {
    uint32_t ids, next_id;
    size_t maps, next;
    int ready, used;
} leaf_layout_slice;

typedef struct leaf_layout {
    compile_state *state;
    uint32_t slices;
    leaf_layout_slice *of;       /* by slice, and one behind the last */
    unsigned char *maps;         /* see leaf_layout_take_maps(); NULL: the model still has them */
    instance_xform *ready;       /* by part TRANSFORM_MANY: made before they are wanted, for many are composed at once */
    uint32_t *at;                /* by slice and group: number of instances; then the index of the next */
    const unsigned char *base;   /* memory of the batches being filled, and the bit that identifies it */
    uint32_t mark;
} leaf_layout;

/* The slot of a shape with an instance transform, or whose instance stayed in its memory: the position of its leaf
 * batch, in cache lines from the start of the leaves or, with the other bit, of the lists. Else its index among its
 * group's instances. */
#define LEAF_SINGLE 0x40000000u
#define LEAF_IN_LISTS 0x80000000u
enum { LEAF_LINE = 64 };

bool leaf_layout_init(leaf_layout *r, compile_state *f, uint32_t slices);
/* Bytes of the leaf batches of these objects. ids are sorted. Slices except the first hold the finite objects, one
 * after the other. rest: so many ids may be read ahead. */
size_t leaf_layout_size(leaf_layout *r, uint32_t slice, uint32_t *ids, uint32_t count, uint32_t rest);
/* Allocate the instances, after all sizes are known. */
bool leaf_layout_allocate(leaf_layout *r);
/* Fill the batches of the same objects in the same order within each slice, into `base`; memory need not be zeroed.
 * frame: their frame, or NULL. */
void leaf_layout_fill(leaf_layout *r, uint32_t slice, const bvh_frame *frame, const uint32_t *ids, uint32_t count,
                      void *at);
/* Call before the first fill of slice `first`, if all slices from there on hold the finite objects one after the other
 * and this is the model's last world: their transformations are packed in the order of use, so that the model's can be
 * freed before the leaves are allocated, and the packed ones as they are used. */
bool leaf_layout_take_maps(leaf_layout *r, uint32_t first);
/* That slice and all behind it are filled. */
void leaf_layout_filled(leaf_layout *r, uint32_t slice);
void leaf_layout_free(leaf_layout *r);

#endif
