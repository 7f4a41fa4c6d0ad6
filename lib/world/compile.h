/* compile.h - from a model's objects to shapes: which share what, where each stands, and what was made of its
 * transformation. What rays want side by side is laid out by leaf_layout.c. */
#ifndef WORLD_COMPILE_H
#define WORLD_COMPILE_H

#include "base/arena.h"
#include "base/share.h"
#include "model/model.h"
#include "world/csg.h"
#include "world/leaf_batch.h"
#include "world/world.h"

/* Shapes of one class that are stored and asked alike. */
typedef struct shape_group {
    const shape_class *shape;
    bool instanced, shares_leaf;
    uint8_t class_number;        /* in class_counts */
    uint32_t count;
    uint32_t stride;             /* bytes from instance to instance */
    unsigned char *instances;    /* of shapes that are not placed, in the order of the leaf batches */
} shape_group;

/* Make an object's instance of what was written, in instance_size bytes. */
void compile_make(const leaf_node *o, void *instance);

enum { COMPILE_CASTS = 1, COMPILE_OPAQUE = 2, COMPILE_PLAIN = 4, COMPILE_INFINITE = 0x8000, COMPILE_MEMBER = 0x4000,
       COMPILE_LARGE = 256, COMPILE_MANY = 1 << 17 };

/* What is known of a model's objects while the world is built. Arrays are by object: by leaf, and behind the leaves by
 * tree. A leaf of a tree is a member: it is laid out as others are, but no ray is handed it. */
typedef struct compile_state {
    const env *env;
    const model *model;
    model *last;                 /* the same, if no other world is to come of it; NULL: it must stay as it is */
    bool use_blocks;
    bool large_resident;         /* see compile_is_resident() */
    int threads;
    arena *staged;               /* by thread: copies that have absorbed a transformation, until runs take them */
    arena *resident;             /* by thread: instances of shapes that are placed, and of others that stay */
    const void **moved;          /* instances of those with a transformation; NULL: no object has one */
    pov_box *boxes;              /* the same, of finite ones */
    uint16_t *group;
    object_info *objects_info;   /* in slot first COMPILE_CASTS to COMPILE_PLAIN, until runs tell slot and group */
    uint32_t *maps;              /* bytes that the transformations of those that are placed take in a row; as moved */
    shape_group *groups;
    bool *shares_leaf;           /* by group: do its shapes share leaves of the tree? */
    size_t group_count;
    uint32_t *finite, *infinite, *members;   /* objects, in the order of the scene, trees behind leaves */
    uint32_t finite_count, infinite_count, member_count;
    uint8_t *is_member;          /* by leaf; NULL: there is no tree */
    csg_list trees;
    csg_root *roots;             /* by tree: what an object's instance is to others */
    leaf_node *tree_leaves;      /* by tree: as objects are told of */
    pov_box bounds;              /* around the finite ones, if there are any */
    pov_box transparent;         /* around those that light passes; the other way round if there are none */
    size_t absorbed, composed, packed;
    size_t scratch;              /* the most working memory that a shape asks for */
} compile_state;

/* Do instances of a class that have absorbed a transformation stay where they were made, unless they share a leaf
 * batch? Then they are not copied, but lie in the order of the scene: of few objects rays lose more than is saved. */
static inline bool compile_is_resident(const compile_state *f, const shape_class *shape)
{
    return f->large_resident && shape->instance_size >= COMPILE_LARGE;
}

/* use_blocks: whether shapes may share blocks. What compile_free() frees is there after a failure too. */
pov_status compile_objects(compile_state *f, const model *m, bool use_blocks, int threads, pov_error *err);
/* How many there are, trees included, and what is told of one. */
static inline uint32_t compile_count(const compile_state *f)
{
    return (uint32_t)(f->model->leaves.count + f->model->trees.count);
}
static inline const leaf_node *compile_leaf(const compile_state *f, uint32_t index)
{
    const size_t n = f->model->leaves.count;

    return index < n ? &f->model->leaves.items[index] : &f->tree_leaves[index - n];
}
/* For this room, once all leaves are known: the trees behind them, of a class by that mark. */
bool compile_add_trees(compile_state *f, uint16_t mark);
/* For this room: a further object of that box, NULL: without. */
void compile_take(compile_state *f, uint32_t index, const pov_box *box);
/* The box of a finite object, as compile_objects() saw it. Any thread. */
void compile_box(const compile_state *f, uint32_t index, pov_box *out);
/* The instance transforms of n objects whose groups are placed, by what was composed of their
 * transformations. Made anew, so that they are kept in one place only. Any thread. */
void compile_instances(const compile_state *f, const uint32_t *ids, const pov_affine *maps, int n, instance_xform *out);
/* By object, 1: it lets light pass and nothing else comes near its box. NULL: nothing does, or there is too much to look
 * at. False: no memory. */
bool compile_find_isolated(const compile_state *f, uint8_t **isolated);
/* Boxes are not asked for any more. */
void compile_drop_boxes(compile_state *f);
/* Nor are the model's transformations, if this is its last world. */
void compile_drop_maps(compile_state *f);
void compile_free(compile_state *f);
void compile_free_groups(const env *e, shape_group *groups, size_t count);
void compile_free_arenas(const env *e, arena *arenas, int count);

#endif
