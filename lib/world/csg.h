/* csg.h - trees of shapes that rays intersect as one: merge, intersection, difference, and unions in them.
 *
 * A tree is one object of the world, of a class of the host's own. Its members are leaves of the scene, with their
 * instances, normals and materials, but rays intersect them through the tree only. docs/numerics.md ("Solids made of
 * others") has the rules. */
#ifndef WORLD_CSG_H
#define WORLD_CSG_H

#include "base/env.h"
#include "model/model.h"
#include "world/half_space.h"
#include "world/instance.h"
#include "world/world.h"

/* In the mark of a crossing that a tree reports: the ray enters the solid there. */
#define CSG_MARK_ENTERS 0x08000000u

/* Values along a ray: 0 or 1 for a member; the sum of the children's for a union; 1 for a merge if any is not 0; for an
 * intersection 0 if any is 0, else 1 plus the children's values above 1. An inverse node exchanges 0 and other values:
 * 1 for 0, else 0. */
typedef struct csg_state { int32_t zeros, sum, value; } csg_state;

typedef struct csg_node {
    node_op op;                  /* a difference or clip has become an intersection */
    bool inverse;
    bool nonzero;                /* inverted twice: the original value, with values above 1 reduced to 1 */
    uint32_t parent;             /* parent; of the root 0, its own index */
    uint32_t child, child_count; /* among the tree's children, each a member or, with NODE_GROUP, a node */
} csg_node;

typedef struct csg_member {
    const shape_class *shape;
    const void *instance;
    const instance_xform *xform; /* NULL: own space is the world */
    uint8_t class_number;        /* in class_counts */
    uint32_t leaf, node;         /* its index in the model; its parent node */
    uint32_t same;               /* the earliest member with the same instance and transform: one surface with it */
    bool inverse;                /* the node takes its complement */
    bool turned;                 /* the solid is entered where this member is left, if only this member counts */
    bool boxed;                  /* false: it may be infinite */
    bool needed;                 /* the tree is within it */
    bool absent;                 /* it is far from the tree, and rays are always outside */
    bool hidden;                 /* it clips: its own surface is not visible */
    bool clear;                  /* its surface is not visible, but has part in all else */
    bool open;                   /* its surface has gaps: only inside() tells whether a ray is inside */
    bool patch;                  /* a surface without inside: visible where the tree's value would change by entering it */
    pov_box box;
} csg_member;

/* Bounds of members: of one member, or of two halves: the next bounds, and `other`. */
typedef struct csg_bound { pov_box box; uint32_t member, other; } csg_bound;

/* An infinite member that is no cut. boxed: it is of a part within a box, which a ray that misses the box has nothing of. */
typedef struct csg_endless { uint32_t member; bool boxed; pov_box box; } csg_endless;

/* A member that is a half-space, or its complement; the tree lies within `within`. */
typedef struct csg_cut { pov_half_space within; uint32_t member; } csg_cut;

/* The bounds of all members, where they are few: side by side, so that one loop tests them. */
enum { CSG_FEW = 8, CSG_MANY = 8 };
typedef struct csg_few {
    uint32_t count;              /* 0: there are more; up to CSG_MANY of these hold up to 64 */
    uint32_t bound[CSG_FEW];     /* their indices */
    double lo[3][CSG_FEW], hi[3][CSG_FEW];
} csg_few;

/* An intersection of few members, each bounded and convex, and complements of such: columns of csg_few, as bits. */
enum { CSG_CHORDS_MAX = 64 };
typedef struct csg_chords {
    uint32_t all, within;        /* 0: the tree is another one; those that are no complements */
    uint32_t member[CSG_FEW];
} csg_chords;

/* What the surfaces of few members are, about, side by side: csg_outline.c. */
enum { CSG_COLUMNS = 24, CSG_TABLE_COLUMNS = 6 };

/* A quadric whose square part is `all` (x . x) + of_axis (axis . x)^2, of a sphere without the second one. */
typedef enum csg_turned_kind { CSG_NOT_TURNED, CSG_SPHERE, CSG_TURNED } csg_turned_kind;
typedef struct csg_turned { double all, of_axis; pov_vec3 axis; csg_turned_kind kind; } csg_turned;

