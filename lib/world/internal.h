/* internal.h - the contents of a world, for the files of this room and of query. */
#ifndef WORLD_INTERNAL_H
#define WORLD_INTERNAL_H

#include "bvh/traverse.h"
#include "world/copy.h"
#include "world/csg.h"
#include "world/leaf_layout.h"
#include "world/surface.h"

/* A solid with an interior, or a member of a union of such solids. */
typedef struct dielectric {
    uint32_t solid;              /* see world_solid() */
    uint32_t object;
    bool boxed;                  /* only points in the box are inside */
    pov_box box;
} dielectric;

static inline bool world_is_within(const pov_box *b, pov_vec3 p)
{
    return p.x >= b->lo.x && p.x <= b->hi.x && p.y >= b->lo.y && p.y <= b->hi.y && p.z >= b->lo.z && p.z <= b->hi.z;
}

typedef struct dielectric_list { dielectric *items; size_t count, capacity; } dielectric_list;

/* Location of an object's shape. */
typedef struct shape_ref {
    const void *instance;
    const instance_xform *xform; /* NULL: own space is the world */
} shape_ref;

struct world {
    const env *env;
    const model *model;
    plan plan;
    object_info *objects_info;   /* slot: see LEAF_SINGLE; filters: it is transparent and casts a shadow */
    shape_group *groups;
    size_t group_count;
    arena *resident;             /* instances of shapes with an instance transform, and of others that stayed in their
                                  * memory */
    int resident_count;
    unsigned char *list_memory;
    const leaf_batch *infinite;  /* tested by every ray; NULL: none */
    const leaf_batch *list;      /* finite objects if there is no tree; NULL: none */
    bvh tree;
    bool has_tree;
    const bvh_kernels *kernels;
    bool always_exact;
    bool is_part;                /* of another world */
    size_t scratch_bytes;        /* bytes of a thread's working memory for shapes */
    bool located;                /* light needs the distances of crossings: a transparent object is not plain */
    pov_box bounds, transparent; /* transparent: box around transparent objects */
    world_isolation isolation;
    bool has_bounds;
    double extent;               /* the largest coordinate of `bounds`; 0 without */
    uint32_t infinite_count, finite_count;
    size_t absorbed, composed, packed;   /* see world_facts */
    dielectric_list dielectrics; /* leaves in the order of the scene, then trees */
    dielectric_list filled;      /* the same of solids that are not hollow, where there is fog or media */
    world_lamps lamps;
    csg_list trees;              /* objects behind the leaves */
    csg_root *roots;             /* their instances */
    copy_root *copies;           /* instances of the objects behind the trees */
    world **parts;               /* what copies refer to */
    size_t part_count;
    uint32_t own_names;          /* leaves, trees and copies: the names that no copy holds */
    uint32_t *solids;            /* by leaf; NULL: each leaf is a solid of its own */
};

/* Object space rays of instanced shapes, by the caller's number, of the last query for the nearest: `known` ones are in
 * the space of object `of`. first: the first of the caller's hits; complete: those with point and normal. */
struct object_space_rays {
    SIMD_ALIGNED pov_ray rays[WORLD_MANY];
    uint32_t of[WORLD_MANY];
    uint64_t known, complete;
    const hit *first;
};

static inline void own_begin(object_space_rays *own, const hit *first)
{
    own->known = own->complete = 0;
    own->first = first;
}

/* A hit begins with where it is. */
enum { HIT_CONTACT_AGREES = 1 / (offsetof(hit, point) == offsetof(pov_contact, point) && offsetof(hit, point_lo) == offsetof(pov_contact, point_lo) &&
                               offsetof(hit, normal) == offsetof(pov_contact, normal)) };
static inline pov_contact *hit_contact(hit *h) { return (pov_contact *)(void *)h; }

/* Rays to be transformed to object spaces together. */
typedef struct xform_batch {
    uint32_t count;
    const instance_xform *at[WORLD_MANY];
    const pov_ray *from[WORLD_MANY];
    pov_ray *own[WORLD_MANY];
} xform_batch;

static inline void xform_batch_add(xform_batch *p, const instance_xform *at, const pov_ray *from, pov_ray *own)
{
    const uint32_t n = p->count++;

    p->at[n] = at;
    p->from[n] = from;
    p->own[n] = own;
}

static inline void xform_batch_apply(const xform_batch *p)
{
    if (p->count > 0)
        instance_rays(p->at, p->from, p->own, p->count);
}

static inline shape_ref world_shape(const world *w, uint32_t index)
{
    const object_info *info = &w->objects_info[index];
    shape_ref p = { NULL, NULL };

    if (info->slot & LEAF_SINGLE) {
        const unsigned char *base = info->slot & LEAF_IN_LISTS ? w->list_memory : w->tree.leaves;
        const size_t line = info->slot & ~(LEAF_IN_LISTS | LEAF_SINGLE);
        const leaf_batch *r = (const leaf_batch *)(const void *)(base + line * LEAF_LINE);
        p.instance = r->instances;
        p.xform = r->flags & LEAF_INSTANCED ? leaf_batch_xform(r) : NULL;
    } else {
        const shape_group *g = &w->groups[info->group];
        p.instance = g->instances + (size_t)info->slot * g->stride;
    }
    return p;
}

#endif
