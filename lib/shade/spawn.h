/* spawn.h - paths that continue from surfaces. */
#ifndef SHADE_SPAWN_H
#define SHADE_SPAWN_H

#include "shade/surface.h"

/* Begin a path from the surface, in a direction without a low part. The caller sets the ray's origin surface and counts
 * the path. */
static inline path *spawn(batch *b, const surface *s, pov_vec3 direction, coefficient factor, bool deeper)
{
    const path *p = s->from;
    path *next = &b->paths[b->count];
    pov_ray *ray = &b->own[b->count];

    world_origin_put(ray, s->at);
    ray->dir = direction;
    simd_copy(&next->inside, &p->inside, sizeof *next - offsetof(path, inside));
    next->lane = b->last = p->lane;
    next->factor = factor;
    next->level = p->level + deeper;
    next->coincident = s->coincident;
    next->above = s->above;
    next->zero_steps = 0;
    next->gathering = false;
    return next;
}

/* How a path goes on; and what it meets on its way. */
enum { TURN_MIRRORED = 1, TURN_TRANSMITTED, TURN_GATHERING, TURN_GATHERING_BEHIND, TURN_MEDIA, TURN_AIR, TURN_TO_LAMP, TURN_UNSCATTERED };
static inline void spawn_turn(path *p, uint32_t how) { p->branch = p->branch * 0x9e3779b1u + how; }

#endif
