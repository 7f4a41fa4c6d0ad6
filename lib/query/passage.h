/* passage.h - straight on through everything, surface by surface. */
#ifndef QUERY_PASSAGE_H
#define QUERY_PASSAGE_H

#include "query/query.h"

/* More surfaces in one place than are told apart can hand a ray back and forth there. After this many crossings without a
 * move it is given up. */
enum { PASSAGE_ZERO_STEPS_MAX = 1000 };

/* What a ray meets next: one of the surfaces `from` that it starts on, which it crosses at once, or else what comes next;
 * NULL: it starts on none. on: the surfaces that lie there, if there are several, else its count is 0. False: nothing. The
 * hit's point and normal are only known where there are several. */
bool passage_step(const world *w, query_context *k, const pov_ray *ray, const coincident_set *from, hit *h,
                  coincident_set *on);
/* Which of the surfaces is the object's. */
uint32_t passage_which(const coincident_set *on, uint32_t object);
/* How many crossings in a row did not move the ray. */
static inline int passage_zero_steps(int before, pov_vec3 from, pov_vec3 to)
{
    return from.x == to.x && from.y == to.y && from.z == to.z ? before + 1 : 0;
}

/* A ray under way, and the surfaces that it stands on, if there are several. */
typedef struct passage {
    const world *world;
    query_context *context;
    pov_ray ray;
    coincident_set on;
    int zero_steps;
} passage;

/* The next surface, complete; the ray starts there then. False: there is none, or memory ended. */
bool passage_next(passage *p, hit *h);

#endif
