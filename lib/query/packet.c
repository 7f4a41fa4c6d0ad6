#include "query/packet.h"

#include "base/simd.h"
#include "bvh/packet.h"

#include <string.h>

/* Lanes are gone through by eights. */
static inline uint32_t width(uint32_t n) { return (n + 7) & ~7u; }

/* True: all are in the range that filters are promised. */
SIMD_CLONES static bool derive(pov_rays *restrict s, uint32_t n, double end, double *restrict length)
{
    int64_t all = -1;

    for (uint32_t i = 0; i < n; i++)
        all &= side_derive(s, i, end, length);
    return all != 0;
}

/* Those that are out of that range. */
static uint64_t derive_all(company *c, double end)
{
    const uint32_t n = c->party.count;
    uint64_t alone = 0;

    if (!derive(&c->party.side, width(n), end, c->party.length))
        for (uint32_t i = 0; i < n; i++)
            alone |= side_derive(&c->party.side, i, end, c->party.length) ? 0 : bit_of(i);
    return alone;
}

static uint64_t take_rays(company *c, const pov_ray *const *rays, uint64_t which, double end)
{
    uint32_t n = 0, i;

    if ((which & (which + 1)) == 0) {
        n = ~which ? first_of64(~which) : WORLD_MANY;
        memcpy(c->rays, rays, n * sizeof *rays);
        for (i = 0; i < n; i++)
            c->of[i] = (uint8_t)i;
        which = 0;
    }
    for (; which; which &= which - 1, n++) {
        i = first_of64(which);
        c->rays[n] = rays[i];
        c->of[n] = (uint8_t)i;
    }
    c->party.count = n;
    for (i = n; i < width(n); i++)
        c->rays[i] = c->rays[n - 1];
    for (i = 0; i < width(n); i += 4)
        side_put_four(&c->party.side, i, c->rays + i);
    for (i = 0; i < width(n); i++)
        c->party.limit[i] = c->tmax;
    return derive_all(c, end);
}

static void begin(company *c, const world *w, walker *k, double tmax)
{
    c->party.tree = &w->tree;
    c->party.in = NULL;
    c->party.rays = c->rays;
    c->party.lowered = 0;
    c->world = w;
    c->walker = k;
    c->tmax = tmax;
    c->asked = c->waiting = 0;
    c->party.written = NULL;
}

uint64_t company_begin(company *c, const world *w, walker *k, const pov_ray *const *rays, uint64_t which, double tmax,
                       double end)
{
    begin(c, w, k, tmax);
    return take_rays(c, rays, which, end);
}

static void fill(double *out, double x, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++)
        out[i] = x;
}

/* Lanes from n on hold the last ray. */
static void copy(double *out, const double *in, uint32_t n)
{
    memcpy(out, in, n * sizeof *out);
    fill(out + n, in[n - 1], width(n) - n);
}

uint64_t company_begin_fan(company *c, const world *w, walker *k, pov_ray *rays, const vec_lanes *ways, uint32_t n,
                           double tmax, double end)
{
    pov_rays *side = &c->party.side;
    uint32_t i;

    begin(c, w, k, tmax);
    c->party.written = rays;
    c->party.ways[0] = ways->x;
    c->party.ways[1] = ways->y;
    c->party.ways[2] = ways->z;
    c->party.count = n;
    for (i = 0; i < width(n); i++) {
        c->rays[i] = &rays[i < n ? i : n - 1];
        c->of[i] = (uint8_t)i;
        side->away[i] = POV_NOBODY;
    }
    fill(side->org[0], rays->org.x, width(n));
    fill(side->org[1], rays->org.y, width(n));
    fill(side->org[2], rays->org.z, width(n));
    fill(side->org_lo[0], rays->org_lo.x, width(n));
    fill(side->org_lo[1], rays->org_lo.y, width(n));
    fill(side->org_lo[2], rays->org_lo.z, width(n));
    copy(side->dir[0], ways->x, n);
    copy(side->dir[1], ways->y, n);
    copy(side->dir[2], ways->z, n);
    fill(c->party.limit, tmax, width(n));
    return derive_all(c, end);
}

uint64_t company_stand_in_list(company *c, uint64_t lanes)
{
    const pov_rays *side = &c->party.side;
    uint64_t in = 0;
    bvh_local l;

    if (!c->world->list_packed)
        return lanes;
    c->party.in = &c->world->list_frame;
    for (; lanes; lanes &= lanes - 1) {
        const uint32_t i = first_of64(lanes);

        if (!bvh_enter(&c->world->list_frame, c->rays[i], c->party.length[i], side->per_length[i], &l))
            continue;
        bvh_stand(&c->party.side, i, &l, bvh_limit(l.scale, l.shift, c->party.limit[i]));
        in |= bit_of(i);
    }
    return in;
}

