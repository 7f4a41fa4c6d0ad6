/* packet.h - queries of rays that go together: what they share, for those that ask what is nearest and those that ask
 * for light. */
#ifndef QUERY_PACKET_H
#define QUERY_PACKET_H

#include "base/bits.h"
#include "query/single.h"

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
    pov_hits hits[WORLD_MANY], tints[WORLD_MANY];
    pov_meeting met[POV_MEETINGS_MAX];
} company;

static inline uint64_t bit_of(uint32_t i) { return (uint64_t)1 << i; }
static inline uint64_t all_of(uint32_t n) { return ~(uint64_t)0 >> (WORLD_MANY - n); }

static inline void lower(company *c, uint32_t i, double limit)
{
    c->party.limit[i] = limit;
    c->party.side.tmax[i] = just_beyond(limit);
    c->party.lowered |= bit_of(i);
}

/* Take those of `which`; filters are to look up to `end`. Lanes that hold a ray out of range are told: they are to go
 * alone. */
uint64_t company_begin(company *c, const world *w, walker *k, const pov_ray *const *rays, uint64_t which, double tmax,
                       double end);
/* The same of all n rays of a fan. */
uint64_t company_begin_fan(company *c, const world *w, walker *k, pov_ray *rays, const vec_lanes *ways, uint32_t n,
                           double tmax, double end);
/* Those of some lanes that the world's list may be met by; its blocks are told of them. */
uint64_t company_stand_in_list(company *c, uint64_t lanes);

/* Where rays that go into a closed shape come out of it, as bits and places of the caller's: all of them are asked
 * together, before anything else, and end there at the latest. `met`: those that end there, for nothing else is near. */
typedef struct exits { uint64_t known, met; pov_hits hits[WORLD_MANY]; } exits;
void company_find_exits(const world *w, walker *k, const pov_ray *const *rays, uint32_t n, double tmax, hit *out,
                        exits *e);

/* Those of the caller's rays that `which` names; bits of the answers are the caller's. travel: how they go through the
 * tree. */
uint64_t company_nearest(const world *w, walker *k, const pov_ray *const *rays, uint64_t which, double tmax,
                         const exits *e, bvh_travel *travel, hit *out);
/* Of all n rays of a fan of one octant, in a tree. */
uint64_t company_nearest_fan(const world *w, walker *k, pov_ray *rays, const vec_lanes *ways, uint32_t n, double tmax,
                             hit *out);
/* The same of rays that go through the tree one by one; what is left to be asked at the end is asked together. */
uint64_t company_nearest_apart(const world *w, walker *k, const pov_ray *const *rays, uint64_t which, double tmax,
                               const exits *e, hit *out);
/* Where light comes through unchanged nothing is said of it. */
uint64_t company_light(const world *w, walker *k, const pov_ray *const *rays, uint64_t which, double tmax,
                       bvh_travel *travel, colour *through);

#endif