typedef struct csg_outline {
    uint32_t count, member[CSG_COLUMNS];     /* columns: of chords theirs, else the members that are not absent */
    uint32_t hidden, bare;       /* columns, as bits: they are not seen; they are quadrics without slabs, of any kind; */
    uint32_t halves;             /* half-spaces, which a ray crosses once */
    uint32_t asked;              /* columns, as bits: members with a box whose crossings no slab or quadric tells; */
    uint32_t held;               /* clips with gaps, which are asked what they hold */
    bool walked;                 /* surfaces with gaps show: the outline only tells which rays pass the tree */
    bool endless;                /* the tree has no box: errors are in parts of distances */
    bool is_product;             /* of columns and complements of columns: the tree holds what is in its factors and in no other column */
    uint32_t factors;            /* then, as bits */
    uint8_t *values;             /* of the tree, by the columns that hold a point, as bits; or NULL */
    uint64_t shows[CSG_TABLE_COLUMNS], grows[CSG_TABLE_COLUMNS];   /* of few columns then, by column and by the others that hold a point, as the number of
                                  * a bit: does the value change where the column is crossed, and is it larger within? */
    uint32_t within, convex;     /* columns that the tree is within, as bits; those of them that are convex */
    bool boxed;                  /* then: behind the columns there is one more, the tree's box, a little wider */
    pov_vec3 centre;             /* of the tree's box; without one, the origin */
    double size, per_size;       /* half of its largest extent, or about that of what the tree has; and the inverse */
    uint32_t slabs, quadrics;    /* filled up to whole vectors */
    uint8_t first_slab[CSG_COLUMNS + 1];     /* by column: the first of its slabs, which stand one behind the other */
    uint32_t round;              /* columns, as bits: they have a quadric, in this order */
    uint8_t quadric[CSG_COLUMNS];            /* by column: which */
    csg_turned *turned;          /* by quadric; NULL where several rays are not held against it */
    double numbers[];
} csg_outline;

/* One surface, clipped by convex solids: their members. shown: some of these show as well. outlined: the tree's outline has the clips
 * as its columns, and nothing else, but for the tree's box where that is needed. loose: some clips have no ends, or are convex along some
 * rays only, so that their outline alone can tell. hollows: then, those of which the complement clips, as bits. */
typedef struct csg_clipped { uint32_t count, surface, clip[CSG_FEW], hollows; bool shown, outlined, loose; } csg_clipped;

typedef struct csg_tree {
    csg_few few, *many;          /* many: of more finite members; NULL: there are too many, or few */
    csg_chords chords;
    csg_clipped clipped;         /* count 0: the tree is another one */
    csg_outline *outline;        /* NULL: not known */
    csg_member *members;         /* in the order of the text: their leaves are consecutive */
    csg_node *nodes;             /* the first is the root */
    csg_state *outside;          /* by node: states outside all members */
    node_ref *children;
    csg_bound *bounds;           /* bounds of the finite members; the first one around all */
    csg_endless *endless;
    uint32_t member_count, node_count, child_count, bounds_count, endless_count, many_count;
    uint32_t open_count;         /* members that are open */
    double open_size;            /* the least of their boxes' largest extents; 0: none has a box */
    bool boxed, empty;           /* boxed: it is finite; empty: its members have nothing in common */
    bool shows_boxed;            /* all of it that shows lies in `shown`, whatever its inside is */
    double size;                 /* the largest coordinate of the boxes */
    pov_box box, shown;
    csg_cut *cuts;               /* of a finite intersection: members that are half-spaces */
    uint32_t cut_count;
} csg_tree;

struct csg_list { csg_tree *items; uint32_t count; };
typedef struct csg_list csg_list;

/* The instance of a tree. */
typedef struct csg_root { const csg_tree *tree; } csg_root;
extern const shape_class csg_class;

/* Is nothing of it ever seen? */
static inline bool csg_is_unseen(const csg_member *m) { return m->hidden || m->clear; }

/* Data of a member that a tree needs before the member has an instance: the box of its surface, and whether its inside is in it; or the
 * half-space that it is. */
