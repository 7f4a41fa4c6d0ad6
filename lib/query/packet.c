#include "query/packet.h"

#include "base/lane_mask.h"

static void begin(packet *p, const world *w, query_context *k, double tmax)
{
    p->traversal.tree = &w->tree;
    p->world = w;
    p->context = k;
    p->tmax = tmax;
    p->slack = 0.0;
    p->asked = p->deferred_lanes = p->crossed = 0;
    p->from = k->csg.from = NULL;
    k->csg.light = false;
    p->candidates_only = p->whole = false;
    p->by_lane = NULL;
}

void packet_begin(packet *p, const world *w, query_context *k, const pov_ray *const *rays, uint64_t which, double tmax,
                  double end)
{
    begin(p, w, k, tmax);
    p->exact = bvh_take(&p->traversal, p->rays, p->of, rays, which, tmax, end);
}

/* As bvh_take() does, lanes past the end hold the last ray again. */
void packet_make_rays(packet *p)
{
    const uint32_t n = p->traversal.count;
    const pov_ray *const *made;

    if (!p->by_lane)
        return;
    made = p->by_lane->make(p->by_lane->user);
    for (uint32_t i = 0; i < WORLD_MANY; i++)
        p->rays[i] = made[i < n ? i : n - 1];
    p->traversal.rays = p->traversal.soa.rays = p->rays;
    p->by_lane = NULL;
}

static void make_rays(bvh_traversal *t) { packet_make_rays((packet *)(void *)t); }

bool packet_begin_lanes(packet *p, const world *w, query_context *k, const lane_rays *rays, uint32_t n, double tmax)
{
    if (!bvh_copy_lanes(&p->traversal, w->has_tree ? &w->tree : NULL, &rays->lanes, n))
        return false;
    begin(p, w, k, tmax);
    p->by_lane = rays;
    p->traversal.make_rays = make_rays;
    for (uint32_t i = 0; i < n; i++)
        p->of[i] = (uint8_t)i;
    p->exact = bvh_take_copied(&p->traversal, n, tmax, tmax);
    return true;
}

uint64_t packet_traverse(packet *p, bvh_traverse_fn *traverse, bool nearest)
{
    const world *w = p->world;
    bvh_traversal *t = &p->traversal;
    const uint64_t all = t->lanes;
    uint64_t ended = 0;

    if (w->infinite)
        ended = t->leaf(t, w->infinite, all);
    if (w->list && all & ~ended)
        ended |= t->leaf(t, w->list, all & ~ended);
    t->lowered = 0;
    t->lanes = all & ~ended & ~p->exact;
    if (w->has_tree && t->lanes)
        ended |= traverse(t);
    t->lanes = all & ~ended & p->exact;
    if (w->has_tree && t->lanes)
        ended |= (nearest ? w->kernels->nearest_single : w->kernels->any_single)(t);
    t->lanes = all;
    return ended;
}

/* ---- shapes of one crossing ---- */

void packet_bounds(const packet *p, const leaf_batch *r, uint32_t which, uint64_t lanes, shape_bounds *out)
{
    static const double zero[WORLD_MANY];
    const double *const tmax = p->traversal.soa.tmax;
    const uint32_t n = p->traversal.count;

    r->shape->block_bounds(leaf_batch_block(r), which, &p->traversal.soa, lanes, out->lo, out->hi);
    out->maybe = lanes & ~lane_mask_below(tmax, out->lo, n) & ~lane_mask_below(out->hi, zero, n);
    out->definite = out->maybe & lane_mask_below(zero, out->lo, n) & lane_mask_below(out->hi, tmax, n);
}

uint32_t packet_put_bounds(packet *p, const shape_bounds *of, uint32_t which, uint64_t lanes, uint32_t n)
{
    for (; lanes; lanes &= lanes - 1, n++) {
        const uint32_t i = first_of64(lanes);
        pov_candidate *out = &p->candidates[n];

        out->lo = of->lo[i];
        out->hi = of->hi[i];
        out->ray = (uint8_t)i;
        out->lane = (uint8_t)which;
        out->definite = (of->definite >> i & 1) != 0;
        out->definite_pair = false;
    }
    return n;
}

/* ---- shapes and rays that are asked side by side ---- */

void pairs_ask(query_context *k, const shape_class *shape, uint32_t class_number, pairs *some, bool crossed)
{
    uint32_t escalated = 0, i;

    for (i = 0; i < some->count; i++)
        escalated -= some->hits[i]->escalated;
    if (crossed && shape->cross_many != NULL)
        shape->cross_many(some->selves, some->rays, some->hits, some->count);
    else if (shape->intersect_many != NULL)
        shape->intersect_many(some->selves, some->rays, some->hits, some->count);
    else
        for (i = 0; i < some->count; i++)
            shape->intersect(some->selves[i], some->rays[i], some->hits[i]);
    for (i = 0; i < some->count; i++)
        escalated += some->hits[i]->escalated;
    query_context_count_class(k, class_number, some->count, escalated);
}

uint64_t sure_pairs_cross(sure_pairs *some, const world *w, query_context *k, const shape_class *shape, uint32_t class_number)
{
    uint64_t open = shape->cross_sure(some->selves, some->rays, some->at, w->plan.lighting ? some->contacts : NULL, some->count);
    uint32_t crossed = some->count;
    uint64_t out = 0;

    for (; open; open &= open - 1, crossed--)
        out |= bit_of(some->lanes[first_of64(open)]);
    query_context_count_class(k, class_number, crossed, 0);
    return out;
}
