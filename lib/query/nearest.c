#include "query/packet.h"

#include "base/simd.h"

static pov_hits *nearest_hits(company *c, uint32_t i)
{
    if (!(c->asked & bit_of(i))) {
        c->asked |= bit_of(i);
        bvh_write(&c->party, i);
        begin_hits(&c->hits[i], c->world, c->tmax, POV_WANT_NEAREST, &c->out[c->of[i]].crossing);
    }
    return &c->hits[i];
}

static void ask_nearest(company *c, uint32_t i, const run *r, uint32_t lane)
{
    pov_hits *hits = nearest_hits(c, i);

    hits->owner = r->object[lane];
    run_intersect(r, lane, c->rays[i], hits);
    if (hits->tmax < c->party.limit[i])
        lower(c, i, hits->tmax);
}

static void count_nearest(company *c, uint32_t i, const run *r, uint32_t lane)
{
    const uint32_t before = nearest_hits(c, i)->decided;

    ask_nearest(c, i, r, lane);
    walker_count(c->walker, r, 1, c->hits[i].decided - before);
}

/* Pairs of one class that may be asked together. */
typedef struct pairs {
    uint32_t count;
    const void *selves[WORLD_MANY];
    const pov_ray *rays[WORLD_MANY];
    pov_hits *hits[WORLD_MANY];
} pairs;

static inline void put_pair(pairs *some, const void *self, const pov_ray *ray, pov_hits *hits)
{
    const uint32_t n = some->count++;

    some->selves[n] = self;
    some->rays[n] = ray;
    some->hits[n] = hits;
}

/* The ray that a placed shape is asked with, which is found with the other places; it is kept for the normal. */
static inline const pov_ray *own_ray(walker *k, places *some, const placement *at, const pov_ray *ray, uint32_t which,
                                     uint32_t owner)
{
    pov_ray *own = &k->own.rays[which];

    k->own.of[which] = owner;
    k->own.known |= bit_of(which);
    places_put(some, at, ray, own);
    return own;
}

/* crossed: all of them surely are. */
static inline void ask_pairs(walker *k, const shape_class *shape, uint32_t class_number, pairs *some, bool crossed)
{
    uint32_t decided = 0, i;

    for (i = 0; i < some->count; i++)
        decided -= some->hits[i]->decided;
    if (crossed && shape->cross_many != NULL)
        shape->cross_many(some->selves, some->rays, some->hits, some->count);
    else if (shape->intersect_many != NULL)
        shape->intersect_many(some->selves, some->rays, some->hits, some->count);
    else
        for (i = 0; i < some->count; i++)
            shape->intersect(some->selves[i], some->rays[i], some->hits[i]);
    for (i = 0; i < some->count; i++)
        decided += some->hits[i]->decided;
    walker_count_class(k, class_number, some->count, decided);
}

/* One that can be left out by now need not wait any more; if it cannot, it is asked before the next one waits. */
static void put_off(company *c, const run *r, const pov_meeting *m)
{
    const uint32_t i = m->ray;
    pending *p = &c->pending[i];

    if (m->hi < c->party.limit[i])
        lower(c, i, m->hi);
    if ((c->waiting & bit_of(i)) && !is_beyond(p->lo, c->party.limit[i]))
        count_nearest(c, i, p->run, p->lane);
    p->run = r;
    p->lane = m->lane;
    p->lo = m->lo;
    c->waiting |= bit_of(i);
    SIMD_EXPECT(run_instance(r, m->lane));
}

/* What a filter leaves open of a run that holds one shape, so that no ray is there twice. */
static void ask_open(company *c, const run *r, pairs *open, const places *placed, const uint8_t *lanes)
{
    uint32_t i;

    places_find(placed);
    ask_pairs(c->walker, r->shape, run_class(r), open, false);
    for (i = 0; i < open->count; i++)
        if (open->hits[i]->tmax < c->party.limit[lanes[i]])
            lower(c, lanes[i], open->hits[i]->tmax);
}

static void filter_nearest(company *c, const run *r, uint64_t lanes)
{
    const pov_meeting *m = c->met;
    uint32_t n = run_filter(r, c->party.in, &c->party.side, lanes, c->met);
    uint8_t open_lanes[WORLD_MANY];
    places placed;
    pairs open;

    open.count = placed.count = 0;
    for (; n > 0; m++, n--) {
        const bool left = r->object[m->lane] == c->rays[m->ray]->left;
        const pov_ray *ray = c->rays[m->ray];

        if (is_beyond(m->lo, c->party.limit[m->ray]) ||
            (left && is_settled(r, m->lane, ray, c->party.side.away[m->ray])))
            continue;
        /* The filter knows nothing of the root that a ray leaves. */
        if (m->surely && !left) {
            put_off(c, r, m);
        } else if (r->flags & RUN_PLACED) {
            pov_hits *hits = nearest_hits(c, m->ray);

            run_expect(r);
            open_lanes[open.count] = (uint8_t)m->ray;
            hits->owner = r->object[0];
            ray = own_ray(c->walker, &placed, run_placement(r), ray, c->of[m->ray], hits->owner);
            put_pair(&open, r->instances, ray, hits);
        } else {
            count_nearest(c, m->ray, r, m->lane);
        }
    }
    if (open.count > 0)
        ask_open(c, r, &open, &placed, open_lanes);
}

