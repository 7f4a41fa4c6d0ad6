#include "base/simd.h"
#include "world/bits.h"
#include "world/query.h"

/* Fewer rays of one octant are better off alone: two in company are 3 to 4 % slower on the whole, four 1 %. */
enum { COMPANY_LEAST = 8 };

/* Queries of rays that go together. Most rays never come to need hits of their own, so these are begun when they do. */
typedef struct company {
    bvh_party party;             /* first: leaves are handed this */
    const world *world;
    walker *walker;
    const pov_ray *rays[WORLD_MANY];
    uint8_t of[WORLD_MANY];      /* by lane: which of the caller's it is */
    double tmax;
    bool any_blocks;             /* transparent or not */
    uint64_t asked;              /* lanes whose hits have been begun */
    uint64_t waiting;            /* lanes that have a shape pending */
    hit *out;                    /* the caller's; NULL: light is asked for */
    pending pending[WORLD_MANY];
    pov_block_answer answers[WORLD_MANY];
    pov_hits hits[WORLD_MANY], tints[WORLD_MANY];
} company;

static inline uint64_t bit_of(uint32_t i) { return (uint64_t)1 << i; }
static inline uint64_t all_of(uint32_t n) { return ~(uint64_t)0 >> (WORLD_MANY - n); }

/* ---- rays by component ---- */

static inline void put_ray(pov_rays *s, uint32_t i, const pov_ray *ray)
{
    s->org[0][i] = ray->org.x;
    s->org[1][i] = ray->org.y;
    s->org[2][i] = ray->org.z;
    s->org_lo[0][i] = ray->org_lo.x;
    s->org_lo[1][i] = ray->org_lo.y;
    s->org_lo[2][i] = ray->org_lo.z;
    s->dir[0][i] = ray->dir.x;
    s->dir[1][i] = ray->dir.y;
    s->dir[2][i] = ray->dir.z;
}

static inline double is_out(double x, double least, double most)
{
    const double size = fabs(x);

    return size <= most && (size >= least || size == 0.0) ? 0.0 : 1.0;
}

/* What follows from a ray. odd: not zero where it is out of the range that filters are promised. */
SIMD_CLONES static void derive(pov_rays *restrict s, uint32_t width, double tmax, double *restrict odd)
{
    uint32_t i;

    for (i = 0; i < width; i++) {
        const double x = s->dir[0][i], y = s->dir[1][i], z = s->dir[2][i], square = x * x + y * y + z * z;

        s->inverse[i] = 1.0 / square;
        s->per_length[i] = sqrt(s->inverse[i]);
        s->size[i] = fabs(s->org[0][i]) + fabs(s->org[1][i]) + fabs(s->org[2][i]);
        s->tmax[i] = tmax;
        odd[i] = is_out(x, 1e-80, 1e80) + is_out(y, 1e-80, 1e80) + is_out(z, 1e-80, 1e80) +
                 is_out(s->size[i], 0.0, 1e100) + (square > 0.0 ? 0.0 : 1.0);
    }
}

/* Take those of `which`. Lanes that hold a ray out of range are told: they are to go alone. */
static uint64_t take_rays(company *c, const pov_ray *const *rays, uint64_t which)
{
    double odd[WORLD_MANY];
    uint64_t alone = 0;
    uint32_t n = 0, i;

    for (; which; which &= which - 1) {
        i = first_of64(which);
        c->rays[n] = rays[i];
        c->of[n] = (uint8_t)i;
        put_ray(&c->party.side, n++, rays[i]);
    }
    c->party.count = n;
    for (i = n; i % 8; i++)
        put_ray(&c->party.side, i, c->rays[n - 1]);
    derive(&c->party.side, i, just_beyond(c->tmax), odd);
    while (i-- > 0) {
        c->party.limit[i] = c->tmax;
        if (odd[i] != 0.0 && i < n)
            alone |= bit_of(i);
    }
    return alone;
}

static void begin(company *c, const world *w, walker *k, double tmax)
{
    c->party.tree = &w->tree;
    c->party.rays = c->rays;
    c->party.lowered = 0;
    c->world = w;
    c->walker = k;
    c->tmax = tmax;
    c->asked = c->waiting = 0;
}

/* ---- leaves ---- */

/* The answers of a run's block for some lanes; those of whom any shape is in question are told. */
static uint64_t filter(company *c, const run *r, uint64_t lanes)
{
    const pov_shape_class *shape = r->shape;
    uint64_t met = 0;

    if (POV_SHAPE_HAS(shape, block_filter_many))
        return shape->block_filter_many(run_block(r), &c->party.side, lanes, c->answers);
    for (; lanes; lanes &= lanes - 1) {
        const uint32_t i = first_of64(lanes);

        shape->block_filter(run_block(r), c->rays[i], 0.0, c->party.side.tmax[i], &c->answers[i]);
        if (c->answers[i].maybe)
            met |= bit_of(i);
    }
    return met;
}

