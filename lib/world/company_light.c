#include "world/company.h"

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

    hits->owner = r->object[lane];
    run_intersect(r, lane, c->rays[i], hits);
    return blocks && hits->count > 0;
}

static inline uint32_t decided_of(const company *c, uint32_t i)
{
    return c->hits[i].decided + (c->any_blocks ? 0 : c->tints[i].decided);
}

static bool ask_lights(company *c, uint32_t i, const run *r, uint32_t mask)
{
    uint32_t asked = 0, before;
    bool ended = false;

    if (!mask)
        return false;
    begin_light(c, i);
    before = decided_of(c, i);
    for (; mask && !ended; mask &= mask - 1, asked++)
        ended = ask_light(c, i, r, first_of(mask));
    walker_count(c->walker, r, asked, decided_of(c, i) - before);
    return ended;
}

static bool take_light(company *c, uint32_t i, const run *r)
{
    const pov_block_answer *answer = &c->answers[i];
    const pov_ray *ray = c->rays[i];
    uint32_t mask = answer->surely & (c->any_blocks ? r->casts : r->casts & r->opaque);

    for (; mask; mask &= mask - 1)
        if (r->object[first_of(mask)] != ray->left && answer->hi[first_of(mask)] < c->tmax)
            return true;
    mask = answer->maybe & r->casts & ~left_behind(r, ray);
    if (mask && !c->any_blocks) {
        begin_light(c, i);
        mask = pass_through(r, answer, ray->left, mask, &c->tints[i]);
    }
    return ask_lights(c, i, r, mask);
}

static uint64_t filter_light(company *c, const run *r, uint64_t lanes)
{
    uint64_t rest;

    for (rest = c->any_blocks ? 0 : lanes; rest; rest &= rest - 1)
        c->answers[first_of64(rest)].twice = 0;
    return company_filter(c, r, lanes);
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
        for (met = packed ? filter_light(c, r, lanes) : lanes; met; met &= met - 1) {
            const uint32_t i = first_of64(met);
            if (packed ? take_light(c, i, r) : ask_lights(c, i, r, r->casts & ~left_behind(r, c->rays[i])))
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
    q.walker = c->walker;
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
            c->walker->decided += decided_of(c, i);
        lit |= (uint64_t)end_light(c->world, ended >> i & 1, tints, &through[c->of[i]]) << c->of[i];
    }
    return lit;
}

uint64_t company_light(const world *w, walker *k, const pov_ray *const *rays, uint64_t which, double tmax,
                       colour *through)
{
    uint64_t lit = 0, ended = 0, all, alone;
    company c;

    c.any_blocks = !w->plan.coloured_shadows;
    c.party.leaf = meet_light;
    c.party.alone = light_alone;
    alone = company_begin(&c, w, k, rays, which, tmax);
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
