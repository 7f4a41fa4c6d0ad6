/* internal.h - what a world is made of, for the files of this room and of query. */
#ifndef WORLD_INTERNAL_H
#define WORLD_INTERNAL_H

#include "bvh/traverse.h"
#include "world/csg.h"
#include "world/leaf_layout.h"
#include "world/surface.h"

/* A solid with an interior, or one of those that it is a union of. */
typedef struct dielectric {
    uint32_t solid;              /* see world_solid() */
    uint32_t object;
    bool boxed;                  /* only points in the box are inside */
    pov_box box;
} dielectric;

typedef struct dielectric_list { dielectric *items; size_t count, capacity; } dielectric_list;

/* Where an object's shape is. */
typedef struct shape_ref {
    const void *instance;
    const instance_xform *xform; /* NULL: own space is the world */
} shape_ref;

struct world {
    const env *env;
    const model *model;
    plan plan;
    object_info *objects_info;   /* slot: see LEAF_SINGLE; filter_hits: it is transparent, and throws a shadow */
    shape_group *groups;
    size_t group_count;
    arena *resident;             /* instances of shapes that are placed, and of others that stay where they were made */
    int resident_count;
    unsigned char *list_memory;
    const leaf_batch *infinite;  /* asked for every ray; NULL: none */
    const leaf_batch *list;      /* the finite ones when there is no tree; NULL: none */
    bvh tree;
    bool has_tree;
    const bvh_kernels *kernels;
    bool always_exact;
    size_t scratch_bytes;        /* of a thread's working memory for shapes */
    bool located;                /* distances of crossings count for light: a transparent object is not plain */
    pov_box bounds, transparent; /* transparent: around what light passes */
    uint8_t *isolated;           /* by object, 1: it is clear, and nothing else is in its box; NULL: nobody knows */
    bool has_bounds;
    uint32_t infinite_count;
    dielectric_list dielectrics; /* leaves in the order of the scene, then trees */
    csg_list trees;              /* objects behind the leaves */
    csg_root *roots;             /* theirs */
    uint32_t *solids;            /* by leaf; NULL: each is one by itself */
};

/* Rays in the spaces of instanced shapes, by the caller's number, of the last question for what is nearest: of those
 * that are known, `of` is whose space it is. first: the first of the caller's hits. */
struct object_space_rays {
    SIMD_ALIGNED pov_ray rays[WORLD_MANY];
    uint32_t of[WORLD_MANY];
    uint64_t known;
    const hit *first;
};

static inline void own_begin(object_space_rays *own, const hit *first)
{
    own->known = 0;
    own->first = first;
}

/* Rays that are taken to instanced shapes together. */
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