static inline void lower(company *c, uint32_t i, double limit)
{
    c->party.limit[i] = limit;
    c->party.side.tmax[i] = just_beyond(limit);
    c->party.lowered |= bit_of(i);
}

/* ---- nearest ---- */

static pov_hits *nearest_hits(company *c, uint32_t i)
{
    if (!(c->asked & bit_of(i))) {
        c->asked |= bit_of(i);
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

/* One that can be left out by now need not wait any more; if it cannot, it is asked before the next one waits. */
static void put_off(company *c, uint32_t i, const run *r, uint32_t lane)
{
    const pov_block_answer *answer = &c->answers[i];
    pending *p = &c->pending[i];

    if (answer->hi[lane] < c->party.limit[i])
        lower(c, i, answer->hi[lane]);
    if ((c->waiting & bit_of(i)) && !is_beyond(p->lo, c->party.limit[i]))
        ask_nearest(c, i, p->run, p->lane);
    p->run = r;
    p->lane = lane;
    p->lo = answer->lo[lane];
    c->waiting |= bit_of(i);
}

static void take_nearest(company *c, uint32_t i, const run *r)
{
    const pov_block_answer *answer = &c->answers[i];
    const pov_ray *ray = c->rays[i];
    uint32_t mask = answer->maybe & run_lanes(r) & ~left_behind(r, ray);

    for (; mask; mask &= mask - 1) {
        const uint32_t lane = first_of(mask);

        if (is_beyond(answer->lo[lane], c->party.limit[i]))
            continue;
        /* The filter knows nothing of the root that a ray leaves. */
        if ((answer->surely >> lane & 1) && r->object[lane] != ray->left)
            put_off(c, i, r, lane);
        else
            ask_nearest(c, i, r, lane);
    }
}

static uint64_t meet_nearest(bvh_party *party, const void *leaf, uint64_t lanes)
{
    company *c = (company *)(void *)party;
    const run *r;
    uint64_t met;
    uint32_t lane;

    for (r = leaf; r; r = run_next(r)) {
        if (r->flags & RUN_PACKED) {
            for (met = filter(c, r, lanes); met; met &= met - 1)
                take_nearest(c, first_of64(met), r);
            continue;
        }
        for (met = lanes; met; met &= met - 1)
            for (lane = 0; lane < r->count; lane++)
                ask_nearest(c, first_of64(met), r, lane);
    }
    return 0;
}

static bool nearest_alone(bvh_party *party, uint32_t lane, uint32_t frame, uint32_t at)
{
    company *c = (company *)(void *)party;
    query q;

    q.walk.tree = party->tree;
    q.walk.ray = c->rays[lane];
    q.walk.frame = frame;
    q.walk.at = at;
    q.walk.limit = party->limit[lane];
    q.hits = *nearest_hits(c, lane);
    query_go_on_nearest(&q, c->world);
    c->hits[lane] = q.hits;
    if (q.walk.limit < party->limit[lane])
        lower(c, lane, q.walk.limit);
    return false;
}

/* Pairs of one class that may be asked together. */
typedef struct pairs {
    uint32_t count;
    const void *selves[WORLD_MANY];
    const pov_ray *rays[WORLD_MANY];
    pov_hits *hits[WORLD_MANY];
} pairs;

/* Take those of `left` that are of a class; the others are left. */
static uint64_t take_class(company *c, const pov_shape_class *shape, uint64_t left, pairs *out)
{
    uint64_t rest, others = 0;

    out->count = 0;
    for (rest = left; rest; rest &= rest - 1) {
        const uint32_t i = first_of64(rest);
        const pending *p = &c->pending[i];
        const uint32_t n = out->count;

        if (p->run->shape != shape) {
            others |= bit_of(i);
            continue;
        }
        out->selves[n] = run_instance(p->run, p->lane);
        out->rays[n] = c->rays[i];
        out->hits[n] = nearest_hits(c, i);
        out->hits[n]->owner = p->run->object[p->lane];
        out->count++;
    }
    return others;
}

/* Ask those that wait and can still be the nearest. What waits stood in a block, and so has no placement. */
static void settle(company *c)
{
    uint64_t left = 0, rest;
    pairs some;
    uint32_t i;

    for (rest = c->waiting; rest; rest &= rest - 1) {
        i = first_of64(rest);
        if (!is_beyond(c->pending[i].lo, c->party.limit[i]))
            left |= bit_of(i);
    }
    while (left) {
        const pov_shape_class *shape = c->pending[first_of64(left)].run->shape;

        left = take_class(c, shape, left, &some);
        if (POV_SHAPE_HAS(shape, intersect_many))
            shape->intersect_many(some.selves, some.rays, some.hits, some.count);
        else
            for (i = 0; i < some.count; i++)
                shape->intersect(some.selves[i], some.rays[i], some.hits[i]);
    }
}

/* What was met, as bits of the caller's. */
static uint64_t end_nearest(company *c)
{
    uint64_t met = 0, rest;

    for (rest = c->party.lanes; rest; rest &= rest - 1) {
        const uint32_t i = first_of64(rest);
        const pov_hits *hits = &c->hits[i];
        hit *out = &c->out[c->of[i]];

        out->object = POV_NOBODY;
        out->company = 0;
        if (!(c->asked & bit_of(i)))
            continue;
        c->walker->decided += hits->decided;
        if (hits->count == 0)
            continue;
        out->object = out->crossing.owner;
        met |= bit_of(c->of[i]);
        if (hits->crowded)
            spot_choose(c->world, c->walker, c->rays[i], NULL, out);
    }
    return met;
}

static uint64_t nearest_together(const world *w, walker *k, const pov_ray *const *rays, uint64_t which, double tmax,
                                 hit *out)
{
    uint64_t met = 0, alone;
    company c;

    begin(&c, w, k, tmax);
    c.out = out;
    c.party.leaf = meet_nearest;
    c.party.alone = nearest_alone;
    alone = take_rays(&c, rays, which);
    c.party.lanes = all_of(c.party.count) & ~alone;
    for (; alone; alone &= alone - 1) {
        const uint32_t i = c.of[first_of64(alone)];
        met |= (uint64_t)world_nearest(w, k, rays[i], tmax, &out[i]) << i;
    }
    if (!c.party.lanes)
        return met;
    if (w->infinite)
        meet_nearest(&c.party, w->infinite, c.party.lanes);
    if (w->list)
        meet_nearest(&c.party, w->list, c.party.lanes);
    c.party.lowered = 0;
    if (w->has_tree)
        w->walks->nearest_together(&c.party);
    settle(&c);
    return met | end_nearest(&c);
}

/* ---- light ---- */

static void begin_light(company *c, uint32_t i)
{
    tint_room *room = &c->walker->rooms[c->of[i]];

    if (c->asked & bit_of(i))
        return;
    c->asked |= bit_of(i);
    begin_hits(&c->hits[i], c->world, c->tmax, POV_WANT_ANY, &room->blocking);
    if (!c->any_blocks)
        begin_tints(&c->tints[i], &c->hits[i], room);
}

/* True: the path ends here. */
static bool ask_light(company *c, uint32_t i, const run *r, uint32_t lane)
{
    const bool blocks = c->any_blocks || (r->opaque >> lane & 1);
    pov_hits *hits = blocks ? &c->hits[i] : &c->tints[i];

    begin_light(c, i);
    hits->owner = r->object[lane];
    run_intersect(r, lane, c->rays[i], hits);
    return blocks && hits->count > 0;
}

static bool ask_lights(company *c, uint32_t i, const run *r, uint32_t mask)
{
    for (; mask; mask &= mask - 1)
        if (ask_light(c, i, r, first_of(mask)))
            return true;
    return false;
}

static bool take_light(company *c, uint32_t i, const run *r)
{
    const pov_block_answer *answer = &c->answers[i];
    const pov_ray *ray = c->rays[i];
    uint32_t mask = answer->surely & (c->any_blocks ? r->casts : r->casts & r->opaque);

    for (; mask; mask &= mask - 1)
        if (r->object[first_of(mask)] != ray->left && answer->hi[first_of(mask)] < c->tmax)
            return true;
    return ask_lights(c, i, r, answer->maybe & r->casts & ~left_behind(r, ray));
}

static uint64_t meet_light(bvh_party *party, const void *leaf, uint64_t lanes)
{
    company *c = (company *)(void *)party;
    uint64_t ended = 0, met;
    const run *r;

    for (r = leaf; r && lanes; r = run_next(r)) {
        const bool packed = r->flags & RUN_PACKED;

        if (r->casts == 0)
            continue;
        for (met = packed ? filter(c, r, lanes) : lanes; met; met &= met - 1) {
            const uint32_t i = first_of64(met);
            if (packed ? take_light(c, i, r) : ask_lights(c, i, r, r->casts))
                ended |= bit_of(i);
        }
        lanes &= ~ended;
    }
    return ended;
}

static bool light_alone(bvh_party *party, uint32_t lane, uint32_t frame, uint32_t at)
{
    company *c = (company *)(void *)party;
    query q;
    bool ended;

    begin_light(c, lane);
    q.walk.tree = party->tree;
    q.walk.ray = c->rays[lane];
    q.walk.frame = frame;
    q.walk.at = at;
    q.walk.limit = c->tmax;
    q.any_blocks = c->any_blocks;
    q.hits = c->hits[lane];
    q.tints = c->tints[lane];
    ended = query_go_on_light(&q, c->world);
    c->hits[lane] = q.hits;
    c->tints[lane] = q.tints;
    return ended;
}

/* What is lit, as bits of the caller's. */
static uint64_t end_lights(company *c, uint64_t ended, colour *through)
{
    uint64_t lit = 0, rest;

    for (rest = c->party.lanes; rest; rest &= rest - 1) {
        const uint32_t i = first_of64(rest);
        const bool asked = c->asked & bit_of(i);
        pov_hits *tints = asked && !c->any_blocks ? &c->tints[i] : NULL;

        if (asked)
            c->walker->decided += c->hits[i].decided + (tints ? tints->decided : 0);
        lit |= (uint64_t)end_light(c->world, ended >> i & 1, tints, &through[c->of[i]]) << c->of[i];
    }
    return lit;
}

static uint64_t light_together(const world *w, walker *k, const pov_ray *const *rays, uint64_t which, double tmax,
                               colour *through)
{
    uint64_t lit = 0, ended = 0, all, alone;
    company c;

    begin(&c, w, k, tmax);
    c.any_blocks = !w->plan.coloured_shadows;
    c.party.leaf = meet_light;
    c.party.alone = light_alone;
    alone = take_rays(&c, rays, which);
    all = all_of(c.party.count) & ~alone;
    for (; alone; alone &= alone - 1) {
        const uint32_t i = c.of[first_of64(alone)];
        lit |= (uint64_t)world_light_path(w, k, rays[i], tmax, &through[i]) << i;
    }
    if (w->infinite && all)
        ended |= meet_light(&c.party, w->infinite, all);
    if (w->list && all & ~ended)
        ended |= meet_light(&c.party, w->list, all & ~ended);
    c.party.lanes = all & ~ended;
    if (w->has_tree && c.party.lanes)
        ended |= w->walks->any_together(&c.party);
    c.party.lanes = all;
    return lit | end_lights(&c, ended, through);
}

/* ---- companies ---- */

/* Those of one octant go together through a tree; a list takes all. */
static void divide(const world *w, const pov_ray *const *rays, uint32_t n, uint64_t of[8])
{
    uint32_t i;

    for (i = 0; i < 8; i++)
        of[i] = 0;
    if (!w->has_tree)
        of[0] = all_of(n);
    else
        for (i = 0; i < n; i++)
            of[bvh_octant(rays[i])] |= bit_of(i);
}

static inline bool is_company(uint64_t lanes)
{
    uint32_t n;

    for (n = 0; lanes && n < COMPANY_LEAST; lanes &= lanes - 1)
        n++;
    return n == COMPANY_LEAST;
}

uint64_t world_nearest_many(const world *w, walker *k, const pov_ray *const *rays, uint32_t n, double tmax, hit *out)
{
    uint64_t of[8], met = 0;
    uint32_t octant;

    if (n == 0)
        return 0;
    divide(w, rays, n, of);
    for (octant = 0; octant < 8; octant++)
        if (is_company(of[octant]))
            met |= nearest_together(w, k, rays, of[octant], tmax, out);
        else
            for (; of[octant]; of[octant] &= of[octant] - 1) {
                const uint32_t i = first_of64(of[octant]);
                met |= (uint64_t)world_nearest(w, k, rays[i], tmax, &out[i]) << i;
            }
    return met;
}

uint64_t world_light_path_many(const world *w, walker *k, const pov_ray *const *rays, uint32_t n, double tmax,
                               colour *through)
{
    uint64_t of[8], lit = 0;
    uint32_t octant;

    if (n == 0)
        return 0;
    divide(w, rays, n, of);
    for (octant = 0; octant < 8; octant++)
        if (is_company(of[octant]))
            lit |= light_together(w, k, rays, of[octant], tmax, through);
        else
            for (; of[octant]; of[octant] &= of[octant] - 1) {
                const uint32_t i = first_of64(of[octant]);
                lit |= (uint64_t)world_light_path(w, k, rays[i], tmax, &through[i]) << i;
            }
    return lit;
}
