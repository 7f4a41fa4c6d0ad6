/* context.h - one thread's memory for queries, and operations that all queries share. */
#ifndef QUERY_CONTEXT_H
#define QUERY_CONTEXT_H

#include "query/query.h"
#include "world/internal.h"

/* Buffer for the crossings of one light path: with transparent shapes, and with an opaque one. */
typedef struct hit_buffer { csg_user csg; query_context *context; pov_crossing *crossings; uint32_t capacity; pov_crossing blocking; } hit_buffer;

/* The surfaces that a ray of the last query_nearest() hits in one place. */
typedef struct resolved_set { const pov_ray *ray; coincident_set on; } resolved_set;

struct query_context {
    object_space_rays own;
    const env *env;
    hit_buffer hit_buffers[WORLD_MANY];
    uint64_t escalated;
    class_counts classes;
    csg_scratch csg;
    void *scratch;               /* working memory of shapes; NULL: none needs it */
    struct { resolved_set *items; size_t count, capacity; } resolved;
    pov_hits fresh;              /* hits as they begin, but for what differs from query to query */
    bool failed;
};

/* Count intersections of a leaf batch's class, and those that escalated: once for a batch where possible, because a
 * fast intersection takes hardly longer than counting. */
static inline void query_context_count_class(query_context *k, uint32_t number, uint32_t asked, uint32_t escalated)
{
    k->classes.of[number].asked += asked;
    if (escalated)
        k->classes.of[number].escalated += escalated;
}

static inline void query_context_count(query_context *k, const leaf_batch *r, uint32_t asked, uint32_t escalated)
{
    query_context_count_class(k, leaf_batch_class(r), asked, escalated);
}

/* Copied from what has been made once, which takes fewer instructions than member by member. hits->user is the buffer: trees
 * of shapes find their memory there. */
static inline void hits_begin(pov_hits *hits, hit_buffer *buffer, double tmax, pov_want want, pov_crossing *at)
{
    simd_copy(hits, &buffer->context->fresh, sizeof *hits);
    hits->tmax = tmax;
    hits->want = want;
    hits->at = at;
    hits->user = buffer;
}

/* More memory for a query that wants all crossings. */
bool crossings_grow(pov_hits *hits);
void crossings_sort(pov_crossing *at, uint32_t count, bool (*is_before)(const pov_crossing *a, const pov_crossing *b));
/* The crossing in out may have coincident surfaces: compare in double-double, and store the one that counts. Of a ray that starts on no set
 * the context remembers them until the next query_nearest(). */
void coincidence_resolve(const world *w, query_context *k, const pov_ray *ray, const coincident_set *from, hit *out);

#endif
