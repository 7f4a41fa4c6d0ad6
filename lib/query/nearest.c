#include "query/clear_solid.h"
#include "query/packet.h"
#include "query/start.h"

#include "base/lane_mask.h"

#include <string.h>

/* ---- leaves ---- */

static pov_hits *hits_of(packet *p, uint32_t i)
{
    if (!(p->asked & bit_of(i))) {
        p->asked |= bit_of(i);
        packet_begin_hits(p, i, &p->hits[i], POV_WANT_NEAREST, &p->out[p->of[i]].crossing);
    }
    return &p->hits[i];
}

static void ask(packet *p, uint32_t i, const leaf_batch *r, uint32_t lane)
{
    pov_hits *hits = hits_of(p, i);

    packet_intersect(p, i, r, lane, hits);
    if (hits->tmax < p->traversal.limit[i])
        lower(p, i, hits->tmax);
}

static void ask_one(packet *p, uint32_t i, const leaf_batch *r, uint32_t lane)
{
    const uint32_t before = hits_of(p, i)->escalated;

    ask(p, i, r, lane);
    query_context_count(p->context, r, 1, p->hits[i].escalated - before);
}

/* A deferred shape that is now excluded is dropped; any other is intersected before the next one is deferred. */
static inline void defer(packet *p, const leaf_batch *r, uint32_t i, uint32_t lane, double lo, double hi, uint32_t note)
{
    deferred *d = &p->deferred;

    if (hi < p->traversal.limit[i])
        lower(p, i, hi);
    if ((p->deferred_lanes & bit_of(i)) && !is_beyond(p, i, d->lo[i]))
        ask_one(p, i, d->batch[i], d->lane[i]);
    d->batch[i] = r;
    d->lane[i] = lane;
    d->lo[i] = lo;
    d->note[i] = note;
    p->deferred_lanes |= bit_of(i);
}

/* As lower(), of some of n lanes and only where that is nearer. */
SIMD_CLONES static void lower_lanes(double *restrict limit, double *restrict tmax, const double *restrict to, uint64_t lanes, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++) {
        const bool nearer = (lanes >> i & 1) != 0 && to[i] < limit[i];
        const double now = nearer ? to[i] : limit[i];

        limit[i] = now;
        tmax[i] = nearer ? just_beyond(now) : tmax[i];
    }
}

/* Defer a shape of some lanes, where nothing is deferred yet. What is noted of other lanes means nothing. */
static void defer_first(packet *p, const leaf_batch *r, uint32_t lane, const shape_bounds *b, uint64_t lanes)
{
    const uint32_t n = p->traversal.count;
    deferred *d = &p->deferred;

    p->traversal.lowered |= lanes & lane_mask_below(b->hi, p->traversal.limit, n);
    lower_lanes(p->traversal.limit, p->traversal.soa.tmax, b->hi, lanes, n);
    memcpy(d->lo, b->lo, n * sizeof *d->lo);
    for (uint32_t i = 0; i < n; i++)
        d->batch[i] = r;
    for (uint32_t i = 0; i < n; i++)
        d->lane[i] = lane;
    memset(d->note, 0, n * sizeof *d->note);
    p->deferred_lanes = lanes;
}

/* Possible hits of one shape, so that no ray occurs twice. */
static void ask_open(packet *p, const leaf_batch *r, pairs *open, const xform_batch *instanced, const uint8_t *lanes)
{
    uint32_t i;

    xform_batch_apply(instanced);
    pairs_ask(p->context, r->shape, leaf_batch_class(r), open, false);
    for (i = 0; i < open->count; i++)
        if (open->hits[i]->tmax < p->traversal.limit[lanes[i]])
            lower(p, lanes[i], open->hits[i]->tmax);
    open->count = 0;
}

/* Is it a batch of one shape, which takes several rays side by side? */
static inline bool takes_several(const leaf_batch *r) { return r->count == 1 && r->shape->intersect_many; }

