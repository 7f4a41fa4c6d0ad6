/* compile.h - compiles a model's objects to shapes: their groups, positions, and absorbed or composed transformations.
 * leaf_layout.c lays out the data that rays need. */
#ifndef WORLD_COMPILE_H
#define WORLD_COMPILE_H

#include "base/arena.h"
#include "base/share.h"
#include "model/model.h"
#include "world/copy.h"
#include "world/csg.h"
#include "world/leaf_batch.h"
#include "world/world.h"

/* Shapes of one class with the same storage and queries. */
typedef struct shape_group {
    const shape_class *shape;
    bool instanced, shares_leaf;
    uint8_t class_number;        /* in class_counts */
    uint32_t count;
    uint32_t stride;             /* bytes from instance to instance */
    unsigned char *instances;    /* of shapes without an instance transform, in the order of the leaf batches */
} shape_group;

/* Make an object's instance from its parsed form, in instance_size bytes. */
void compile_make(const leaf_node *o, void *instance);

enum { COMPILE_CASTS = 1, COMPILE_OPAQUE = 2, COMPILE_PLAIN = 4, COMPILE_INFINITE = 0x8000, COMPILE_MEMBER = 0x4000,
       COMPILE_LARGE = 256, COMPILE_MANY = 1 << 17 };
/* Alignment of instances, in bytes. */
enum { COMPILE_ALIGN = 32 };
/* Each class has three groups of shapes, in this order; an object's mark is COMPILE_KINDS * class + kind until they are
 * made, and COMPILE_INFINITE or COMPILE_MEMBER with it. */
enum { COMPILE_SINGLE, COMPILE_SHARES_LEAF, COMPILE_INSTANCED, COMPILE_KINDS };

/* State of the compilation. Arrays are by object: by leaf, behind the leaves by tree, and behind these by copy. A leaf of a tree is a member:
 * it is laid out as others, but rays are not tested against it directly. */
typedef struct compile_state {
    const env *env;
    const model *model;
    model *last;                 /* the same, if no other world will be made of it; NULL: it must stay unchanged */
    bool use_blocks;
    bool located;                /* transmittance of light depends on where it crosses any surface */
    bool clear_members;          /* as the plan has it */
    bool large_resident;         /* see compile_is_resident() */
    int threads;
    arena *staged;               /* by thread: copies that have absorbed a transformation, until leaf batches take
                                  * them */
    arena *resident;             /* by thread: instances of shapes with an instance transform, and of others that
                                  * stay */
    const void **moved;          /* instances of objects with a transformation; NULL: no object has one */
    pov_box *boxes;              /* their boxes, of finite ones */
    uint16_t *group;
    object_info *objects_info;   /* slot holds COMPILE_CASTS to COMPILE_PLAIN until leaf batches set slot and group */
    uint32_t *maps;              /* bytes of packed transformations of instanced objects; indexed as moved */
    shape_group *groups;
    bool *shares_leaf;           /* by group: do its shapes share leaves of the tree? */
    size_t group_count;
    uint32_t *finite, *infinite, *members;   /* object indices in the order of the scene, trees behind leaves */
    uint32_t finite_count, infinite_count, member_count;
    uint8_t *is_member;          /* by leaf; NULL: there is no tree */
    uint8_t *is_twin;            /* by leaf: see compile_find_twins(); NULL: there are too many to look for them */
    csg_list trees;
    csg_root *roots;             /* by tree: its instance */
    leaf_node *tree_leaves;      /* by tree: as of objects */
    world *const *parts;         /* worlds of the model's parts, made before */
    size_t part_count;
    copy_root *copies;           /* by copy: its instance, and as of objects */
    leaf_node *copy_leaves;
    pov_box bounds;              /* around the finite objects, if there are any */
    pov_box transparent;         /* around transparent objects; inverted if there are none */
    size_t absorbed, composed, packed;
    size_t scratch;              /* the largest working memory of a shape */
} compile_state;

/* Do instances of a class that have absorbed a transformation stay in their memory, unless they share a leaf batch?
 * Then they are not copied, but lie in the order of the scene; with few objects the loss for rays exceeds the
 * saving. */
static inline bool compile_is_resident(const compile_state *f, const shape_class *shape)
{
    return f->large_resident && shape->instance_size >= COMPILE_LARGE;
}

/* use_blocks: whether shapes may share blocks; parts: worlds of the model's parts. On failure call compile_free() as
 * well. */
pov_status compile_objects(compile_state *f, const model *m, const plan *needs, world *const *parts, bool use_blocks, int threads,
                           pov_error *err);
/* The number of objects, trees and copies included, and the record of one. */
static inline uint32_t compile_count(const compile_state *f)
{
    return (uint32_t)model_own_names(f->model);
}
static inline const leaf_node *compile_leaf(const compile_state *f, uint32_t index)
{
    const size_t n = f->model->leaves.count;

    if (index < n)
        return &f->model->leaves.items[index];
    return index - n < f->trees.count ? &f->tree_leaves[index - n] : &f->copy_leaves[index - n - f->model->trees.count];
}
/* For this room: which leaves are members of trees. */
void compile_mark_members(compile_state *f);
/* For this room, after it: which leaves hide behind an earlier one in the same place. False: no memory. */
bool compile_find_twins(compile_state *f);
/* For this room, once all leaves are known: add the trees behind them, with that class mark. */
bool compile_add_trees(compile_state *f, uint16_t mark);
/* The same of copies, behind the trees. */
pov_status compile_add_copies(compile_state *f, uint16_t mark, pov_error *err);
/* For this room, from the marks: number the groups that have members, and list the objects, in the order of the scene.
 * False: no memory. */
bool compile_make_groups(compile_state *f, const shape_class *const *classes, size_t count);
/* For this room: add an object with that box, NULL: without. */
void compile_take(compile_state *f, uint32_t index, const pov_box *box);
/* The box of a finite object, as in compile_objects(). Any thread. */
void compile_box(const compile_state *f, uint32_t index, pov_box *out);
/* The instance transforms of n objects whose groups are placed, by what was composed of their
 * transformations. Made anew, so that they are kept in one place only. Any thread. */
void compile_instances(const compile_state *f, const uint32_t *ids, const pov_affine *maps, int n, instance_xform *out);
void compile_find_lamps(const compile_state *f, world_lamps *out);
/* The half-space that an infinite object is. False: it is none. */
bool compile_half_space(const compile_state *f, uint32_t index, pov_half_space *out);
/* False: no memory. */
bool compile_find_isolated(const compile_state *f, world_isolation *out);
/* Free the boxes. */
void compile_drop_boxes(compile_state *f);
/* Free the model's transformations, if this is its last world. */
void compile_drop_maps(compile_state *f);
void compile_free(compile_state *f);
void compile_free_groups(const env *e, shape_group *groups, size_t count);
void compile_free_arenas(const env *e, arena *arenas, int count);

#endif
