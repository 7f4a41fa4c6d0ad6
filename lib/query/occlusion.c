#include "query/clear_solid.h"
#include "query/packet.h"
#include "query/segment_end.h"
#include "query/start.h"

#include "base/vec.h"

/* ---- leaves ---- */

void packet_begin_light(packet *p, uint32_t i)
{
    hit_buffer *buffer = &p->context->hit_buffers[p->of[i]];

    p->asked |= bit_of(i);
    packet_begin_hits(p, i, &p->hits[i], POV_WANT_ANY, &buffer->blocking);
    p->hits[i].slack = p->slack;
    if (p->any_blocks)
        return;
    packet_begin_hits(p, i, &p->filter_hits[i], POV_WANT_ALL, buffer->crossings);
    p->filter_hits[i].slack = p->slack;
    p->filter_hits[i].count_only = !p->world->located;
    p->filter_hits[i].capacity = buffer->capacity;
    p->filter_hits[i].grow = crossings_grow;
}

static inline void begin_light(packet *p, uint32_t i)
{
    if (!(p->asked & bit_of(i)))
        packet_begin_light(p, i);
}

/* True: the path ends here. */
static bool ask(packet *p, uint32_t i, const leaf_batch *r, uint32_t lane)
{
    const bool blocks = p->any_blocks || (r->opaque >> lane & 1);
    pov_hits *hits = blocks ? &p->hits[i] : &p->filter_hits[i];

    packet_intersect(p, i, r, lane, hits);
    return blocks && hits->count > 0;
}

static inline uint32_t escalated_of(const packet *p, uint32_t i)
{
    return p->hits[i].escalated + (p->any_blocks ? 0 : p->filter_hits[i].escalated);
}

static bool ask_some(packet *p, uint32_t i, const leaf_batch *r, uint32_t mask)
{
    uint32_t asked = 0, before;
    bool ended = false;

    if (!mask)
        return false;
    begin_light(p, i);
    before = escalated_of(p, i);
    for (; mask && !ended; mask &= mask - 1, asked++)
        ended = ask(p, i, r, first_of(mask));
    query_context_count(p->context, r, asked, escalated_of(p, i) - before);
    return ended;
}

static inline uint32_t origin_of(const packet *p, uint32_t i)
{
    const lane_rays *by = p->by_lane;

    return by ? by->origin[by->lanes.of ? by->lanes.of[i] : i] : p->rays[i]->origin_surface;
}

/* The lanes of a batch that count where all objects do. */
static uint32_t all_but_end(const packet *p, const leaf_batch *r)
{
    uint32_t out = leaf_batch_lanes(r);

    for (uint32_t i = 0; i < r->count; i++)
        out &= ~((uint32_t)(r->object[i] == p->end) << i);
    return out;
}

/* Does a lane of a batch count? */
static inline bool casts_at(const packet *p, const leaf_batch *r, uint32_t lane)
{
    return p->whole ? r->object[lane] != p->end : r->casts >> lane & 1;
}

/* The lanes of a batch that count. */
static inline uint32_t casts_of(const packet *p, const leaf_batch *r) { return p->whole ? all_but_end(p, r) : r->casts; }

/* Does it definitely block light? Of filters only narrow() knows the root that a ray starts on. */
static inline bool is_blocked(const packet *p, const leaf_batch *r, const pov_candidate *m, uint32_t blocking)
{
    return m->definite && (blocking >> m->lane & 1) && (r->object[m->lane] != origin_of(p, m->ray) || r->shape->narrow);
}

/* Must a possible hit of a block be intersected? Its ray's hits are initialised then. */
static bool is_open(packet *p, const leaf_batch *r, const pov_candidate *m)
{
    const pov_ray *ray = p->rays[m->ray];

    if (!casts_at(p, r, m->lane) || is_excluded(r, m->lane, ray, p->traversal.soa.excluded[m->ray]))
        return false;
    if ((r->opaque >> m->lane & 1) && r->object[m->lane] == ray->origin_surface && clear_solid_light_stays(p->world, ray, p->tmax))
        return false;
    begin_light(p, m->ray);
    return p->any_blocks || !clear_solid_passes(r, m, ray, &p->filter_hits[m->ray]);
}

