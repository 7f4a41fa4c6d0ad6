/* single.h - a query under way, for single rays and many. */
#ifndef QUERY_SINGLE_H
#define QUERY_SINGLE_H

#include "base/bits.h"
#include "query/context.h"
#include "query/ray_soa.h"

/* A lane that is surely crossed, before or at the limit; which crossing is nearest of all is settled later. */
typedef struct pending { const run *run; uint32_t lane; double lo; } pending;

enum { PENDING_MAX = 8 };

typedef struct query {
    bvh_walk walk;               /* first: leaves are handed this */
    walker *walker;
    pov_hits hits;
    uint32_t waiting;
    bool any_blocks;             /* transparent or not */
    bool in_range;               /* of filters */
    pending pending[PENDING_MAX];
    pov_hits tints;              /* of transparent shapes on a light path */
    pov_rays rays;               /* the first lane is the ray */
} query;

/* A filter's interval is open, and a crossing at the limit may still win by its lower part or its owner. */
static inline double just_beyond(double limit)
{
    return limit + limit * 0x1p-52 + 0x1p-1074;
}

/* Whether something at lo or later can be left out: a reported distance may be off by some units in its last place. */
static inline bool is_beyond(double lo, double limit)
{
    return lo > limit + limit * 0x1p-46;
}

/* The convex shape that a ray went away from cannot be met, and the closed one that it went into has been asked where
 * it comes out. away: which it is. */
static inline bool is_settled(const run *r, uint32_t lane, const pov_ray *ray, uint32_t away)
{
    return r->object[lane] == away &&
           ((r->shape->flags & POV_SHAPE_CONVEX) || (ray->left_mark.flags & POV_MARK_CLOSED));
}

static inline uint32_t left_behind(const run *r, const pov_ray *ray, uint32_t away)
{
    uint32_t lane;

    for (lane = 0; away != POV_NOBODY && lane < r->count; lane++)
        if (is_settled(r, lane, ray, away))
            return 1u << lane;
    return 0;
}

/* May any of them go into what it starts on? */
static inline bool any_goes_in(const pov_ray *const *rays, uint32_t n)
{
    uint32_t flags = 0, i;

    for (i = 0; i < n; i++)
        flags |= rays[i]->left_mark.flags;
    return flags & POV_MARK_INTO;
}

/* Does a ray start on a closed shape and go into it? */
static inline bool goes_in(const pov_ray *ray)
{
    const uint32_t both = POV_MARK_INTO | POV_MARK_CLOSED;

    return (ray->left_mark.flags & both) == both;
}

/* Does it block light for certain? The filter knows nothing of the root that a ray leaves. */
static inline bool is_blocked(const run *r, const pov_meeting *m, uint32_t blocking, const pov_ray *ray)
{
    return m->surely && (blocking >> m->lane & 1) && r->object[m->lane] != ray->left;
}

static inline void begin_hits(pov_hits *hits, const world *w, double tmax, pov_want want, pov_crossing *at)
{
    hits->tmin = 0.0;
    hits->tmax = tmax;
    hits->want = want;
    hits->always_exact = w->always_exact;
    hits->count_only = false;
    hits->owner = POV_NOBODY;
    hits->count = 0;
    hits->capacity = 1;
    hits->decided = 0;
    hits->at = at;
    hits->grow = NULL;
    hits->user = NULL;
    hits->crowded = false;
}

/* A transparent shape that is surely crossed; nobody looks where. */
static inline bool note_tint(pov_hits *tints, uint32_t owner)
{
    const pov_mark mark = { 0, 0, 0.0, 0.0 };

    tints->owner = owner;
    return pov_cross(tints, tints->tmax < 1.0 ? 0.5 * tints->tmax : 0.5, 0.0, mark);
}

/* Those that light surely enters and leaves on its way are noted as crossed twice, and are not asked. */
static inline bool passes_through(const run *r, const pov_meeting *m, const pov_ray *ray, pov_hits *tints)
{
    if (!m->twice || (r->opaque >> m->lane & 1) || r->object[m->lane] == ray->left)
        return false;
    if (note_tint(tints, r->object[m->lane]))
        note_tint(tints, r->object[m->lane]);
    return true;
}

/* Light that starts on a closed shape and goes into it: does it pass, and come out for certain before its way ends? */
bool light_comes_out(const world *w, const pov_ray *ray, double tmax);

/* The hits of the transparent shapes. (A copy of those that block would wait until these are stored.) */
void begin_tints(pov_hits *tints, const world *w, double tmax, tint_room *room);

/* blocked: something that blocks stands on the way; tints: what transparent shapes were crossed, or NULL. False: nothing
 * is left of the light. */
static inline bool end_light(const world *w, bool blocked, pov_hits *tints, colour *through)
{
    *through = colour_of(1.0f, 1.0f, 1.0f);
    if (!blocked && !(tints && tints->count > 0))
        return true;
    if (!blocked && tints->count == 1) {
        *through = crossing_filter(w, tints->at);   /* what white times that is */
        return !colour_is_black(*through);
    }
    if (!blocked && crossings_multiply(w, tints->at, tints->count, through))
        return true;
    *through = colour_of(0.0f, 0.0f, 0.0f);
    return false;
}

/* Who is nearest, but for what waits to be asked: of that all but one can be settled, and this is given, if there is
 * any. known: what has been asked already, where the ray comes out of what it goes into; or NULL. */
void query_nearest(query *q, const world *w, walker *k, const pov_ray *ray, double tmax, const pov_hits *known,
                   pov_crossing *at);
bool query_settle_but_one(query *q, pending *one);

/* Go on from the middle of a tree, with the walk and the hits of whoever has begun it, of a ray that blocks cannot be told
 * of; away: what is settled of it. True: the light ends. */
void query_go_on(query *q, const pov_ray *ray, uint32_t away, double length, double per_length);
void query_go_on_nearest(query *q, const world *w);
bool query_go_on_light(query *q, const world *w);

#endif
