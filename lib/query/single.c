#include "query/single.h"

#include "base/bits.h"
#include "base/simd.h"
#include "base/vec.h"

#include <string.h>

/* ---- what all queries share ---- */

static void begin(query *q, const world *w, walker *k, const pov_ray *ray, double tmax, pov_want want,
                  pov_crossing *at)
{
    q->walker = k;
    q->walk.tree = &w->tree;
    q->walk.ray = ray;
    q->walk.frame = 0;
    q->walk.at = w->has_tree ? w->tree.frames[0].root : 0;
    q->walk.limit = tmax;
    q->walk.framed = &q->rays;
    q->walk.in = NULL;
    q->waiting = 0;
    side_put(&q->rays, 0, ray);
    q->in_range = side_derive(&q->rays, 0, tmax, &q->walk.length) != 0;
    q->walk.per_length = q->rays.per_length[0];
    begin_hits(&q->hits, w, tmax, want, at);
}

/* False: it passes the list by. */
static bool stand_in_list(query *q, const world *w)
{
    bvh_local l;

    if (!w->list_packed)
        return true;
    if (!bvh_enter(&w->list_frame, q->walk.ray, q->walk.length, q->walk.per_length, &l))
        return false;
    bvh_stand(&q->rays, 0, &l, bvh_limit(l.scale, l.shift, q->walk.limit));
    q->walk.in = &w->list_frame;
    return true;
}

/* Where a ray starts on the only shape of a run, a filter would say "perhaps"; the shape knows the rest by name. */
static inline bool is_filtered(const query *q, const run *r)
{
    return (r->flags & RUN_PACKED) && q->in_range && (r->count > 1 || r->object[0] != q->walk.ray->left);
}

/* ---- nearest ---- */

static void ask_nearest(query *q, const run *r, uint32_t lane)
{
    q->hits.owner = r->object[lane];
    run_intersect(r, lane, q->walk.ray, &q->hits);
    if (q->hits.tmax < q->walk.limit)
        q->walk.limit = q->hits.tmax;
}

static void count_nearest(query *q, const run *r, uint32_t lane)
{
    const uint32_t before = q->hits.decided;

    ask_nearest(q, r, lane);
    walker_count(q->walker, r, 1, q->hits.decided - before);
}

/* Ask those that wait and can still be the nearest; the last to come are probably the nearest. */
static void settle(query *q)
{
    while (q->waiting > 0) {
        const pending *p = &q->pending[--q->waiting];
        if (!is_beyond(p->lo, q->walk.limit))
            count_nearest(q, p->run, p->lane);
    }
}

static void put_off(query *q, const run *r, uint32_t lane, double lo, double hi)
{
    pending *p;

    if (q->waiting == PENDING_MAX)
        settle(q);
    p = &q->pending[q->waiting++];
    p->run = r;
    p->lane = lane;
    p->lo = lo;
    SIMD_EXPECT(run_instance(r, lane));
    if (hi < q->walk.limit)
        q->walk.limit = hi;
}

static void filter_nearest(query *q, const run *r)
{
    const pov_ray *ray = q->walk.ray;
    pov_meeting met[POV_BLOCK_MAX];
    const pov_meeting *m;
    uint32_t n;

    q->rays.tmax[0] = just_beyond(q->walk.limit);
    n = run_filter(r, q->walk.in, &q->rays, 1, met);
    for (m = met; n > 0; m++, n--) {
        const bool left = r->object[m->lane] == ray->left;

        if (is_beyond(m->lo, q->walk.limit) || (left && is_settled(r, m->lane, ray, q->rays.away[0])))
            continue;
        /* The filter knows nothing of the root that a ray leaves. */
        if (m->surely && !left)
            put_off(q, r, m->lane, m->lo, m->hi);
        else
            count_nearest(q, r, m->lane);
    }
}

static bool meet_nearest(bvh_walk *walk, const void *leaf)
{
    query *q = (query *)(void *)walk;
    const run *r;
    uint32_t mask, asked, before;

    for (r = leaf; r; r = run_next(r)) {
        if (is_filtered(q, r)) {
            filter_nearest(q, r);
            continue;
        }
        asked = 0;
        before = q->hits.decided;
        for (mask = run_lanes(r) & ~left_behind(r, walk->ray, q->rays.away[0]); mask; mask &= mask - 1, asked++)
            ask_nearest(q, r, first_of(mask));
        walker_count(q->walker, r, asked, q->hits.decided - before);
    }
    return false;
}

void query_go_on(query *q, const pov_ray *ray, uint32_t away, double length, double per_length)
{
    q->rays.away[0] = away;
    q->walk.ray = ray;
    q->walk.length = length;
    q->walk.per_length = per_length;
    q->walk.framed = NULL;
    q->in_range = false;
}