/* The first n possible hits of a batch with a single shape, so that no ray occurs twice: their rays are transformed side by
 * side. Returns the lanes whose paths end here. */
static uint64_t take_instanced(packet *p, const leaf_batch *r, uint32_t n, uint64_t ended)
{
    const bool blocks = p->any_blocks || (r->opaque & 1);
    const pov_candidate *m = p->candidates;
    pov_ray own[WORLD_MANY];
    uint8_t lanes[WORLD_MANY];
    xform_batch instanced;
    pairs open;

    open.count = instanced.count = 0;
    leaf_batch_prefetch(r);
    for (; n > 0; m++, n--) {
        pov_hits *hits = blocks ? &p->hits[m->ray] : &p->filter_hits[m->ray];

        if ((ended >> m->ray & 1) || !is_open(p, r, m))
            continue;
        hits->owner = r->object[0];
        lanes[open.count] = m->ray;
        xform_batch_add(&instanced, leaf_batch_xform(r), p->rays[m->ray], &own[open.count]);
        pairs_put(&open, r->instances, &own[open.count], hits);
    }
    xform_batch_apply(&instanced);
    if (open.count > 0)
        pairs_ask(p->context, r->shape, leaf_batch_class(r), &open, false);
    for (ended = 0; blocks && open.count > 0; open.count--)
        ended |= open.hits[open.count - 1]->count > 0 ? bit_of(lanes[open.count - 1]) : 0;
    return ended;
}

/* Rays that may hit one shape, so that none occurs twice. Returns the lanes whose paths end here. */
static uint64_t ask_one_shape(packet *p, const leaf_batch *r, pairs *open, const uint8_t *lanes, bool blocks)
{
    uint64_t ended = 0;

    if (open->count > 0)
        pairs_ask(p->context, r->shape, leaf_batch_class(r), open, false);
    for (; blocks && open->count > 0; open->count--)
        ended |= open->hits[open->count - 1]->count > 0 ? bit_of(lanes[open->count - 1]) : 0;
    open->count = 0;
    return ended;
}

/* The first n possible hits of a batch, shape by shape: rays that may hit one are asked side by side. */
static uint64_t take_shapes(packet *p, const leaf_batch *r, uint32_t n, uint64_t ended)
{
    const pov_candidate *m = p->candidates;
    uint8_t lanes[WORLD_MANY];
    pairs open;

    open.count = 0;
    for (uint32_t lane = m->lane; n > 0; lane = m->lane, m++, n--) {
        bool blocks;
        pov_hits *hits;

        if (m->lane != lane)
            ended |= ask_one_shape(p, r, &open, lanes, p->any_blocks || (r->opaque >> lane & 1));
        if ((ended >> m->ray & 1) || !is_open(p, r, m))
            continue;
        blocks = p->any_blocks || (r->opaque >> m->lane & 1);
        hits = blocks ? &p->hits[m->ray] : &p->filter_hits[m->ray];
        hits->owner = r->object[m->lane];
        lanes[open.count] = m->ray;
        pairs_put(&open, leaf_batch_instance(r, m->lane), p->rays[m->ray], hits);
    }
    return ended | ask_one_shape(p, r, &open, lanes, p->any_blocks || (r->opaque >> m[-1].lane & 1));
}

/* Is it known without the ray that it has left the shape? As is_excluded(). */
static inline bool has_left(const packet *p, const leaf_batch *r, const pov_candidate *m)
{
    return r->object[m->lane] == p->traversal.soa.excluded[m->ray] && (r->plain >> m->lane & 1) && (r->shape->flags & POV_SHAPE_CONVEX);
}

