/* clear_solid.h - shortcuts for plain transparent closed convex solids: a ray that enters one leaves it just once, and
 * its light is filtered by the same colour twice. */
#ifndef QUERY_CLEAR_SOLID_H
#define QUERY_CLEAR_SOLID_H

#include "query/context.h"

/* Exit hits of rays that enter a closed solid, as bits and indices of the caller's rays. They are found for all rays
 * together before traversal, and bound the rays. `found`: rays that end there, because nothing else is near; of the others the
 * hits are there. sure: those whose points and normals are known where anything is lit. */
typedef struct exit_hits { uint64_t known, found, sure; pov_hits hits[WORLD_MANY]; } exit_hits;
void clear_solid_exits(const world *w, query_context *k, const pov_ray *const *rays, uint32_t n, double tmax, hit *out,
                       exit_hits *e);

/* May any of these rays enter the closed solid that it starts on? */
bool clear_solid_any_enters(const pov_ray *const *rays, uint32_t n);
/* Light that starts on a closed solid and enters it: does it pass, and definitely leave it before its path ends? */
bool clear_solid_light_exits(const world *w, const pov_ray *ray, double tmax);

/* Light that starts on a closed solid and enters it, clear or not: does its path end inside? Then it does not cross the solid again. */
bool clear_solid_light_stays(const world *w, const pov_ray *ray, double tmax);

/* Note a definite hit of a transparent solid, whose distance nobody asks for. */
static inline bool clear_solid_note(pov_hits *hits, uint32_t owner)
{
    const pov_crossing at = { 0.0, 0.0, owner, { 0, 0, 0.0, 0.0 } };

    if (hits->count == hits->capacity && !hits->grow(hits))
        return false;
    hits->at[hits->count++] = at;
    return true;
}

/* Note two hits of a solid that light definitely enters and leaves, without intersecting it. */
static inline bool clear_solid_passes(const leaf_batch *r, const pov_candidate *m, const pov_ray *ray, pov_hits *hits)
{
    if (!m->definite_pair || !(r->plain & ~r->opaque & 1u << m->lane) || r->object[m->lane] == ray->origin_surface)
        return false;
    if (clear_solid_note(hits, r->object[m->lane]))
        clear_solid_note(hits, r->object[m->lane]);
    return true;
}

#endif