static uint64_t meet_nearest(bvh_party *party, const void *leaf, uint64_t lanes)
{
    company *c = (company *)(void *)party;
    const run *r;
    uint64_t met;
    uint32_t mask, asked, decided;

    for (r = leaf; r; r = run_next(r)) {
        if (r->flags & RUN_PACKED) {
            filter_nearest(c, r, lanes);
            continue;
        }
        asked = decided = 0;
        for (met = lanes; met; met &= met - 1) {
            const uint32_t i = first_of64(met);

            mask = run_lanes(r) & ~left_behind(r, c->rays[i], party->side.away[i]);
            if (!mask)
                continue;
            decided -= nearest_hits(c, i)->decided;
            for (; mask; mask &= mask - 1, asked++)
                ask_nearest(c, i, r, first_of(mask));
            decided += c->hits[i].decided;
        }
        walker_count(c->walker, r, asked, decided);
    }
    return 0;
}

static bool nearest_alone(bvh_party *party, uint32_t lane, uint32_t frame, uint32_t at)
{
    company *c = (company *)(void *)party;
    query q;

    q.walker = c->walker;
    q.walk.tree = party->tree;
    q.walk.frame = frame;
    q.walk.at = at;
    q.walk.limit = party->limit[lane];
    q.hits = *nearest_hits(c, lane);
    query_go_on(&q, c->rays[lane], party->side.away[lane], party->length[lane], party->side.per_length[lane]);
    query_go_on_nearest(&q, c->world);
    c->hits[lane] = q.hits;
    if (q.walk.limit < party->limit[lane])
        lower(c, lane, q.walk.limit);
    return false;
}

/* Take those of `left` that are of a class, to whose spaces rays have been taken; the others are left. */
static uint64_t take_class(company *c, const shape_class *shape, uint64_t left, pairs *out)
{
    uint64_t rest, others = 0;

    out->count = 0;
    for (rest = left; rest; rest &= rest - 1) {
        const uint32_t i = first_of64(rest);
        const pending *p = &c->pending[i];
        const pov_ray *ray = p->run->flags & RUN_PLACED ? &c->walker->own.rays[c->of[i]] : c->rays[i];
        pov_hits *hits;

        if (p->run->shape != shape) {
            others |= bit_of(i);
            continue;
        }
        hits = nearest_hits(c, i);
        hits->owner = p->run->object[p->lane];
        put_pair(out, run_instance(p->run, p->lane), ray, hits);
    }
    return others;
}

/* Ask those that wait and can still be the nearest. */
static void settle(company *c)
{
    uint64_t left = 0, rest;
    places placed;
    pairs some;

    placed.count = 0;
    for (rest = c->waiting; rest; rest &= rest - 1) {
        const uint32_t i = first_of64(rest);
        const run *r = c->pending[i].run;

        if (is_beyond(c->pending[i].lo, c->party.limit[i]))
            continue;
        left |= bit_of(i);
        if (!(r->flags & RUN_PLACED))
            continue;
        bvh_write(&c->party, i);
        own_ray(c->walker, &placed, run_placement(r), c->rays[i], c->of[i], r->object[0]);
    }
    places_find(&placed);
    while (left) {
        const run *r = c->pending[first_of64(left)].run;

        left = take_class(c, r->shape, left, &some);
        ask_pairs(c->walker, r->shape, run_class(r), &some, true);
    }
}

/* ---- exits ---- */

static inline const shape_group *group_of(const world *w, uint32_t which) { return &w->groups[w->things[which].group]; }

/* Ask those of `left` that start on a shape of the class of the first; the others are left. */
static uint64_t find_class_exits(const world *w, walker *k, const pov_ray *const *rays, uint64_t left, exits *e)
{
    const shape_group *first = group_of(w, rays[first_of64(left)]->left);
    uint64_t others = 0;
    places placed;
    pairs some;

    some.count = placed.count = 0;
    for (; left; left &= left - 1) {
        const uint32_t i = first_of64(left), which = rays[i]->left;
        const pov_ray *ray = rays[i];
        shape_place place;

        if (group_of(w, which)->shape != first->shape) {
            others |= bit_of(i);
            continue;
        }
        place = world_place(w, which);
        e->hits[i].owner = which;
        if (place.placement)
            ray = own_ray(k, &placed, place.placement, ray, i, which);
        put_pair(&some, place.instance, ray, &e->hits[i]);
    }
    places_find(&placed);
    ask_pairs(k, first->shape, first->class_number, &some, false);
    return others;
}

/* Nothing else can be met in a shape that stands alone. */
static void leave_lonely(const world *w, walker *k, const pov_ray *const *rays, hit *out, exits *e)
{
    uint64_t rest;

    for (rest = e->known; w->lonely && rest; rest &= rest - 1) {
        const uint32_t i = first_of64(rest);

        if (e->hits[i].count == 0 || !w->lonely[rays[i]->left])
            continue;
        k->decided += e->hits[i].decided;
        out[i].object = rays[i]->left;
        out[i].company = 0;
        e->met |= bit_of(i);
    }
}