/* Are some candidates left for what needs their rays? */
static bool any_open(const packet *p, const leaf_batch *r, const pov_candidate *m, uint32_t n, uint64_t ended)
{
    for (; n > 0; m++, n--)
        if (!(ended >> m->ray & 1) && casts_at(p, r, m->lane) && !has_left(p, r, m))
            return true;
    return false;
}

/* Does the class take several rays side by side? Of most it does so where any crossing will do, of boxes, spheres and planes also where all
 * are wanted. */
static bool takes_several(const packet *p, const leaf_batch *r)
{
    const bool all = r->shape->flags & (POV_SHAPE_BOX | POV_SHAPE_SPHERE) || r->shape->half_space;

    return r->shape == &csg_class || (r->shape->intersect_many && (all || p->any_blocks || r->opaque == leaf_batch_lanes(r)));
}

/* The lanes of a batch whose definite hits block light. */
static uint32_t blocking_of(const packet *p, const leaf_batch *r) { return casts_of(p, r) & r->plain & (p->any_blocks ? ~0u : r->opaque); }

/* Find candidates of shapes that are bounded by lane, but for rays that start on them. Adds lanes whose light is blocked to `ended`. */
static uint32_t find_bounded(packet *p, const leaf_batch *r, uint64_t lanes, uint64_t *ended)
{
    const uint32_t blocking = blocking_of(p, r);
    shape_bounds b;
    uint32_t n = 0;

    for (uint32_t which = 0; which < r->count && lanes; which++) {
        const uint64_t blocks = blocking >> which & 1 ? ~(uint64_t)0 : 0;
        uint64_t open = 0, blocked = 0;

        if (!casts_at(p, r, which) || r->object[which] == p->left)
            continue;
        packet_bounds(p, r, which, lanes, &b);
        for (b.definite &= blocks; b.maybe; b.maybe &= b.maybe - 1) {
            const uint64_t bit = b.maybe & -b.maybe;

            if (origin_of(p, first_of64(b.maybe)) != r->object[which])
                *(b.definite & bit ? &blocked : &open) |= bit;
        }
        lanes &= ~blocked;
        *ended |= blocked;
        n = packet_put_bounds(p, &b, which, open, n);
    }
    return n;
}

static uint32_t find_candidates(packet *p, const leaf_batch *r, uint64_t lanes, uint64_t *ended)
{
    const uint32_t n = leaf_batch_filter(r, p->traversal.in, &p->traversal.soa, lanes, p->candidates), blocking = blocking_of(p, r);

    for (uint32_t i = 0; i < n; i++)
        *ended |= (uint64_t)is_blocked(p, r, &p->candidates[i], blocking) << p->candidates[i].ray;
    return n;
}

static uint64_t filter(packet *p, const leaf_batch *r, uint64_t lanes)
{
    const pov_candidate *const m = p->candidates;
    uint64_t ended = 0;
    const uint32_t n = packet_has_bounds(r, lanes) ? find_bounded(p, r, lanes, &ended) : find_candidates(p, r, lanes, &ended);
    uint32_t i;

    if (p->by_lane) {
        if (!any_open(p, r, m, n, ended))
            return ended;
        packet_make_rays(p);
    }
    if (n > 1 && (r->flags & LEAF_INSTANCED) && !p->from)
        return ended | take_instanced(p, r, n, ended);
    if (n > 1 && takes_several(p, r) && !p->from)
        return take_shapes(p, r, n, ended);
    for (i = 0; i < n; i++)
        if (!(ended >> m[i].ray & 1) && is_open(p, r, &m[i]))
            ended |= (uint64_t)ask_some(p, m[i].ray, r, 1u << m[i].lane) << m[i].ray;
    return ended;
}

