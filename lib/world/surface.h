/* surface.h - where rays meet objects: points and normals. */
#ifndef WORLD_SURFACE_H
#define WORLD_SURFACE_H

#include "base/lanes.h"
#include "world/world.h"

#include <povtrace/shape.h>

/* A ray's candidate with an object: two lines of memory where it begins with one, and what is known at first in one of
 * them. */
typedef struct hit {
    pov_vec3 point, point_lo;    /* world space, the sum of both */
    pov_vec3 normal;             /* unit, world space, out of the solid (inverse objects: into it) */
    bool entering;               /* the ray goes against that normal */
    bool outside;                /* the ray goes against the shape's own: it comes from where no convex shape is */
    uint16_t coincident;         /* how many surfaces lie on each other here, this one among them; 0: it is alone */
    uint32_t object;
    pov_crossing crossing;
} hit;

/* Fill the rest of what world_nearest() found. */
void world_surface(const world *w, const pov_ray *ray, hit *h);

enum { WORLD_MANY = LANES_MAX };

/* How rays come to surfaces, by lane. */
typedef struct incidence {
    vec_lanes dir;               /* direction of the ray */
    vec_lanes point, point_lo;
    vec_lanes normal;            /* unit, turned towards the ray's start */
} incidence;

typedef struct object_space_rays object_space_rays;

/* Of a hit that is filled. */
void world_incidence(incidence *out, uint32_t lane, const pov_ray *ray, const hit *h);
/* Of up to WORLD_MANY rays with a hit each: what world_surface() fills, bit for bit, and the approaches; many cost less
 * than as many alone. from: what the query that found the hits knows more of them, see query_context_own(); or NULL. */
void world_surface_many(const world *w, const object_space_rays *from, const pov_ray *const *rays, hit *const *hits,
                        uint32_t n, incidence *out);

/* Some hundred times what normals may be off by. */
#define WORLD_GRAZING 0x1p-36

/* What a ray leaves, with what more is known of it. The mark is put together before it is stored: who waits for it reads
 * it at once. */
static inline void world_set_origin(pov_ray *ray, const hit *h, uint32_t known)
{
    const pov_mark *mark = &h->crossing.mark;

    ray->origin_surface = h->object;
    ray->origin_mark.feature = mark->feature;
    ray->origin_mark.flags = mark->flags | known;
    ray->origin_mark.u = mark->u;
    ray->origin_mark.v = mark->v;
}

/* Name what a ray leaves that goes back to the side that it came from, at this cosine to the normal there. Up to
 * WORLD_GRAZING nothing is said of whether it goes away. */
static inline void world_origin_reflect(pov_ray *ray, const hit *h, double cosine)
{
    world_set_origin(ray, h, cosine > WORLD_GRAZING ? (h->outside ? POV_MARK_OUTWARD : POV_MARK_INWARD) : 0);
}

/* The same of a ray that goes on to the other side. */
static inline void world_origin_transmit(pov_ray *ray, const hit *h, double cosine)
{
    world_set_origin(ray, h, cosine > WORLD_GRAZING ? (h->outside ? POV_MARK_INWARD : POV_MARK_OUTWARD) : 0);
}

#endif