void query_go_on_nearest(query *q, const world *w)
{
    q->waiting = 0;
    q->walk.leaf = meet_nearest;
    w->walks->nearest_first(&q->walk);
    settle(q);
}

void query_nearest(query *q, const world *w, walker *k, const pov_ray *ray, double tmax, const pov_hits *known,
                   pov_crossing *at)
{
    begin(q, w, k, ray, tmax, POV_WANT_NEAREST, at);
    if (known) {
        q->hits = *known;
        q->walk.limit = known->tmax;
        q->rays.away[0] = ray->left;
    }
    q->walk.leaf = meet_nearest;
    if (w->infinite)
        meet_nearest(&q->walk, w->infinite);
    if (w->list && stand_in_list(q, w))
        meet_nearest(&q->walk, w->list);
    if (w->has_tree)
        w->walks->nearest_first(&q->walk);
}

bool query_settle_but_one(query *q, pending *one)
{
    bool left = false;

    while (q->waiting > 0) {
        const pending *p = &q->pending[--q->waiting];

        if (is_beyond(p->lo, q->walk.limit))
            continue;
        if (left || !p->run->shape->intersect_many) {
            count_nearest(q, p->run, p->lane);
        } else {
            *one = *p;
            left = true;
        }
    }
    return left;
}

bool world_nearest(const world *w, walker *k, const pov_ray *ray, double tmax, hit *out)
{
    query q;

    query_nearest(&q, w, k, ray, tmax, NULL, &out->crossing);
    settle(&q);
    k->decided += q.hits.decided;
    out->object = q.hits.count ? out->crossing.owner : POV_NOBODY;
    out->company = 0;
    if (q.hits.crowded)
        spot_choose(w, k, ray, NULL, out);
    return q.hits.count > 0;
}

/* ---- shadows ---- */

bool crossings_grow(pov_hits *hits)
{
    tint_room *room = hits->user;
    size_t capacity = room->capacity;

    if (capacity > UINT32_MAX / 2 ||
        !vec_reserve(room->walker->env, (void **)&room->crossings, &capacity, hits->count, sizeof *room->crossings)) {
        room->walker->failed = true;
        return false;
    }
    room->capacity = hits->capacity = (uint32_t)capacity;
    hits->at = room->crossings;
    return true;
}

/* True: the path ends here. */
static bool ask_shadow(query *q, const run *r, uint32_t lane)
{
    bool blocks = q->any_blocks || (r->opaque >> lane & 1);
    pov_hits *hits = blocks ? &q->hits : &q->tints;

    hits->owner = r->object[lane];
    run_intersect(r, lane, q->walk.ray, hits);
    return blocks && hits->count > 0;
}

static inline uint32_t decided_of(const query *q) { return q->hits.decided + (q->any_blocks ? 0 : q->tints.decided); }

static bool ask_shadows(query *q, const run *r, uint32_t mask)
{
    const uint32_t before = decided_of(q);
    uint32_t asked = 0;
    bool ended = false;

    if (!mask)
        return false;
    for (; mask && !ended; mask &= mask - 1, asked++)
        ended = ask_shadow(q, r, first_of(mask));
    walker_count(q->walker, r, asked, decided_of(q) - before);
    return ended;
}

static bool filter_shadow(query *q, const run *r)
{
    const uint32_t blocking = q->any_blocks ? r->casts : r->casts & r->opaque;
    const pov_ray *ray = q->walk.ray;
    pov_meeting met[POV_BLOCK_MAX];
    uint32_t n, i, mask = 0;

    n = run_filter(r, q->walk.in, &q->rays, 1, met);
    for (i = 0; i < n; i++)
        if (is_blocked(r, &met[i], blocking, ray))
            return true;
    for (i = 0; i < n; i++)
        if ((r->casts >> met[i].lane & 1) && (q->any_blocks || !passes_through(r, &met[i], ray, &q->tints)))
            mask |= 1u << met[i].lane;
    return ask_shadows(q, r, mask & ~left_behind(r, ray, q->rays.away[0]));
}

static bool meet_shadow(bvh_walk *walk, const void *leaf)
{
    query *q = (query *)(void *)walk;
    const run *r;

    for (r = leaf; r; r = run_next(r)) {
        if (r->casts == 0)
            continue;
        if (is_filtered(q, r) ? filter_shadow(q, r)
                              : ask_shadows(q, r, r->casts & ~left_behind(r, walk->ray, q->rays.away[0])))
            return true;
    }
    return false;
}

/* True: something that blocks stands on the way, before the tree is asked. */
static bool begin_shadow(query *q, const world *w)
{
    q->walk.leaf = meet_shadow;
    return (w->infinite && meet_shadow(&q->walk, w->infinite)) || (w->list && stand_in_list(q, w) && meet_shadow(&q->walk, w->list));
}