/* The same for several lanes and one shape of a batch whose class takes rays side by side. */
static uint64_t ask_together(packet *p, const leaf_batch *r, uint32_t which, uint64_t lanes)
{
    const bool blocks = p->any_blocks || (r->opaque >> which & 1);
    uint64_t ended = 0;
    pov_ray own[WORLD_MANY];
    uint8_t of[WORLD_MANY];
    xform_batch instanced;
    pairs some;

    some.count = instanced.count = 0;
    for (; lanes; lanes &= lanes - 1) {
        const uint32_t i = first_of64(lanes);
        pov_hits *hits = blocks ? &p->hits[i] : &p->filter_hits[i];

        if (!(possible_of(p, i, r) >> which & 1))
            continue;
        begin_light(p, i);
        hits->owner = r->object[which];
        of[some.count] = (uint8_t)i;
        if (r->flags & LEAF_INSTANCED)
            xform_batch_add(&instanced, leaf_batch_xform(r), p->rays[i], &own[some.count]);
        pairs_put(&some, leaf_batch_instance(r, which), r->flags & LEAF_INSTANCED ? &own[some.count] : p->rays[i], hits);
    }
    xform_batch_apply(&instanced);
    if (some.count > 0)
        pairs_ask(p->context, r->shape, leaf_batch_class(r), &some, false);
    for (; blocks && some.count > 0; some.count--)
        ended |= some.hits[some.count - 1]->count > 0 ? bit_of(of[some.count - 1]) : 0;
    return ended;
}

/* Does a batch's block filter rays by lane, however many lanes there are? One that knows roots at their starts needs the rays. */
static inline bool takes_lanes(const leaf_batch *r, uint64_t lanes)
{
    return (r->flags & (LEAF_PACKED | LEAF_INSTANCED | LEAF_RESERVED)) == (LEAF_PACKED | LEAF_RESERVED) && r->shape != &csg_class && !r->shape->narrow &&
           (r->count > 1 || (lanes & (lanes - 1)) != 0);
}

/* Have all rays left the only shape of a batch, so that none can hit it? */
static inline bool is_left(const packet *p, const leaf_batch *r)
{
    return r->object[0] == p->left && r->count == 1 && (r->plain & 1) && (r->shape->flags & POV_SHAPE_CONVEX);
}

static uint64_t leaf_occlusion(bvh_traversal *traversal, const void *leaf, uint64_t lanes)
{
    packet *p = (packet *)(void *)traversal;
    uint64_t ended = 0;
    const leaf_batch *r;

    for (r = leaf; r && lanes; r = leaf_batch_next(r)) {
        uint64_t exact;

        if (casts_of(p, r) == 0 || is_left(p, r))
            continue;
        if (p->by_lane && !takes_lanes(r, lanes))
            packet_make_rays(p);
        exact = exact_of(p, r, lanes);
        if (lanes & ~exact)
            ended |= filter(p, r, lanes & ~exact);
        for (uint32_t which = 0, together = packet_asks_together(p, r, exact) ? r->count : 0; which < together; which++)
            if (casts_at(p, r, which))
                ended |= ask_together(p, r, which, exact & ~ended);
        if (packet_asks_together(p, r, exact))
            exact = 0;
        for (; exact; exact &= exact - 1) {
            const uint32_t i = first_of64(exact);

            if (ask_some(p, i, r, casts_of(p, r) & possible_of(p, i, r)))
                ended |= bit_of(i);
        }
        lanes &= ~ended;
    }
    return ended;
}

static uint32_t find_left(const packet *p)
{
    const uint32_t *excluded = p->traversal.soa.excluded;
    uint32_t other = 0, i;

    for (i = 1; i < p->traversal.count; i++)
        other |= excluded[i] ^ excluded[0];
    return other ? POV_NO_OWNER : excluded[0];
}

uint64_t packet_occlusion(packet *p, bvh_traverse_fn *traverse)
{
    p->traversal.leaf = leaf_occlusion;
    p->context->csg.light = true;
    p->left = find_left(p);
    return packet_traverse(p, traverse, false);
}

