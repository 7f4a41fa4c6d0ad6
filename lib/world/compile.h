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
    bool placed, packs;
    uint8_t class_number;        /* in class_counts */
    uint32_t count;
    uint32_t stride;             /* bytes from instance to instance */
    unsigned char *instances;    /* of shapes that are not placed, in the order of the runs */
} shape_group;

/* Make an object's instance of what was written, in instance_size bytes. */
void flat_make(const leaf_node *o, void *instance);

enum { FLAT_CASTS = 1, FLAT_OPAQUE = 2, FLAT_PLAIN = 4, FLAT_INFINITE = 0x8000, FLAT_MEMBER = 0x4000, FLAT_LARGE = 256, FLAT_MANY = 1 << 17 };

/* What is known of a model's objects while the world is built. Arrays are by object: by leaf, and behind the leaves by
 * tree. A leaf of a tree is a member: it is laid out as others are, but no ray is handed it. */
typedef struct flat {
    const env *env;
    const model *model;
    model *last;                 /* the same, if no other world is to come of it; NULL: it must stay as it is */
    bool use_blocks;
    bool large_stay;             /* see flat_stays() */
    int threads;
    arena *staging;              /* by thread: copies that have absorbed a transformation, until runs take them */
    arena *kept;                 /* by thread: instances of shapes that are placed, and of others that stay */
    const void **moved;          /* instances of those with a transformation; NULL: no object has one */
    pov_box *boxes;              /* the same, of finite ones */
    uint16_t *group;
    world_thing *things;         /* in slot first FLAT_CASTS to FLAT_PLAIN, until runs tell slot and group */
    uint32_t *maps;              /* bytes that the transformations of those that are placed take in a row; as moved */
    shape_group *groups;
    bool *packs;                 /* by group: do its shapes share leaves of the tree? */
    size_t group_count;
    uint32_t *finite, *infinite, *members;   /* objects, in the order of the scene, trees behind leaves */
    uint32_t finite_count, infinite_count, member_count;
    uint8_t *is_member;          /* by leaf; NULL: there is no tree */
    csg_list trees;
    csg_root *roots;             /* by tree: what an object's instance is to others */
    leaf_node *tree_leaves;      /* by tree: as objects are told of */
    pov_box bounds;              /* around the finite ones, if there are any */
    pov_box clear;               /* around those that light passes; the other way round if there are none */
    size_t absorbed, composed, packed;
    size_t scratch;              /* the most working memory that a shape asks for */
} flat;

/* Do instances of a class that have absorbed a transformation stay where they were made, unless they share a run? Then they
 * are not copied, but lie in the order of the scene: of few objects rays lose more than is saved. */
static inline bool flat_stays(const flat *f, const shape_class *shape)
{
    return f->large_stay && shape->instance_size >= FLAT_LARGE;
}

/* use_blocks: whether shapes may share blocks. What flat_free() frees is there after a failure too. */
pov_status flatten(flat *f, const model *m, bool use_blocks, int threads, pov_error *err);
/* How many there are, trees included, and what is told of one. */
static inline uint32_t flat_count(const flat *f) { return (uint32_t)(f->model->leaves.count + f->model->trees.count); }
static inline const leaf_node *flat_leaf(const flat *f, uint32_t index)
{
    const size_t n = f->model->leaves.count;

    return index < n ? &f->model->leaves.items[index] : &f->tree_leaves[index - n];
}
/* For this room, once all leaves are known: the trees behind them, of a class by that mark. */
bool flat_add_trees(flat *f, uint16_t mark);
/* For this room: a further object of that box, NULL: without. */
void flat_take(flat *f, uint32_t index, const pov_box *box);
/* The box of a finite object, as flatten() saw it. Any thread. */
void flat_box(const flat *f, uint32_t index, pov_box *out);
/* The placements of up to PLACEMENT_MANY objects whose groups are placed, by what was composed of their transformations.
 * Made anew, so that they are kept in one place only. Any thread. */
void flat_place(const flat *f, const uint32_t *ids, const pov_affine *maps, int n, placement *out);
/* By object, 1: it lets light pass and nothing else comes near its box. NULL: nothing does, or there is too much to look
 * at. False: no memory. */
bool flat_find_lonely(const flat *f, uint8_t **lonely);
/* Boxes are not asked for any more. */
void flat_drop_boxes(flat *f);
/* Nor are the model's transformations, if this is its last world. */
void flat_drop_maps(flat *f);
void flat_free(flat *f);
void flat_free_groups(const env *e, shape_group *groups, size_t count);
void flat_free_arenas(const env *e, arena *arenas, int count);

#endif
