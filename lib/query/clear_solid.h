/* clear_solid.h - shortcuts for transparent closed convex solids, for those that are plain: a ray that goes into one comes
 * out of it just once, and its light is filtered by the same colour twice. */
#ifndef QUERY_CLEAR_SOLID_H
#define QUERY_CLEAR_SOLID_H

#include "query/context.h"

/* Where rays that go into a closed solid come out of it, as bits and places of the caller's: all of them are asked
 * together, before anything else, and end there at the latest. `found`: those that end there, for nothing else is
 * near. */
typedef struct exit_hits { uint64_t known, found; pov_hits hits[WORLD_MANY]; } exit_hits;
void clear_solid_exits(const world *w, query_context *k, const pov_ray *const *rays, uint32_t n, double tmax, hit *out,
                       exit_hits *e);

/* May any of these rays go into the closed solid that it starts on? */
bool clear_solid_any_enters(const pov_ray *const *rays, uint32_t n);
/* Light that starts on a closed solid and goes into it: does it pass, and come out for certain before its way ends? */
bool clear_solid_light_exits(const world *w, const pov_ray *ray, double tmax);

/* A hit of a transparent solid that is certain; nobody looks where. */
static inline bool clear_solid_note(pov_hits *hits, uint32_t owner)
{
    const pov_mark mark = { 0, 0, 0.0, 0.0 };

    hits->owner = owner;
    return pov_cross(hits, hits->tmax < 1.0 ? 0.5 * hits->tmax : 0.5, 0.0, mark);
}

/* Those that light certainly enters and leaves on its way are noted as hit twice, and are not asked. */
static inline bool clear_solid_passes(const leaf_batch *r, const pov_candidate *m, const pov_ray *ray, pov_hits *hits)
{
    if (!m->definite_pair || !(r->plain & ~r->opaque & 1u << m->lane) || r->object[m->lane] == ray->origin_surface)
        return false;
    if (clear_solid_note(hits, r->object[m->lane]))
        clear_solid_note(hits, r->object[m->lane]);
    return true;
}

#endif
