#include "bvh/hierarchy.h"

#include "bvh/group.h"
#include "bvh/ray_soa.h"
#include "bvh/traverse.h"

/* A leaf: up to BVH_WIDTH items in one unit of leaf memory. Where items follow one another that memory is never touched: where a leaf
 * would be tells its first item and how many there are. */
typedef struct leaf { uint32_t count, item[BVH_WIDTH]; } leaf;
typedef struct leaf_range { uint32_t first, count; } leaf_range;
enum { RANGE_ITEMS_MOST = 1 << 27 };

struct hierarchy {
    pov_hierarchy service;       /* first: plugins pass it back */
    const env *env;
    const bvh_kernels *kernels;
    bvh tree;
};

static inline uint32_t code_of(leaf_range r) { return r.first * BVH_WIDTH + (r.count - 1); }

static inline leaf_range range_of_code(uint32_t code)
{
    const leaf_range r = { code / BVH_WIDTH, code % BVH_WIDTH + 1 };

    return r;
}

static inline size_t number_of(const bvh *tree, const void *at)
{
    return (size_t)((const unsigned char *)at - tree->leaves) / BVH_UNIT;
}

static inline leaf_range range_of(const hierarchy *h, const void *at) { return range_of_code((uint32_t)number_of(&h->tree, at)); }

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

/* State of a build. codes: of the leaves, or NULL. */
typedef struct building { hierarchy *of; const hierarchy_items *items; uint32_t *ids, *codes; } building;

static bool allocated(void *user, const void *leaves)
{
    building *b = user;

    (void)leaves;
    if (!b->items->order)
        return true;
    b->codes = env_resize(b->of->env, NULL, b->of->tree.leaf_count, sizeof *b->codes);
    return b->codes != NULL;
}

static void fill_leaf(void *user, uint32_t slice, const bvh_frame *frame, const uint32_t *ids, uint32_t count, void *at)
{
    const building *b = user;
    leaf *l = at;
    uint32_t i;

    (void)slice;
    (void)frame;
    if (b->items->order) {
        const leaf_range r = { (uint32_t)(ids - b->ids), count };

        b->codes[number_of(&b->of->tree, at)] = code_of(r);
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
        all.lo = pov_vec3_of(pov_min(all.lo.x, b.lo.x), pov_min(all.lo.y, b.lo.y), pov_min(all.lo.z, b.lo.z));
        all.hi = pov_vec3_of(pov_max(all.hi.x, b.hi.x), pov_max(all.hi.y, b.hi.y), pov_max(all.hi.z, b.hi.z));
    }
    return all;
}

static inline bool is_leaf(uint32_t reference) { return (reference & BVH_KIND) == BVH_LEAF; }

static void encode(uint32_t *reference, const uint32_t *codes)
{
    if (is_leaf(*reference))
        *reference = BVH_LEAF | codes[*reference & ~BVH_KIND];
}

/* References to leaves become their codes. */
static void encode_all(bvh *tree, const uint32_t *codes)
{
    for (size_t i = 0; i < tree->frame_count; i++)
        encode(&tree->frames[i].root, codes);
    for (size_t i = 0; i < tree->node_count; i++)
        for (int k = 0; k < BVH_WIDTH; k++)
            encode(&tree->nodes[i].child[k], codes);
}

static bool build(hierarchy *h, const hierarchy_items *items)
{
    const bool shares_leaf = true;
    uint32_t *ids = items->order ? items->order : env_resize(h->env, NULL, items->count, sizeof *ids), i;
    uint16_t *group = env_alloc(h->env, items->count, sizeof *group);   /* one group for all */
    building b = { h, items, ids, NULL };
    bvh_input in = { .env = h->env, .box = items->box, .box_user = items->user, .bounds = around(items), .ids = ids,
                     .count = items->count, .group = group, .shares_leaf = &shares_leaf, .threads = items->threads,
                     .leaves = { leaf_size, allocated, fill_leaf, filled, &b } };
    bool built;

    for (i = 0; ids && i < items->count; i++)
        ids[i] = i;
    built = ids && group && bvh_build(&h->tree, &in);
    if (built && items->order)
        encode_all(&h->tree, b.codes);
    env_free(h->env, b.codes);
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
        const leaf_range r = range_of(v->of, at);

        return v->range(v->user, r.first, r.count);
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
    const leaf_range r = range_of(v->of, at);
    uint64_t lowered = 0, rest;
    const uint64_t ended = v->visit(v->user, r.first, r.count, to_rays(v, lanes), &lowered);

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

static bool visit_reference(uint32_t reference, bool (*each)(void *user, uint32_t first, uint32_t count), void *user)
{
    const leaf_range r = range_of_code(reference & ~BVH_KIND);

    return !is_leaf(reference) || each(user, r.first, r.count);
}

static bool each_range(const pov_hierarchy *self, bool (*each)(void *user, uint32_t first, uint32_t count), void *user)
{
    const bvh *tree = &((const hierarchy *)(const void *)self)->tree;

    for (size_t i = 0; i < tree->frame_count; i++)
        if (!visit_reference(tree->frames[i].root, each, user))
            return false;
    for (size_t i = 0; i < tree->node_count; i++)
        for (int k = 0; k < BVH_WIDTH; k++)
            if (!visit_reference(tree->nodes[i].child[k], each, user))
                return false;
    return true;
}

/* ---- the whole ---- */

hierarchy *hierarchy_create(const env *e, const hierarchy_items *items)
{
    const bool too_many = items->order && items->count > RANGE_ITEMS_MOST;
    hierarchy *h = too_many ? NULL : env_alloc(e, 1, sizeof *h);

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
    env_free(h->env, h);
}

const pov_hierarchy *hierarchy_service(const hierarchy *h) { return &h->service; }