/* ---- crossings ---- */

bool crossings_grow(pov_hits *hits)
{
    hit_buffer *buffer = hits->user;
    size_t capacity = buffer->capacity;

    if (capacity > UINT32_MAX / 2 ||
        !vec_reserve(buffer->context->env, (void **)&buffer->crossings, &capacity, hits->count,
                     sizeof *buffer->crossings)) {
        buffer->context->failed = true;
        return false;
    }
    buffer->capacity = hits->capacity = (uint32_t)capacity;
    hits->at = buffer->crossings;
    return true;
}

/* Shell sort: in place, and fast for few elements. */
void crossings_sort(pov_crossing *at, uint32_t count, bool (*is_before)(const pov_crossing *a, const pov_crossing *b))
{
    uint32_t gap, i, j;

    for (gap = 1; gap < count / 3; gap = 3 * gap + 1)
        ;
    for (; gap > 0; gap /= 3)
        for (i = gap; i < count; i++) {
            const pov_crossing c = at[i];

            for (j = i; j >= gap && is_before(&c, &at[j - gap]); j -= gap)
                at[j] = at[j - gap];
            at[j] = c;
        }
}

static inline bool is_before(const pov_crossing *a, const pov_crossing *b)
{
    return a->owner != b->owner ? a->owner < b->owner : a->t < b->t;
}

/* They mostly are in order. */
static inline bool are_in_order(const pov_crossing *at, uint32_t count)
{
    uint32_t i;

    for (i = 1; i < count; i++)
        if (is_before(&at[i], &at[i - 1]))
            return false;
    return true;
}

/* In scenes where whatever is there blocks. */
static uint64_t end_plain_light(packet *p, uint64_t blocked, occlusion *out)
{
    uint64_t dark = 0, rest;

    for (rest = p->asked; rest; rest &= rest - 1) {
        const uint32_t i = first_of64(rest);
        const pov_hits *hits = &p->hits[i];

        p->context->escalated += hits->escalated;
        if (hits->near_end && !(blocked >> i & 1))
            out->near_end |= bit_of(p->of[i]);
    }
    for (rest = blocked; rest; rest &= rest - 1)
        dark |= bit_of(p->of[first_of64(rest)]);
    return dark;
}

uint64_t packet_end_light(packet *p, uint64_t blocked, occlusion *out)
{
    uint64_t dark = 0, rest;

    if (p->any_blocks)
        return end_plain_light(p, blocked, out);
    for (rest = p->asked | blocked; rest; rest &= rest - 1) {
        const uint32_t i = first_of64(rest), of = p->of[i];
        const pov_hits *hits = &p->filter_hits[i];

        if (p->asked >> i & 1)
            p->context->escalated += escalated_of(p, i);
        if (blocked >> i & 1) {
            dark |= bit_of(of);
            continue;
        }
        if (p->hits[i].near_end | hits->near_end)
            out->near_end |= bit_of(of);
        if (hits->count == 0)
            continue;
        if (!are_in_order(hits->at, hits->count))
            crossings_sort(hits->at, hits->count, is_before);
        out->crossed |= bit_of(of);
        out->at[of] = hits->at;
        out->count[of] = hits->count;
    }
    return dark;
}

/* ---- the queries ---- */

/* Crossings are off by 32 units in the last place, 2^-47 of their distance: nearer the end than this, twice that and a
 * margin, more precision must tell on which side they are. */
static const double near_end = 0x1p-45;
/* A segment without end has nothing near it. */
double packet_near_end(double tmax) { return tmax < HUGE_VAL ? near_end * tmax : 0.0; }