/* The first n candidates. several: those of a shape follow one another, and its class takes them side by side. */
SIMD_INLINE void take(packet *p, const leaf_batch *r, uint32_t n, bool several)
{
    const pov_candidate *m = p->candidates;
    uint8_t open_lanes[WORLD_MANY];
    xform_batch instanced;
    pairs open;

    open.count = instanced.count = 0;
    for (; n > 0; m++, n--) {
        const pov_ray *ray = p->rays[m->ray];
        const bool left = r->object[m->lane] == ray->origin_surface;

        if (is_beyond(p, m->ray, m->lo) ||
            (left && is_excluded(r, m->lane, ray, p->traversal.soa.excluded[m->ray])))
            continue;
        /* The filter does not know the root that a ray starts on. */
        if (m->definite && !left) {
            defer(p, r, m->ray, m->lane, m->lo, m->hi, m->note);
            SIMD_PREFETCH(leaf_batch_instance(r, m->lane));
        } else if (r->flags & LEAF_INSTANCED) {
            pov_hits *hits = hits_of(p, m->ray);

            leaf_batch_prefetch(r);
            open_lanes[open.count] = (uint8_t)m->ray;
            hits->owner = r->object[0];
            ray = own_ray(p->context, &instanced, leaf_batch_xform(r), ray, p->of[m->ray], hits->owner);
            pairs_put(&open, r->instances, ray, hits);
        } else if (r->shape == &csg_class || several) {
            const void *shape = leaf_batch_instance(r, m->lane);

            if (open.count > 0 && open.selves[0] != shape)
                ask_open(p, r, &open, &instanced, open_lanes);
            open_lanes[open.count] = (uint8_t)m->ray;
            hits_of(p, m->ray)->owner = r->object[m->lane];
            pairs_put(&open, shape, ray, &p->hits[m->ray]);
        } else {
            ask_one(p, m->ray, r, m->lane);
        }
    }
    if (open.count > 0)
        ask_open(p, r, &open, &instanced, open_lanes);
}

/* Some of the lanes: those whose rays start on an object. */
static uint64_t starting_on(const packet *p, uint32_t object, uint64_t lanes)
{
    uint64_t out = 0;

    for (; p->traversal.start && lanes; lanes &= lanes - 1) {
        const uint32_t i = first_of64(lanes);

        out |= (uint64_t)(p->rays[i]->origin_surface == object) << i;
    }
    return out;
}

/* Shapes that are bounded by lane: what is definite needs no candidates. */
static void filter_bounds(packet *p, const leaf_batch *r, uint64_t lanes)
{
    shape_bounds b;

    for (uint32_t which = 0; which < r->count; which++) {
        uint64_t sure, open;

        packet_bounds(p, r, which, lanes, &b);
        b.maybe &= ~starting_on(p, r->object[which], b.maybe);
        sure = b.maybe & b.definite;
        open = b.maybe & ~sure;
        if (!p->deferred_lanes && sure) {
            defer_first(p, r, which, &b, sure);
            sure = 0;
        }
        for (; sure; sure &= sure - 1)
            defer(p, r, first_of64(sure), which, b.lo[first_of64(sure)], b.hi[first_of64(sure)], 0);
        if (open)
            take(p, r, packet_put_bounds(p, &b, which, open, 0), r->shape->intersect_many != NULL);
    }
}

/* Most leaves are one batch, and this is most of what is done with them. */
SIMD_INLINE void filter(packet *p, const leaf_batch *r, uint64_t lanes)
{
    if (packet_has_bounds(r, lanes))
        filter_bounds(p, r, lanes);
    else
        take(p, r, leaf_batch_filter(r, p->traversal.in, &p->traversal.soa, lanes, p->candidates), takes_several(r));
}

/* The same for several lanes and one shape of a batch whose class takes rays side by side. */
static void ask_together(packet *p, const leaf_batch *r, uint32_t which, uint64_t lanes)
{
    uint8_t of[WORLD_MANY];
    xform_batch instanced;
    pairs some;
    uint32_t i;

    some.count = instanced.count = 0;
    for (; lanes; lanes &= lanes - 1) {
        const pov_ray *ray;

        i = first_of64(lanes);
        if (!(possible_of(p, i, r) >> which & 1))
            continue;
        hits_of(p, i)->owner = r->object[which];
        of[some.count] = (uint8_t)i;
        ray = r->flags & LEAF_INSTANCED ? own_ray(p->context, &instanced, leaf_batch_xform(r), p->rays[i], p->of[i], r->object[0]) : p->rays[i];
        pairs_put(&some, leaf_batch_instance(r, which), ray, &p->hits[i]);
    }
    xform_batch_apply(&instanced);
    if (some.count > 0)
        pairs_ask(p->context, r->shape, leaf_batch_class(r), &some, false);
    for (i = 0; i < some.count; i++)
        if (some.hits[i]->tmax < p->traversal.limit[of[i]])
            lower(p, of[i], some.hits[i]->tmax);
}

static void ask_all(packet *p, const leaf_batch *r, uint64_t lanes)
{
    uint32_t asked = 0, escalated = 0;

    for (; lanes; lanes &= lanes - 1) {
        const uint32_t i = first_of64(lanes);
        uint32_t mask = possible_of(p, i, r);

        if (!mask)
            continue;
        escalated -= hits_of(p, i)->escalated;
        for (; mask; mask &= mask - 1, asked++)
            ask(p, i, r, first_of(mask));
        escalated += p->hits[i].escalated;
    }
    query_context_count(p->context, r, asked, escalated);
}

