/* passage.h - straight on through all surfaces, one by one. */
#ifndef QUERY_PASSAGE_H
#define QUERY_PASSAGE_H

#include "query/query.h"

/* More coincident surfaces than COINCIDENT_MAX can send a ray back and forth, and so can a shape that reports where the
 * ray starts. After this many steps that lead nowhere it is given up. */
enum { PASSAGE_ZERO_STEPS_MAX = 1000 };

/* The next hit of a ray: one of the coincident surfaces `from` that it starts on, which it crosses at once, or else the
 * next one; NULL: it starts on none. on: the coincident surfaces of the hit, if there are several, else its count is 0.
 * False: no hit. The hit's point and normal are known only if there are several. */
bool passage_step(const world *w, query_context *k, const pov_ray *ray, const coincident_set *from, hit *h,
                  coincident_set *on);
/* Index of the object's surface. */
uint32_t passage_which(const coincident_set *on, uint32_t object);
static inline bool passage_stays(pov_vec3 from, pov_vec3 to)
{
    return from.x == to.x && from.y == to.y && from.z == to.z;
}

/* Number of consecutive steps that lead nowhere: of length zero, or of so little of the world that no shape within the
 * promised range has two crossings so near. Only next to the origin of coordinates can a ray go such a step. */
int passage_zero_steps(const world *w, int before, pov_vec3 from, pov_vec3 to);

/* State of a ray, and the coincident surfaces that it starts on, if there are several. */
typedef struct passage {
    const world *world;
    query_context *context;
    pov_ray ray;
    coincident_set on;
    int zero_steps;
} passage;

/* Advance to the next hit, and complete it; the ray starts there then. False: no hit, or memory ended. */
bool passage_next(passage *p, hit *h);

#endif
