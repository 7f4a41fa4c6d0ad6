#include "query/packet.h"

static void begin_light(company *c, uint32_t i)
{
    tint_room *room = &c->walker->rooms[c->of[i]];

    if (c->asked & bit_of(i))
        return;
    c->asked |= bit_of(i);
    begin_hits(&c->hits[i], c->world, c->tmax, POV_WANT_ANY, &room->blocking);
    if (!c->any_blocks)
        begin_tints(&c->tints[i], c->world, c->tmax, room);
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

/* One of a block's that nobody knows enough of. True: the path ends here. */
static bool take_light(company *c, const run *r, const pov_meeting *m)
{
    const pov_ray *ray = c->rays[m->ray];

    if (!(r->casts >> m->lane & 1) || is_settled(r, m->lane, ray, c->party.side.away[m->ray]))
        return false;
    if (!c->any_blocks) {
        begin_light(c, m->ray);
        if (passes_through(r, m, ray, &c->tints[m->ray]))
            return false;
    }
    return ask_lights(c, m->ray, r, 1u << m->lane);
}

static uint64_t filter_light(company *c, const run *r, uint64_t lanes)
{
    const uint32_t n = run_filter(r, c->party.in, &c->party.side, lanes, c->met);
    const uint32_t blocking = c->any_blocks ? r->casts : r->casts & r->opaque;
    uint64_t ended = 0;
    uint32_t i;

    for (i = 0; i < n; i++)
        ended |= (uint64_t)is_blocked(r, &c->met[i], blocking, c->rays[c->met[i].ray]) << c->met[i].ray;
    for (i = 0; i < n; i++)
        if (!(ended >> c->met[i].ray & 1))
            ended |= (uint64_t)take_light(c, r, &c->met[i]) << c->met[i].ray;
    return ended;
}

static uint64_t meet_light(bvh_party *party, const void *leaf, uint64_t lanes)
{
    company *c = (company *)(void *)party;
    uint64_t ended = 0, rest;
    const run *r;

    for (r = leaf; r && lanes; r = run_next(r)) {
        if (r->casts == 0)
            continue;
        if (r->flags & RUN_PACKED) {
            ended |= filter_light(c, r, lanes);
        } else {
            for (rest = lanes; rest; rest &= rest - 1) {
                const uint32_t i = first_of64(rest);
                if (ask_lights(c, i, r, r->casts & ~left_behind(r, c->rays[i], party->side.away[i])))
                    ended |= bit_of(i);
            }
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
    q.walk.frame = frame;
    q.walk.at = at;
    q.walk.limit = c->tmax;
    q.any_blocks = c->any_blocks;
    q.hits = c->hits[lane];
    q.tints = c->tints[lane];
    query_go_on(&q, c->rays[lane], party->side.away[lane], party->length[lane], party->side.per_length[lane]);
    ended = query_go_on_light(&q, c->world);
    c->hits[lane] = q.hits;
    c->tints[lane] = q.tints;
    return ended;
}

/* Note what light comes out of before it meets anything else. */
static void leave_tints(company *c)
{
    uint32_t i;

    for (i = 0; i < c->party.count; i++)
        if (goes_in(c->rays[i]) && light_comes_out(c->world, c->rays[i], c->tmax)) {
            begin_light(c, i);
            note_tint(&c->tints[i], c->rays[i]->left);
            c->party.side.away[i] = c->rays[i]->left;
        }
}

/* What is not lit, as bits of the caller's: of lanes that nobody was asked for nothing is to be said but that. */
static uint64_t end_lights(company *c, uint64_t ended, colour *through)
{
    uint64_t dark = 0, rest;

    for (rest = c->party.lanes & (c->asked | ended); rest; rest &= rest - 1) {
        const uint32_t i = first_of64(rest);
        const bool asked = c->asked & bit_of(i);
        pov_hits *tints = asked && !c->any_blocks ? &c->tints[i] : NULL;

        if (asked)
            c->walker->decided += decided_of(c, i);
        dark |= (uint64_t)!end_light(c->world, ended >> i & 1, tints, &through[c->of[i]]) << c->of[i];
    }
    return dark;
}

uint64_t company_light(const world *w, walker *k, const pov_ray *const *rays, uint64_t which, double tmax,
                       bvh_travel *travel, colour *through)
{
    uint64_t dark = 0, ended = 0, all, alone;
    company c;

    c.any_blocks = !w->plan.coloured_shadows;
    c.party.leaf = meet_light;
    c.party.alone = light_alone;
    alone = company_begin(&c, w, k, rays, which, tmax, tmax);
    all = all_of(c.party.count) & ~alone;
    if (!c.any_blocks && any_goes_in(c.rays, c.party.count))
        leave_tints(&c);
    for (; alone; alone &= alone - 1) {
        const uint32_t i = c.of[first_of64(alone)];
        dark |= (uint64_t)!world_light_path(w, k, rays[i], tmax, &through[i]) << i;
    }
    if (w->infinite && all)
        ended |= meet_light(&c.party, w->infinite, all);
    if (w->list && all & ~ended)
        ended |= meet_light(&c.party, w->list, company_stand_in_list(&c, all & ~ended));
    c.party.lanes = all & ~ended;
    if (w->has_tree && c.party.lanes)
        ended |= travel(&c.party);
    c.party.lanes = all;
    return which & ~(dark | end_lights(&c, ended, through));
}