/* ---- who goes with whom ---- */

/* Fewer rays of one octant are better off alone, and fewer of any one after the other. */
enum { COMPANY_LEAST = 8, TURNS_LEAST = 5 };

static bool are_of_one(const pov_ray *const *rays, uint32_t n, uint32_t *octant)
{
    uint32_t any = 0, every = 7, i;

    for (i = 0; i < n; i++) {
        any |= bvh_octant(rays[i]);
        every &= bvh_octant(rays[i]);
    }
    *octant = any;
    return any == every;
}

/* Those of one octant go together through a tree; a list takes all. */
static void divide(const world *w, const pov_ray *const *rays, uint32_t n, uint64_t of[8])
{
    uint32_t octant = 0, i;

    for (i = 0; i < 8; i++)
        of[i] = 0;
    if (!w->has_tree || are_of_one(rays, n, &octant))
        of[octant] = all_of(n);
    else
        for (i = 0; i < n; i++)
            of[bvh_octant(rays[i])] |= bit_of(i);
}

/* Are there so many? */
static inline bool are_at_least(uint64_t lanes, uint32_t least)
{
    uint32_t n;

    for (n = 1; n < least; n++)
        lanes &= lanes - 1;
    return lanes != 0;
}

/* Should those that have no company go by turns? */
static inline bool take_turns(const world *w, uint64_t lanes)
{
    return are_at_least(lanes, TURNS_LEAST) && w->has_tree && w->tree.frame_count == 1 && w->walks->nearest_by_turns;
}

uint64_t world_nearest_many(const world *w, walker *k, const pov_ray *const *rays, uint32_t n, double tmax, hit *out)
{
    uint64_t of[8], met, apart = 0;
    uint32_t octant;
    exits e;

    if (n == 0)
        return 0;
    own_begin(&k->own, out);
    company_find_exits(w, k, rays, n, tmax, out, &e);
    met = e.met;
    divide(w, rays, n, of);
    for (octant = 0; octant < 8; octant++) {
        const uint64_t lanes = of[octant] & ~e.met;

        if (are_at_least(lanes, COMPANY_LEAST))
            met |= company_nearest(w, k, rays, lanes, tmax, &e, w->walks->nearest_together, out);
        else
            apart |= lanes;
    }
    if (take_turns(w, apart))
        return met | company_nearest(w, k, rays, apart, tmax, &e, w->walks->nearest_by_turns, out);
    return apart ? met | company_nearest_apart(w, k, rays, apart, tmax, &e, out) : met;
}

/* 1: the sign is set in all; 0: in none; -1: some. */
static int common_sign(const double *x, uint32_t n)
{
    int64_t any = 0, every = -1;

    for (uint32_t i = 0; i < n; i++) {
        int64_t bits;

        memcpy(&bits, &x[i], sizeof bits);
        any |= bits;
        every &= bits;
    }
    return every < 0 ? 1 : any < 0 ? -1 : 0;
}

static bool is_of_one(const vec_lanes *ways, uint32_t n)
{
    return common_sign(ways->x, n) >= 0 && common_sign(ways->y, n) >= 0 && common_sign(ways->z, n) >= 0;
}

uint64_t world_nearest_fan(const world *w, walker *k, pov_ray *rays, const vec_lanes *ways, uint32_t n, double tmax,
                           hit *out)
{
    const pov_ray *each[WORLD_MANY];
    uint32_t i;

    if (w->has_tree && n >= COMPANY_LEAST && is_of_one(ways, n)) {
        own_begin(&k->own, out);
        return company_nearest_fan(w, k, rays, ways, n, tmax, out);
    }
    for (i = 0; i < n; i++) {
        rays[i].dir = lanes_at(ways, i);
        each[i] = &rays[i];
    }
    return world_nearest_many(w, k, each, n, tmax, out);
}

uint64_t world_light_path_many(const world *w, walker *k, const pov_ray *const *rays, uint32_t n, double tmax,
                               colour *through)
{
    uint64_t of[8], lit = 0, apart = 0;
    uint32_t octant;

    if (n == 0)
        return 0;
    for (uint32_t i = 0; i < n; i++)
        through[i] = colour_of(1.0f, 1.0f, 1.0f);
    divide(w, rays, n, of);
    for (octant = 0; octant < 8; octant++)
        if (are_at_least(of[octant], COMPANY_LEAST))
            lit |= company_light(w, k, rays, of[octant], tmax, w->walks->any_together, through);
        else
            apart |= of[octant];
    if (take_turns(w, apart))
        return lit | company_light(w, k, rays, apart, tmax, w->walks->any_by_turns, through);
    for (; apart; apart &= apart - 1) {
        const uint32_t i = first_of64(apart);
        lit |= (uint64_t)world_light_path(w, k, rays[i], tmax, &through[i]) << i;
    }
    return lit;
}
