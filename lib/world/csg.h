/* csg.h - trees of shapes that rays meet as one: merge, intersection, difference, and unions in them.
 *
 * A tree is one object of the world, of a class of the host's own. Its members are leaves of the scene: they have their
 * instances, normals and materials, but rays ask them through the tree only. docs/numerics.md ("Solids made of others")
 * has the rules. */
#ifndef WORLD_CSG_H
#define WORLD_CSG_H

#include "base/env.h"
#include "model/model.h"
#include "world/instance.h"

/* In the mark of a crossing that a tree reports: there the ray enters the solid. */
#define CSG_MARK_ENTERS 0x08000000u

/* Values along a ray: of a member 0 or 1, of a union the sum of its children's, of a merge 1 if any is not 0, of an
 * intersection 0 if any is 0, else 1 and what the children have more than 1. An inverse node has 1 for 0, else 0. */
typedef struct csg_state { int32_t zeros, sum, value; } csg_state;

typedef struct csg_node {
    node_op op;                  /* a difference has become an intersection */
    bool inverse;
    bool definite_pair;          /* inverse two times: as it was, but for values above 1 */
    uint32_t parent;             /* of the root its own index, 0 */
    uint32_t child, child_count; /* among the tree's children, each a member or, with NODE_GROUP, a node */
} csg_node;

typedef struct csg_member {
    const shape_class *shape;
    const void *instance;
    const instance_xform *xform; /* NULL: own space is the world */
    uint32_t leaf, node;         /* its index in the model; the node that it is a child of */
    bool inverse;                /* the node takes its complement */
    bool turned;                 /* where it is left the solid is entered, where it is the only one that counts */
    bool boxed;                  /* else it may reach without end */
    bool absent;                 /* it is nowhere near the tree, and always outside */
    pov_box box;
} csg_member;

/* Around some members: around one of them, or the next of these around one half and `other` around the other. */
typedef struct csg_bound { pov_box box; uint32_t member, other; } csg_bound;

typedef struct csg_tree {
    csg_member *members;         /* in the order of the text: their leaves follow each other */
    csg_node *nodes;             /* the first is the root */
    csg_state *outside;          /* by node, where no member is entered */
    node_ref *children;
    csg_bound *bounds;           /* around the members that have an end; the first around all */
    uint32_t *endless;           /* members without */
    uint32_t member_count, node_count, child_count, bounds_count, endless_count;
    bool boxed, empty;           /* boxed: it has an end; empty: its members hold nothing together */
    double size;                 /* the largest coordinate of the boxes */
    pov_box box;
} csg_tree;

struct csg_list { csg_tree *items; uint32_t count; };
typedef struct csg_list csg_list;

/* What stands for a tree where others have an instance. */
typedef struct csg_root { const csg_tree *tree; } csg_root;
extern const shape_class csg_class;

/* What a tree has to know of a member before it has an instance. */
typedef struct csg_extent { bool boxed; pov_box box; } csg_extent;
typedef void csg_extent_of(const void *user, uint32_t leaf, csg_extent *out);

/* For csg_make(): boxes of the members, which may be moved, and of the tree. */
bool csg_find_bounds(csg_tree *t, const env *e, csg_extent_of *extent, const void *user);
/* The trees of a model; false: no memory. csg_free() frees what is there in any case. */
bool csg_make(csg_list *out, const model *m, csg_extent_of *extent, const void *user);
void csg_free(csg_list *all, const env *e);

typedef struct csg_near { double t; uint32_t bound; } csg_near;

/* One thread's memory for walks. What hits->user points to begins with a pointer to it. */
typedef struct csg_scratch {
    const env *env;
    pov_crossing *crossings;
    uint32_t capacity;
    csg_state *states;           /* by node */
    uint8_t *inside;             /* by member; zero between walks */
    uint32_t *asked;             /* members whose crossings were asked for */
    csg_near *near;              /* bounds still to be opened, the nearest first: a heap */
    bool failed;                 /* memory ended; stays so */
} csg_scratch;
typedef struct csg_user { csg_scratch *scratch; } csg_user;

bool csg_scratch_init(csg_scratch *s, const csg_list *all, const env *e);
void csg_scratch_free(csg_scratch *s);

/* The class's calls. */
void csg_intersect(const void *self, const pov_ray *ray, pov_hits *hits);
bool csg_inside(const void *self, pov_vec3 point, pov_vec3 point_lo);
/* The value of a node by those of its children. */
int32_t csg_value(const csg_node *n, const csg_state *s);

#endif
