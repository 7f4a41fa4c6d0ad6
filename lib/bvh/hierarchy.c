#include "bvh/hierarchy.h"

#include "bvh/ray_soa.h"
#include "bvh/traverse.h"

/* A leaf: up to BVH_WIDTH items in one unit of leaf memory. */
typedef struct leaf { uint32_t count, item[BVH_WIDTH]; } leaf;

struct hierarchy {
    pov_hierarchy service;       /* first: plugins pass it back */
    const env *env;
    const bvh_kernels *kernels;
    bvh tree;
};

/* ---- building ---- */

static void box_of(void *user, uint32_t id, pov_box *out)
{
    const pov_box *boxes = user;

    *out = boxes[id];
}

static size_t leaf_size(void *user, uint32_t slice, uint32_t *ids, uint32_t count, uint32_t rest)
{
    (void)user;
    (void)slice;
    (void)ids;
    (void)count;
    (void)rest;
    return sizeof(leaf);
}

static bool allocated(void *user, const void *leaves)
{
    (void)user;
    (void)leaves;
    return true;
}

static void fill_leaf(void *user, uint32_t slice, const bvh_frame *frame, const uint32_t *ids, uint32_t count, void *at)
{
    leaf *l = at;

    (void)user;
    (void)slice;
    (void)frame;
    l->count = count;
    memcpy(l->item, ids, count * sizeof *ids);
}

static void filled(void *user, uint32_t slice)
{
    (void)user;
    (void)slice;
}

static pov_box around(const pov_box *boxes, uint32_t n)
{
    pov_box all = boxes[0];
    uint32_t i;

    for (i = 1; i < n; i++) {
        const pov_vec3 lo = boxes[i].lo, hi = boxes[i].hi;

        all.lo = pov_vec3_of(fmin(all.lo.x, lo.x), fmin(all.lo.y, lo.y), fmin(all.lo.z, lo.z));
        all.hi = pov_vec3_of(fmax(all.hi.x, hi.x), fmax(all.hi.y, hi.y), fmax(all.hi.z, hi.z));
    }
    return all;
}

static bool build(hierarchy *h, pov_box *boxes, uint32_t n)
{
    const bool shares_leaf = true;
    uint32_t *ids = env_resize(h->env, NULL, n, sizeof *ids), i;
    uint16_t *group = env_alloc(h->env, n, sizeof *group);   /* one group for all */
    bvh_input in = { .env = h->env, .box = box_of, .box_user = boxes, .bounds = around(boxes, n), .ids = ids, .count = n,
                     .group = group, .shares_leaf = &shares_leaf, .threads = 1,
                     .leaves = { leaf_size, allocated, fill_leaf, filled, NULL } };
    bool built;

    for (i = 0; ids && i < n; i++)
        ids[i] = i;
    built = ids && group && bvh_build(&h->tree, &in);
    env_free(h->env, ids);
    env_free(h->env, group);
    return built;
}

/* ---- rays ---- */

/* State of one ray's traversal. */
typedef struct visit {
    bvh_traversal traversal;     /* first: passed to leaves */
    const pov_hits *hits;
    bool (*visit_item)(void *user, uint32_t item);
    void *user;
} visit;

static uint64_t visit_leaf(bvh_traversal *traversal, const void *at, uint64_t lanes)
{
    visit *v = (visit *)(void *)traversal;
    const leaf *l = at;
    uint32_t i;

    for (i = 0; i < l->count; i++)
        if (!v->visit_item(v->user, l->item[i]))
            return lanes;
    if (v->hits->tmax < traversal->limit[0]) {
        traversal->limit[0] = v->hits->tmax;
        traversal->lowered = lanes;
    }
    return 0;
}

static bool visit_items(const pov_hierarchy *self, const pov_ray *ray, const pov_hits *hits,
                        bool (*visit_item)(void *user, uint32_t item), void *user)
{
    const hierarchy *h = (const hierarchy *)(const void *)self;
    const pov_ray *const four[4] = { ray, ray, ray, ray };
    visit v;

    v.traversal.tree = &h->tree;
    v.traversal.rays = &ray;
    v.traversal.count = 1;
    v.traversal.lanes = 1;
    v.traversal.in = NULL;
    v.traversal.limit[0] = hits->tmax;
    v.traversal.lowered = 0;
    v.traversal.leaf = visit_leaf;
    ray_soa_put_four(&v.traversal.soa, 0, four);
    ray_soa_derive(&v.traversal.soa, 0, hits->tmax, v.traversal.length);
    v.hits = hits;
    v.visit_item = visit_item;
    v.user = user;
    return h->kernels->nearest_single(&v.traversal) == 0;
}

/* ---- the whole ---- */

hierarchy *hierarchy_create(const env *e, const pov_box *boxes, uint32_t n)
{
    hierarchy *h = env_alloc(e, 1, sizeof *h);
    pov_box *copy = env_resize(e, NULL, n, sizeof *copy);
    bool built = false;

    if (h)
        h->env = e;
    if (h && copy) {
        memcpy(copy, boxes, n * sizeof *copy);
        h->service.visit = visit_items;
        h->kernels = bvh_kernels_best();
        built = build(h, copy, n);
    }
    env_free(e, copy);
    if (built)
        return h;
    hierarchy_destroy(h);
    return NULL;
}

void hierarchy_destroy(hierarchy *h)
{
    if (!h)
        return;
    bvh_free(&h->tree, h->env);
    env_free(h->env, h);
}

const pov_hierarchy *hierarchy_service(const hierarchy *h) { return &h->service; }
