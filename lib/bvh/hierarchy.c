#include "bvh/hierarchy.h"

#include "bvh/group.h"
#include "bvh/ray_soa.h"
#include "bvh/traverse.h"

/* A leaf: up to BVH_WIDTH items in one unit of leaf memory. Where items follow one another that memory is never touched:
 * where a leaf would be tells its number. */
typedef struct leaf { uint32_t count, item[BVH_WIDTH]; } leaf;

struct hierarchy {
    pov_hierarchy service;       /* first: plugins pass it back */
    const env *env;
    const bvh_kernels *kernels;
    bvh tree;
    uint32_t *first;             /* by leaf, the first of its items, and behind the last leaf their number; or NULL */
};

static inline size_t number_of(const hierarchy *h, const void *at)
{
    return (size_t)((const unsigned char *)at - h->tree.leaves) / BVH_UNIT;
}

/* ---- building ---- */

static size_t leaf_size(void *user, uint32_t slice, uint32_t *ids, uint32_t count, uint32_t rest)
{
    (void)user;
    (void)slice;
    (void)ids;
    (void)count;
    (void)rest;
    return sizeof(leaf);
}

/* State of a build. */
typedef struct building { hierarchy *of; const hierarchy_items *items; uint32_t *ids; } building;

static bool allocated(void *user, const void *leaves)
{
    const building *b = user;
    hierarchy *h = b->of;

    (void)leaves;
    if (!b->items->order)
        return true;
    h->first = env_resize(h->env, NULL, h->tree.leaf_count + 1, sizeof *h->first);
    if (h->first)
        h->first[h->tree.leaf_count] = b->items->count;
    return h->first != NULL;
}

static void fill_leaf(void *user, uint32_t slice, const bvh_frame *frame, const uint32_t *ids, uint32_t count, void *at)
{
    const building *b = user;
    leaf *l = at;
    uint32_t i;

    (void)slice;
    (void)frame;
    if (b->items->order) {
        b->of->first[number_of(b->of, at)] = (uint32_t)(ids - b->ids);
        return;
    }
    l->count = count;
    for (i = 0; i < count; i++)
        l->item[i] = ids[i];
}

static void filled(void *user, uint32_t slice)
{
    (void)user;
    (void)slice;
}

static pov_box around(const hierarchy_items *items)
{
    pov_box all, b;
    uint32_t i;

    items->box(items->user, 0, &all);
    for (i = 1; i < items->count; i++) {
        items->box(items->user, i, &b);
        all.lo = pov_vec3_of(fmin(all.lo.x, b.lo.x), fmin(all.lo.y, b.lo.y), fmin(all.lo.z, b.lo.z));
        all.hi = pov_vec3_of(fmax(all.hi.x, b.hi.x), fmax(all.hi.y, b.hi.y), fmax(all.hi.z, b.hi.z));
    }
    return all;
}

static bool build(hierarchy *h, const hierarchy_items *items)
{
    const bool shares_leaf = true;
    uint32_t *ids = items->order ? items->order : env_resize(h->env, NULL, items->count, sizeof *ids), i;
    uint16_t *group = env_alloc(h->env, items->count, sizeof *group);   /* one group for all */
    building b = { h, items, ids };
    bvh_input in = { .env = h->env, .box = items->box, .box_user = items->user, .bounds = around(items), .ids = ids,
                     .count = items->count, .group = group, .shares_leaf = &shares_leaf, .threads = items->threads,
                     .leaves = { leaf_size, allocated, fill_leaf, filled, &b } };
    bool built;

    for (i = 0; ids && i < items->count; i++)
        ids[i] = i;
    built = ids && group && bvh_build(&h->tree, &in);
    if (!items->order)
        env_free(h->env, ids);
    env_free(h->env, group);
    return built;
}

/* ---- rays ---- */

/* State of one ray's traversal. */
typedef struct visit {
    bvh_traversal traversal;     /* first: passed to leaves */
    const hierarchy *of;
    const pov_hits *hits;
    bool (*item)(void *user, uint32_t item);   /* one of these */
    bool (*range)(void *user, uint32_t first, uint32_t count);
    void *user;
} visit;

static bool visit_all(const visit *v, const void *at)
{
    const leaf *l = at;
    uint32_t i;

    if (v->range) {
        const uint32_t *first = v->of->first + number_of(v->of, at);

        return v->range(v->user, first[0], first[1] - first[0]);
    }
    for (i = 0; i < l->count; i++)
        if (!v->item(v->user, l->item[i]))
            return false;
    return true;
}

static uint64_t visit_leaf(bvh_traversal *traversal, const void *at, uint64_t lanes)
{
    visit *v = (visit *)(void *)traversal;

    if (!visit_all(v, at))
        return lanes;
    if (v->hits->tmax < traversal->limit[0]) {
        traversal->limit[0] = v->hits->tmax;
        traversal->lowered = lanes;
    }
    return 0;
}

static bool traverse(const pov_hierarchy *self, const pov_ray *ray, const pov_hits *hits, visit *v)
{
    const hierarchy *h = (const hierarchy *)(const void *)self;
    const pov_ray *const four[4] = { ray, ray, ray, ray };

    v->of = h;
    v->hits = hits;
    v->traversal.tree = &h->tree;
    v->traversal.rays = &ray;
    v->traversal.count = 1;
    v->traversal.lanes = 1;
    v->traversal.in = NULL;
    v->traversal.limit[0] = hits->tmax;
    v->traversal.lowered = 0;
    v->traversal.leaf = visit_leaf;
    ray_soa_put_four(&v->traversal.soa, 0, four);
    ray_soa_derive(&v->traversal.soa, 0, hits->tmax, v->traversal.length);
    return h->kernels->nearest_single(&v->traversal) == 0;
}

