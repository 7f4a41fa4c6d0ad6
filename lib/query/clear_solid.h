/* clear_solid.h - shortcuts for transparent closed convex solids, for those that are plain: a ray that goes into one comes
 * out of it just once, and its light is filtered by the same colour twice. */
#ifndef QUERY_CLEAR_SOLID_H
#define QUERY_CLEAR_SOLID_H

#include "query/context.h"

/* Where rays that go into a closed solid come out of it, as bits and places of the caller's: all of them are asked
 * together, before anything else, and end there at the latest. `met`: those that end there, for nothing else is near. */
typedef struct exits { uint64_t known, met; pov_hits hits[WORLD_MANY]; } exits;
void clear_solid_exits(const world *w, walker *k, const pov_ray *const *rays, uint32_t n, double tmax, hit *out,
                       exits *e);

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
static inline bool clear_solid_passes(const run *r, const pov_meeting *m, const pov_ray *ray, pov_hits *hits)
{
    if (!m->twice || !(r->plain & ~r->opaque & 1u << m->lane) || r->object[m->lane] == ray->left)
        return false;
    if (clear_solid_note(hits, r->object[m->lane]))
        clear_solid_note(hits, r->object[m->lane]);
    return true;
}

#endif
