/* own_space.h - a ray in the space of a shape that it crosses, where the crossing was computed. */
#ifndef QUERY_OWN_SPACE_H
#define QUERY_OWN_SPACE_H

#include "query/context.h"
#include "world/copy_path.h"

typedef struct own_space {
    const shape_class *shape;
    const void *instance;
    bool moved;                  /* the space is not the world */
    bool member;                 /* of a tree */
    pov_ray ray;
    double size, speed;          /* of numbers that take part in an intersection; of the ray */
} own_space;

void own_space_of(const world *w, uint32_t owner, const pov_ray *ray, own_space *out);
/* Of the angle between the ray and the surface at the crossing: not negative. */
double own_space_cosine(const own_space *s, const pov_crossing *at);

#endif