void company_find_exits(const world *w, walker *k, const pov_ray *const *rays, uint32_t n, double tmax, hit *out,
                        exits *e)
{
    uint64_t left;
    uint32_t i;

    e->known = e->met = 0;
    if (!w->plan.transmission || !any_goes_in(rays, n))
        return;
    for (i = 0; i < n; i++)
        if (goes_in(rays[i])) {
            e->known |= bit_of(i);
            begin_hits(&e->hits[i], w, tmax, POV_WANT_NEAREST, &out[i].crossing);
        }
    for (left = e->known; left;)
        left = find_class_exits(w, k, rays, left, e);
    leave_lonely(w, k, rays, out, e);
}

static void begin_from_exits(company *c, const exits *e)
{
    uint32_t i;

    for (i = 0; e->known && i < c->party.count; i++) {
        const pov_hits *known = &e->hits[c->of[i]];

        if (!(e->known >> c->of[i] & 1))
            continue;
        c->asked |= bit_of(i);
        c->hits[i] = *known;
        c->party.side.away[i] = c->rays[i]->left;
        if (known->tmax < c->party.limit[i])
            lower(c, i, known->tmax);
    }
}

/* What was met, as bits of the caller's. */
static uint64_t end_nearest(company *c)
{
    uint64_t met = 0, rest;

    for (rest = c->asked & c->party.lanes; rest; rest &= rest - 1) {
        const uint32_t i = first_of64(rest);
        const pov_hits *hits = &c->hits[i];
        hit *out = &c->out[c->of[i]];

        c->walker->decided += hits->decided;
        if (hits->count == 0)
            continue;
        out->object = out->crossing.owner;
        out->company = 0;
        met |= bit_of(c->of[i]);
        SIMD_EXPECT(&c->world->things[out->object]);
        if (hits->crowded)
            spot_choose(c->world, c->walker, c->rays[i], NULL, out);
    }
    return met;
}

uint64_t company_nearest_apart(const world *w, walker *k, const pov_ray *const *rays, uint64_t which, double tmax,
                               const exits *e, hit *out)
{
    uint32_t n = 0;
    company c;
    query q;

    c.walker = k;
    c.world = w;
    c.tmax = tmax;
    c.out = out;
    c.party.written = NULL;
    c.waiting = 0;
    for (; which; which &= which - 1, n++) {
        const uint32_t i = first_of64(which);

        query_nearest(&q, w, k, rays[i], tmax, e->known >> i & 1 ? &e->hits[i] : NULL, &out[i].crossing);
        if (query_settle_but_one(&q, &c.pending[n]))
            c.waiting |= bit_of(n);
        c.rays[n] = rays[i];
        c.of[n] = (uint8_t)i;
        c.hits[n] = q.hits;
        c.party.limit[n] = q.walk.limit;
    }
    c.asked = c.party.lanes = all_of(n);
    settle(&c);
    return end_nearest(&c);
}

/* What the tree and the lists say of a company that has begun; alone: of its lanes those that go alone. As bits of the
 * caller's. */
static uint64_t find_nearest(company *c, uint64_t alone, const exits *e, bvh_travel *travel)
{
    const world *w = c->world;
    uint64_t met = 0;

    c->party.lanes = all_of(c->party.count) & ~alone;
    for (; alone; alone &= alone - 1) {
        const uint32_t i = first_of64(alone), of = c->of[i];

        bvh_write(&c->party, i);
        met |= (uint64_t)world_nearest(w, c->walker, c->rays[i], c->tmax, &c->out[of]) << of;
    }
    if (!c->party.lanes)
        return met;
    if (e)
        begin_from_exits(c, e);
    if (w->infinite)
        meet_nearest(&c->party, w->infinite, c->party.lanes);
    if (w->list)
        meet_nearest(&c->party, w->list, company_stand_in_list(c, c->party.lanes));
    c->party.lowered = 0;
    if (w->has_tree)
        travel(&c->party);
    settle(c);
    return met | end_nearest(c);
}

uint64_t company_nearest(const world *w, walker *k, const pov_ray *const *rays, uint64_t which, double tmax,
                         const exits *e, bvh_travel *travel, hit *out)
{
    company c;

    c.out = out;
    c.party.leaf = meet_nearest;
    c.party.alone = nearest_alone;
    return find_nearest(&c, company_begin(&c, w, k, rays, which, tmax, just_beyond(tmax)), e, travel);
}

uint64_t company_nearest_fan(const world *w, walker *k, pov_ray *rays, const vec_lanes *ways, uint32_t n, double tmax,
                             hit *out)
{
    company c;

    c.out = out;
    c.party.leaf = meet_nearest;
    c.party.alone = nearest_alone;
    return find_nearest(&c, company_begin_fan(&c, w, k, rays, ways, n, tmax, just_beyond(tmax)), NULL,
                        w->walks->nearest_together);
}
