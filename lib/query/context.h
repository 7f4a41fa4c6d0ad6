/* context.h - one thread's memory for queries, and what all queries do with it. */
#ifndef QUERY_CONTEXT_H
#define QUERY_CONTEXT_H

#include "query/query.h"
#include "world/parts.h"

/* For the crossings of one light path: with transparent shapes, and with one that blocks. */
typedef struct tint_room { csg_scratch *csg; walker *walker; pov_crossing *crossings; uint32_t capacity; pov_crossing blocking; } tint_room;

struct walker {
    own_rays own;
    const env *env;
    tint_room rooms[WORLD_MANY];
    uint64_t decided;
    class_counts classes;
    csg_scratch csg;
    void *scratch;               /* of shapes; NULL: none asks for it */
    bool failed;
};

/* Count questions to shapes of a run's class, and what was decided of them: once a run where that can be, for a shape's
 * quick answer takes hardly longer. */
static inline void walker_count_class(walker *k, uint32_t number, uint32_t asked, uint32_t decided)
{
    k->classes.of[number].asked += asked;
    if (decided)
        k->classes.of[number].decided += decided;
}

static inline void walker_count(walker *k, const run *r, uint32_t asked, uint32_t decided)
{
    walker_count_class(k, run_class(r), asked, decided);
}

/* hits->user is the room: trees of shapes look for their memory there. */
static inline void hits_begin(pov_hits *hits, const world *w, tint_room *room, double tmax, pov_want want,
                              pov_crossing *at)
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
    hits->user = room;
    hits->crowded = false;
    hits->scratch = room->walker->scratch;
}

/* For a query that wants all: more room. */
bool crossings_grow(pov_hits *hits);
void crossings_sort(pov_crossing *at, uint32_t count, bool (*is_before)(const pov_crossing *a, const pov_crossing *b));
/* The crossing in out has company as far as doubles tell: find out in two parts, and put the one there that counts. */
void spot_choose(const world *w, walker *k, const pov_ray *ray, const spot *from, hit *out);

#endif