/* Note solids that light leaves before it hits anything else. */
static void note_exits(packet *p)
{
    uint32_t i;

    for (i = 0; i < p->traversal.count; i++)
        if (clear_solid_light_exits(p->world, p->rays[i], p->tmax)) {
            packet_begin_light(p, i);
            clear_solid_note(&p->filter_hits[i], p->rays[i]->origin_surface);
            p->traversal.soa.excluded[i] = p->rays[i]->origin_surface;
        }
}

uint64_t query_occlusion(const world *w, query_context *k, const pov_ray *const *rays, uint32_t n, double tmax,
                         occlusion *out)
{
    bvh_group groups[BVH_GROUPS];
    uint64_t dark = 0;
    uint32_t count, i;
    packet p;

    out->crossed = out->near_end = 0;
    if (n == 0)
        return 0;
    count = packet_divide(w, rays, n, all_of(n), false, groups);
    for (i = 0; i < count; i++) {
        packet_begin(&p, w, k, rays, groups[i].lanes, tmax, tmax);
        p.slack = packet_near_end(tmax);
        p.any_blocks = !w->plan.coloured_shadows;
        if (!p.any_blocks && clear_solid_any_enters(p.rays, p.traversal.count))
            note_exits(&p);
        dark |= packet_end_light(&p, packet_occlusion(&p, groups[i].traverse), out);
    }
    return all_of(n) & ~dark;
}

uint64_t query_occlusion_lanes(const world *w, query_context *k, const lane_rays *rays, uint32_t n, double tmax, occlusion *out)
{
    uint64_t dark;
    packet p;

    if (rays->enters || !packet_begin_lanes(&p, w, k, rays, n, tmax))
        return query_occlusion(w, k, rays->make(rays->user), n, tmax, out);
    if (p.exact)
        packet_make_rays(&p);
    p.slack = packet_near_end(tmax);
    p.any_blocks = !w->plan.coloured_shadows;
    out->crossed = out->near_end = 0;
    dark = packet_end_light(&p, packet_occlusion(&p, w->kernels->any_packet), out);
    return all_of(n) & ~dark;
}

/* Does light end on one segment, with crossings in double-double? */
static bool is_blocked_exactly(const world *w, query_context *k, const pov_ray *ray, uint32_t which, double tmax,
                               bool any_blocks, occlusion *out)
{
    packet p;

    packet_begin(&p, w, k, &ray, 1, tmax, tmax);
    p.of[0] = (uint8_t)which;
    p.candidates_only = p.exact == 0;
    p.exact = 1;
    p.any_blocks = any_blocks;
    out->crossed &= ~bit_of(which);
    return packet_end_light(&p, segment_end_occlusion(&p), out) != 0;
}

bool query_occlusion_exact(const world *w, query_context *k, const pov_ray *ray, uint32_t which, double tmax,
                           occlusion *out)
{
    return !is_blocked_exactly(w, k, ray, which, tmax, !w->plan.coloured_shadows, out);
}

static bool blocks_any(const world *w, query_context *k, const pov_ray *ray, double tmax)
{
    occlusion found;
    packet p;

    packet_begin(&p, w, k, &ray, 1, tmax, tmax);
    p.slack = packet_near_end(tmax);
    p.any_blocks = true;
    found.crossed = found.near_end = 0;
    if (packet_end_light(&p, packet_occlusion(&p, w->kernels->any_single), &found))
        return true;
    return found.near_end && is_blocked_exactly(w, k, ray, 0, tmax, true, &found);
}

/* What doubles find may lie at the start, by a distance that is zero but for rounding, or at the end. */
bool query_blocked(const world *w, query_context *k, const pov_ray *ray, double tmax)
{
    coincident_set from;
    occlusion found;

    if (!blocks_any(w, k, ray, tmax))
        return false;
    if (start_find(w, k, ray, tmax, &from))
        return from.count == 0 || query_blocked_from(w, k, &from, ray, tmax);
    found.crossed = found.near_end = 0;
    return is_blocked_exactly(w, k, ray, 0, tmax, true, &found);
}