static uint64_t leaf_nearest(bvh_traversal *traversal, const void *leaf, uint64_t lanes)
{
    packet *p = (packet *)(void *)traversal;
    const leaf_batch *r;

    for (r = leaf; r; r = leaf_batch_next(r)) {
        const uint64_t exact = exact_of(p, r, lanes);

        if (lanes & ~exact)
            filter(p, r, lanes & ~exact);
        if (!packet_asks_together(p, r, exact)) {
            if (exact)
                ask_all(p, r, exact);
            continue;
        }
        for (uint32_t which = 0; which < r->count; which++)
            ask_together(p, r, which, exact);
    }
    return 0;
}

/* ---- what was deferred ---- */

/* Collect those of `left` of one class, whose rays are in object space; returns the others. */
static uint64_t take_class(packet *p, const shape_class *shape, uint64_t left, pairs *out)
{
    uint64_t rest, others = 0;

    out->count = 0;
    for (rest = left; rest; rest &= rest - 1) {
        const uint32_t i = first_of64(rest);
        const leaf_batch *r = p->deferred.batch[i];
        const pov_ray *ray = r->flags & LEAF_INSTANCED ? &p->context->own.rays[p->of[i]] : p->rays[i];
        pov_hits *hits;

        if (r->shape != shape) {
            others |= bit_of(i);
            continue;
        }
        hits = hits_of(p, i);
        hits->owner = r->object[p->deferred.lane[i]];
        /* The shape need not look beyond where something is known to be hit. */
        if (p->traversal.soa.tmax[i] < hits->tmax)
            hits->tmax = p->traversal.soa.tmax[i];
        p->context->hit_buffers[p->of[i]].csg.note = p->deferred.note[i];
        pairs_put(out, leaf_batch_instance(r, p->deferred.lane[i]), ray, hits);
    }
    return others;
}

static inline bool is_sure(const leaf_batch *r, const shape_class *shape) { return r->shape == shape && !(r->flags & LEAF_INSTANCED); }

/* Collect those of `left` of one class, whose objects are hit; returns the others. */
static uint64_t take_sure(packet *p, const shape_class *shape, uint64_t left, sure_pairs *some)
{
    uint64_t rest, others = 0;

    some->count = 0;
    for (rest = left; rest; rest &= rest - 1) {
        const uint32_t i = first_of64(rest);
        const uint32_t lane = p->deferred.lane[i];
        const leaf_batch *r = p->deferred.batch[i];

        if (is_sure(r, shape))
            sure_pairs_put(some, p->world, leaf_batch_instance(r, lane), r->object[lane], p->rays[i], i, &p->out[p->of[i]]);
        else
            others |= bit_of(i);
    }
    return others;
}

/* Cross the definite hits of lanes that asked nothing else, where their classes do so without hits. */
static void resolve_sure(packet *p)
{
    uint64_t left = p->deferred_lanes & ~p->asked;
    sure_pairs some;

    while (left) {
        const leaf_batch *r = p->deferred.batch[first_of64(left)];
        uint64_t others;

        if (!r->shape->cross_sure || (r->flags & LEAF_INSTANCED)) {
            left &= left - 1;
            continue;
        }
        others = take_sure(p, r->shape, left, &some);
        p->crossed |= left & ~others & ~sure_pairs_cross(&some, p->world, p->context, r->shape, leaf_batch_class(r));
        left = others;
    }
}

/* Intersect deferred shapes that can still be the nearest. */
static void resolve_deferred(packet *p)
{
    uint64_t left = 0, rest;
    xform_batch instanced;
    pairs some;

    resolve_sure(p);
    instanced.count = 0;
    for (rest = p->deferred_lanes & ~p->crossed; rest; rest &= rest - 1) {
        const uint32_t i = first_of64(rest);
        const leaf_batch *r = p->deferred.batch[i];

        if (is_beyond(p, i, p->deferred.lo[i]))
            continue;
        left |= bit_of(i);
        if (r->flags & LEAF_INSTANCED)
            own_ray(p->context, &instanced, leaf_batch_xform(r), p->rays[i], p->of[i], r->object[0]);
    }
    xform_batch_apply(&instanced);
    while (left) {
        const leaf_batch *r = p->deferred.batch[first_of64(left)];

        left = take_class(p, r->shape, left, &some);
        pairs_ask(p->context, r->shape, leaf_batch_class(r), &some, true);
    }
}

void packet_nearest(packet *p, bvh_traverse_fn *traverse)
{
    p->traversal.leaf = leaf_nearest;
    packet_traverse(p, traverse, true);
    resolve_deferred(p);
}

/* ---- the query ---- */

static void begin_from_exit_hits(packet *p, const exit_hits *e)
{
    uint32_t i;

    for (i = 0; e->known && i < p->traversal.count; i++) {
        const pov_hits *known = &e->hits[p->of[i]];

        if (!(e->known >> p->of[i] & 1))
            continue;
        p->asked |= bit_of(i);
        p->hits[i] = *known;
        p->traversal.soa.excluded[i] = p->rays[i]->origin_surface;
        if (known->tmax < p->traversal.limit[i])
            lower(p, i, known->tmax);
    }
}