static bool visit_items(const pov_hierarchy *self, const pov_ray *ray, const pov_hits *hits,
                        bool (*item)(void *user, uint32_t item), void *user)
{
    visit v;

    v.item = item;
    v.range = NULL;
    v.user = user;
    return traverse(self, ray, hits, &v);
}

static bool visit_ranges(const pov_hierarchy *self, const pov_ray *ray, const pov_hits *hits,
                       bool (*range)(void *user, uint32_t first, uint32_t count), void *user)
{
    visit v;

    v.item = NULL;
    v.range = range;
    v.user = user;
    return traverse(self, ray, hits, &v);
}

/* ---- rays side by side ---- */

/* State of the traversal of a group of them. */
typedef struct packet_visit {
    bvh_traversal traversal;     /* first: passed to leaves */
    const hierarchy *of;
    const pov_ray *rays[BVH_LANES];
    uint8_t whose[BVH_LANES];    /* by lane: index of the caller's ray */
    bool in_order;               /* lanes are indices */
    double *limit;               /* the caller's */
    pov_visit_rays *visit;
    void *user;
} packet_visit;

static uint64_t to_rays(const packet_visit *v, uint64_t lanes)
{
    uint64_t rays = 0;

    if (v->in_order)
        return lanes;
    for (; lanes; lanes &= lanes - 1)
        rays |= (uint64_t)1 << v->whose[first_of64(lanes)];
    return rays;
}

/* Those of some lanes whose rays are among these. */
static uint64_t to_lanes(const packet_visit *v, uint64_t rays, uint64_t lanes)
{
    uint64_t found = 0;

    if (v->in_order || rays == 0)
        return rays & lanes;
    for (; lanes; lanes &= lanes - 1)
        found |= (rays >> v->whose[first_of64(lanes)] & 1) << first_of64(lanes);
    return found;
}

static uint64_t packet_leaf(bvh_traversal *traversal, const void *at, uint64_t lanes)
{
    packet_visit *v = (packet_visit *)(void *)traversal;
    const uint32_t *first = v->of->first + number_of(v->of, at);
    uint64_t lowered = 0, rest;
    const uint64_t ended = v->visit(v->user, first[0], first[1] - first[0], to_rays(v, lanes), &lowered);

    lowered = to_lanes(v, lowered, lanes);
    traversal->lowered |= lowered;
    for (rest = lowered; rest; rest &= rest - 1)
        traversal->limit[first_of64(rest)] = v->limit[v->whose[first_of64(rest)]];
    return to_lanes(v, ended, lanes);
}

static void visit_group(packet_visit *v, const bvh_group *group, const pov_ray *const *rays, bool nearest)
{
    bvh_traversal *t = &v->traversal;
    const uint64_t odd = bvh_take(t, v->rays, v->whose, rays, group->lanes, HUGE_VAL, HUGE_VAL), all = t->lanes;
    const bvh_kernels *by = v->of->kernels;
    uint32_t i;

    v->in_order = (group->lanes & (group->lanes + 1)) == 0;
    for (i = 0; i < t->count; i++)
        t->limit[i] = v->limit[v->whose[i]];
    t->lanes = all & ~odd;
    if (t->lanes)
        group->traverse(t);
    t->lanes = odd;
    if (odd)
        (nearest ? by->nearest_single : by->any_single)(t);
}

static void visit_rays(const pov_hierarchy *self, const pov_ray *const *rays, uint32_t n, double *limit, bool nearest,
                       pov_visit_rays *back, void *user)
{
    const hierarchy *h = (const hierarchy *)(const void *)self;
    bvh_group groups[BVH_GROUPS];
    const uint32_t count = bvh_divide(&h->tree, h->kernels, rays, n, ~(uint64_t)0 >> (BVH_LANES - n), nearest, groups);
    packet_visit v;
    uint32_t i;

    v.traversal.tree = &h->tree;
    v.traversal.leaf = packet_leaf;
    v.of = h;
    v.limit = limit;
    v.visit = back;
    v.user = user;
    for (i = 0; i < count; i++)
        visit_group(&v, &groups[i], rays, nearest);
}

/* A leaf fills a whole unit of their memory. */
static bool each_range(const pov_hierarchy *self, bool (*range)(void *user, uint32_t first, uint32_t count), void *user)
{
    const hierarchy *h = (const hierarchy *)(const void *)self;
    size_t i;

    for (i = 0; i < h->tree.leaf_count; i++)
        if (!range(user, h->first[i], h->first[i + 1] - h->first[i]))
            return false;
    return true;
}

/* ---- the whole ---- */

hierarchy *hierarchy_create(const env *e, const hierarchy_items *items)
{
    hierarchy *h = env_alloc(e, 1, sizeof *h);

    if (!h)
        return NULL;
    h->env = e;
    h->service.visit = visit_items;
    h->service.visit_ranges = items->order ? visit_ranges : NULL;
    h->service.visit_rays = items->order ? visit_rays : NULL;
    h->service.each_range = items->order ? each_range : NULL;
    h->kernels = bvh_kernels_best();
    if (build(h, items))
        return h;
    hierarchy_destroy(h);
    return NULL;
}

void hierarchy_destroy(hierarchy *h)
{
    if (!h)
        return;
    bvh_free(&h->tree, h->env);
    env_free(h->env, h->first);
    env_free(h->env, h);
}

const pov_hierarchy *hierarchy_service(const hierarchy *h) { return &h->service; }