bool world_blocked(const world *w, walker *k, const pov_ray *ray, double tmax)
{
    pov_crossing at;
    query q;
    bool blocked;

    begin(&q, w, k, ray, tmax, POV_WANT_ANY, &at);
    q.any_blocks = true;
    blocked = begin_shadow(&q, w) || (w->has_tree && w->walks->any_order(&q.walk));
    k->decided += q.hits.decided;
    return blocked;
}

/* ---- light through transparent shapes ---- */

/* What decides between equals only has to be the same for the tree and the list. */
static bool is_nearer(const pov_crossing *a, const pov_crossing *b)
{
    if (a->t != b->t)
        return a->t < b->t;
    if (a->t_lo != b->t_lo)
        return a->t_lo < b->t_lo;
    return a->owner < b->owner;
}

static bool is_of_earlier(const pov_crossing *a, const pov_crossing *b) { return a->owner < b->owner; }

/* Shell's sort: in place, and fast for the few there are. */
static void sort(pov_crossing *at, uint32_t count, bool (*is_before)(const pov_crossing *a, const pov_crossing *b))
{
    uint32_t gap, i, j;

    for (gap = 1; gap < count / 3; gap = 3 * gap + 1)
        ;
    for (; gap > 0; gap /= 3)
        for (i = gap; i < count; i++) {
            pov_crossing c = at[i];
            for (j = i; j >= gap && is_before(&c, &at[j - gap]); j -= gap)
                at[j] = at[j - gap];
            at[j] = c;
        }
}

void crossings_sort(pov_crossing *at, uint32_t count)
{
    sort(at, count, is_nearer);
}

static bool are_in_order(const pov_crossing *at, uint32_t count)
{
    uint32_t i;

    for (i = 1; i < count; i++)
        if (is_of_earlier(&at[i], &at[i - 1]))
            return false;
    return true;
}

/* Where on its way light meets a filter does not matter to what is left of it. The product is rounded once, and its
 * order that of the objects: it is the same for the tree and the list. */
bool crossings_multiply(const world *w, pov_crossing *at, uint32_t count, colour *through)
{
    double r = (double)through->r, g = (double)through->g, b = (double)through->b;
    uint32_t i;

    if (!are_in_order(at, count))
        sort(at, count, is_of_earlier);
    for (i = 0; i < count; i++) {
        const colour filter = crossing_filter(w, &at[i]);

        r *= (double)filter.r;
        g *= (double)filter.g;
        b *= (double)filter.b;
    }
    *through = colour_of((float)r, (float)g, (float)b);
    return !colour_is_black(*through);
}

void begin_tints(pov_hits *tints, const world *w, double tmax, tint_room *room)
{
    begin_hits(tints, w, tmax, POV_WANT_ALL, room->crossings);
    tints->count_only = true;
    tints->capacity = room->capacity;
    tints->grow = crossings_grow;
    tints->user = room;
}

/* Does a way end beyond an interval, by more than ends and bounds are rounded? */
static inline bool is_out(double from, double way, double lo, double hi)
{
    const double slack = 0x1p-40 * (fabs(from) + fabs(way)), end = from + way;

    return end + slack < lo || end - slack > hi;
}

bool light_comes_out(const world *w, const pov_ray *ray, double tmax)
{
    const pov_vec3 way = pov_scale(ray->dir, tmax), lo = w->clear.lo, hi = w->clear.hi;

    if (!w->things[ray->left].tints)
        return false;
    return is_out(ray->org.x, way.x, lo.x, hi.x) || is_out(ray->org.y, way.y, lo.y, hi.y) ||
           is_out(ray->org.z, way.z, lo.z, hi.z);
}

bool query_go_on_light(query *q, const world *w)
{
    q->walk.leaf = meet_shadow;
    return w->walks->any_order(&q->walk);
}

bool world_light_path(const world *w, walker *k, const pov_ray *ray, double tmax, colour *through)
{
    tint_room *room = &k->rooms[0];
    query q;
    bool blocked;

    begin(&q, w, k, ray, tmax, POV_WANT_ANY, &room->blocking);
    q.any_blocks = !w->plan.coloured_shadows;
    if (!q.any_blocks) {
        begin_tints(&q.tints, w, tmax, room);
        if (goes_in(ray) && light_comes_out(w, ray, tmax)) {
            note_tint(&q.tints, ray->left);
            q.rays.away[0] = ray->left;
        }
    }
    blocked = begin_shadow(&q, w) || (w->has_tree && w->walks->any_order(&q.walk));
    k->decided += q.hits.decided + (q.any_blocks ? 0 : q.tints.decided);
    return end_light(w, blocked, q.any_blocks ? NULL : &q.tints, through);
}