/* Can a hit of some lanes be one that start_may_be_here()? A length is at most twice the largest component, and a size is not below that
 * of the origin's. t: no farther than the hits. */
SIMD_CLONES static bool may_be_at_start(const bvh_traversal *restrict traversal, const double *restrict t, uint64_t lanes, double extent)
{
    const uint32_t n = traversal->count;
    int64_t any = 0;

    for (uint32_t i = 0; i < n; i++) {
        const double at = lanes >> i & 1 ? t[i] : HUGE_VAL;   /* of others anything may be there, denormals too */

        any |= at * traversal->length[i] < 0x1p-29 * (extent + traversal->soa.size[i]) ? -1 : 0;
    }
    return any != 0;
}

/* Hits of rays without an origin surface that lie at their starts are replaced by the next ones. Returns those of `found`
 * that are left. */
SIMD_RARE static uint64_t leave_starts(packet *p, uint64_t found)
{
    coincident_set from;
    uint64_t rest;

    for (rest = p->asked | p->crossed; rest; rest &= rest - 1) {
        const uint32_t i = first_of64(rest);
        hit *out = &p->out[p->of[i]];

        if (!(found >> p->of[i] & 1) || !start_may_be_here(p->world, p->rays[i], out->crossing.t))
            continue;
        p->context->own.complete &= ~bit_of(p->of[i]);
        if (!start_leave(p->world, p->context, p->rays[i], p->tmax, &from, out))
            found &= ~bit_of(p->of[i]);
    }
    return found;
}

/* Lanes that end at exits whose points and normals are known, as bits of the caller's. */
static uint64_t at_exits(const packet *p, const exit_hits *e)
{
    uint64_t rest, out = 0;

    for (rest = e->sure && p->world->plan.lighting ? p->asked : 0; rest; rest &= rest - 1) {
        const uint32_t i = first_of64(rest);

        if ((e->sure >> p->of[i] & 1) && !p->hits[i].tied && p->hits[i].count > 0 && p->hits[i].at->owner == p->rays[i]->origin_surface)
            out |= bit_of(p->of[i]);
    }
    return out;
}

/* Lanes as bits of the caller's. */
static uint64_t callers_of(const packet *p, uint64_t lanes)
{
    uint64_t out = 0;

    if (p->of[p->traversal.count - 1] == p->traversal.count - 1)   /* in order, so that all are where they were */
        return lanes;
    for (; lanes; lanes &= lanes - 1)
        out |= bit_of(p->of[first_of64(lanes)]);
    return out;
}

/* Rays with a hit, as bits of the caller's. */
static uint64_t end_nearest(packet *p, const exit_hits *e)
{
    uint64_t found = callers_of(p, p->crossed), rest, escalated = 0;
    uint64_t with_hit = p->crossed;

    p->context->own.complete |= (p->world->plan.lighting ? found : 0) | at_exits(p, e);
    for (rest = p->asked; rest; rest &= rest - 1) {
        const uint32_t i = first_of64(rest);
        const pov_hits *hits = &p->hits[i];
        hit *out = &p->out[p->of[i]];

        escalated += hits->escalated;
        if (hits->count == 0)
            continue;
        out->object = out->crossing.owner;
        out->coincident = 0;
        found |= bit_of(p->of[i]);
        SIMD_PREFETCH(&p->world->objects_info[out->object]);
        if (hits->tied)
            coincidence_resolve(p->world, p->context, p->rays[i], NULL, out);
        p->deferred.lo[i] = out->crossing.t;
        with_hit |= bit_of(i);
    }
    p->context->escalated += escalated;
    if (found && (p->exact || may_be_at_start(&p->traversal, p->deferred.lo, with_hit, p->world->extent)))
        found = leave_starts(p, found);
    return found;
}

uint64_t query_nearest(const world *w, query_context *k, const pov_ray *const *rays, uint32_t n, double tmax, hit *out)
{
    bvh_group groups[BVH_GROUPS];
    uint64_t found;
    uint32_t count, i;
    packet p;
    exit_hits e;

    if (n == 0)
        return 0;
    own_begin(&k->own, out);
    k->resolved.count = 0;
    clear_solid_exits(w, k, rays, n, tmax, out, &e);
    found = e.found;
    count = packet_divide(w, rays, n, all_of(n) & ~e.found, true, groups);
    for (i = 0; i < count; i++) {
        packet_begin(&p, w, k, rays, groups[i].lanes, tmax, just_beyond(tmax));
        p.out = out;
        begin_from_exit_hits(&p, &e);
        packet_nearest(&p, groups[i].traverse);
        found |= end_nearest(&p, &e);
    }
    return found;
}