typedef struct csg_extent { bool has_box, boxed, is_half_space; pov_box box; pov_half_space half_space; } csg_extent;
/* Where csg_make() asks for them; and for half-spaces that hold the part of an infinite member within others. */
typedef struct csg_source {
    void (*extent)(const void *user, uint32_t leaf, csg_extent *out);
    uint32_t (*hull)(const void *user, uint32_t leaf, const half_spaces *within, pov_half_space *out);
    const void *user;
    bool clear_members;          /* as the plan has it */
} csg_source;

/* For csg_make(): boxes of the members, which may be moved, and of the tree. */
bool csg_find_bounds(csg_tree *t, const env *e, const csg_source *source);
/* After it: is the tree such an intersection? */
void csg_find_chords(csg_tree *t);
/* Is it, whatever its members are, what some of them and the complements of the others have in common? `holds`, with room for
 * CSG_CHORDS_MAX: is a member no complement? */
bool csg_is_product(const csg_tree *t, uint8_t *holds);
/* Or is it one surface that convex solids clip? */
void csg_find_clipped(csg_tree *t);
/* Or is it one of few members, whose crossings outlines may tell; or, of some that hold it, whether a ray may meet it? */
bool csg_is_small(const csg_tree *t);
/* Once members have instances: which of them are one surface? False: no memory. */
bool csg_find_same(csg_tree *t, const env *e);
/* And what do they look like, where they are few? most: of so many columns all sets may have their values in a table. False: no memory. */
bool csg_find_outline(csg_tree *t, const env *e, uint32_t most);
/* Make the trees of a model; false: no memory. Call csg_free() in any case. */
bool csg_make(csg_list *out, const model *m, const csg_source *source);
void csg_free(csg_list *all, const env *e);

typedef struct csg_near { double t; uint32_t bound; } csg_near;

/* One thread's memory for intersections. hits->user points to a struct that begins with a pointer to it. */
typedef struct csg_scratch {
    const env *env;
    pov_crossing *crossings;
    uint32_t capacity;
    csg_state *states;           /* by node */
    csg_state *before;           /* before crossings that coincide */
    uint8_t *inside;             /* by member; zero between walks */
    uint32_t *asked;             /* members that were intersected */
    csg_near *near;              /* heap of bounds to be opened, nearest first */
    class_counts *classes;       /* the thread's counters; NULL: none */
    uint32_t names;              /* a leaf of this index has that name more: it is in a copy */
    bool light;                  /* only what takes light away counts: copies end at what is opaque */
    const struct coincident_set *from;   /* surfaces that the ray starts on, each of which copies name by itself; or NULL */
    bool failed;                 /* out of memory; stays so */
} csg_scratch;
typedef struct csg_user { csg_scratch *scratch; uint32_t note; } csg_user;   /* note: see csg_cross_many() */

/* The largest of some trees. */
typedef struct csg_size { uint32_t nodes, members; } csg_size;
void csg_measure(const csg_list *all, csg_size *most);
bool csg_scratch_init(csg_scratch *s, const csg_size *most, const env *e);
void csg_scratch_free(csg_scratch *s);

/* The functions of the class. */
void csg_intersect(const void *self, const pov_ray *ray, pov_hits *hits);
void csg_intersect_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n);
bool csg_inside(const void *self, pov_vec3 point, pov_vec3 point_lo);
/* Several rays of trees that have chords and stand in a block. Of a definite hit a candidate's note says which crossing it is:
 * csg_cross_many() asks for that alone. */
typedef struct csg_block { const csg_tree *tree[POV_BLOCK_MAX]; uint32_t count; } csg_block;
uint32_t csg_filter(const void *block, const uint32_t *owners, const pov_rays *rays, uint64_t lanes, pov_candidate *out);
void csg_cross_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n);
/* The value of a node from those of its children. */
int32_t csg_value(const csg_node *n, const csg_state *s);
/* A member is entered or left: update `inside` and the nodes above it, up to the first whose value stays. */
void csg_flip(const csg_tree *t, csg_state *states, uint8_t *inside, uint32_t member);

#endif
