/* parts.h - what a world is made of, for the files of this room and of query. */
#ifndef WORLD_PARTS_H
#define WORLD_PARTS_H

#include "bvh/traverse.h"
#include "world/csg.h"
#include "world/leaf_layout.h"
#include "world/surface.h"

/* A solid with an interior, or one of those that it is a union of. */
typedef struct medium {
    uint32_t solid;              /* see world_solid() */
    uint32_t object;
    bool boxed;                  /* only points in the box are inside */
    pov_box box;
} medium;

typedef struct medium_list { medium *items; size_t count, capacity; } medium_list;

/* Where an object's shape is. */
typedef struct shape_place {
    const void *instance;
    const placement *placement;  /* NULL: own space is the world */
} shape_place;

struct world {
    const env *env;
    const model *model;
    plan plan;
    world_thing *things;         /* slot: see RUNS_ALONE; tints: it is transparent, and throws a shadow */
    shape_group *groups;
    size_t group_count;
    arena *kept;                 /* instances of shapes that are placed, and of others that stay where they were made */
    int kept_count;
    unsigned char *list_memory;
    const run *infinite;         /* asked for every ray; NULL: none */
    const run *list;             /* the finite ones when there is no tree; NULL: none */
    bvh tree;
    bool has_tree;
    const bvh_kernels *kernels;
    bool always_exact;
    size_t scratch_bytes;        /* of a thread's working memory for shapes */
    bool located;                /* distances of crossings count for light: a transparent object is not plain */
    pov_box bounds, clear;       /* clear: around what light passes */
    uint8_t *lonely;             /* by object, 1: it is clear, and nothing else is in its box; NULL: nobody knows */
    bool has_bounds;
    uint32_t infinite_count;
    medium_list media;           /* leaves in the order of the scene, then trees */
    csg_list trees;              /* objects behind the leaves */
    csg_root *roots;             /* theirs */
    uint32_t *solids;            /* by leaf; NULL: each is one by itself */
};

/* Rays in the spaces of placed shapes, by the caller's number, of the last question for what is nearest: of those that
 * are known, `of` is whose space it is. first: the first of the caller's hits. */
struct own_rays {
    SIMD_ALIGNED pov_ray rays[WORLD_MANY];
    uint32_t of[WORLD_MANY];
    uint64_t known;
    const hit *first;
};

static inline void own_begin(own_rays *own, const hit *first)
{
    own->known = 0;
    own->first = first;
}

/* Rays that are taken to placed shapes together. */
typedef struct places {
    uint32_t count;
    const placement *at[WORLD_MANY];
    const pov_ray *from[WORLD_MANY];
    pov_ray *own[WORLD_MANY];
} places;

static inline void places_put(places *p, const placement *at, const pov_ray *from, pov_ray *own)
{
    const uint32_t n = p->count++;

    p->at[n] = at;
    p->from[n] = from;
    p->own[n] = own;
}

static inline void places_find(const places *p)
{
    if (p->count > 0)
        placement_rays(p->at, p->from, p->own, p->count);
}

static inline shape_place world_place(const world *w, uint32_t index)
{
    const world_thing *thing = &w->things[index];
    shape_place p = { NULL, NULL };

    if (thing->slot & RUNS_ALONE) {
        const unsigned char *base = thing->slot & RUNS_IN_LISTS ? w->list_memory : w->tree.leaves;
        const size_t line = thing->slot & ~(RUNS_IN_LISTS | RUNS_ALONE);
        const run *r = (const run *)(const void *)(base + line * RUNS_LINE);
        p.instance = r->instances;
        p.placement = r->flags & RUN_PLACED ? run_placement(r) : NULL;
    } else {
        const shape_group *g = &w->groups[thing->group];
        p.instance = g->instances + (size_t)thing->slot * g->stride;
    }
    return p;
}

#endif
