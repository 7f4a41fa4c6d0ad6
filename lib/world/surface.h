/* surface.h - hits of rays: points and normals. */
#ifndef WORLD_SURFACE_H
#define WORLD_SURFACE_H

#include "base/lanes.h"
#include "world/world.h"

#include <povtrace/shape.h>

/* A ray's hit: two cache lines if aligned, with the members known first in one of them. */
typedef struct hit {
    pov_vec3 point, point_lo;    /* world space, the sum of both */
    pov_vec3 normal;             /* unit, world space, out of the solid (inverse objects: into it) */
    bool entering;               /* the ray goes against that normal */
    bool outside;                /* the ray goes against the shape's own normal: it comes from outside if the shape is
                                  * convex */
    uint16_t coincident;         /* number of coincident surfaces here, this one included; 0: no others */
    uint32_t object;
    pov_crossing crossing;
} hit;

/* Surfaces that share a place: see query.h. */
enum { COINCIDENT_MAX = 16 };

typedef struct coincident_set {
    uint32_t count;
    uint32_t above;              /* bit i: the point is on the side that the normal of at[i] points to */
    uint32_t solid;              /* bit i: at[i] is a solid's */
    hit at[COINCIDENT_MAX];      /* by object */
} coincident_set;

/* Complete a hit of a query. */
void world_surface(const world *w, const pov_ray *ray, hit *h);
/* Does the ray of a complete hit come upon the front of the surface? For most shapes that is the outside. */
bool world_is_at_front(const world *w, const pov_ray *ray, const hit *h);

enum { WORLD_MANY = LANES_MAX };

/* Incident rays at surfaces, by lane. */
typedef struct incidence {
    vec_lanes dir;               /* direction of the ray */
    vec_lanes point, point_lo;
    vec_lanes normal;            /* unit, facing the ray's start */
} incidence;

typedef struct object_space_rays object_space_rays;

/* Store the incidence of a completed hit. */
void world_incidence(incidence *out, uint32_t lane, const pov_ray *ray, const hit *h);
/* Complete up to WORLD_MANY hits as world_surface(), bit for bit, and store their incidence; many cost less than as
 * many alone. from: object space rays of the query that found the hits, see query_context_own(); or NULL. */
void world_surface_many(const world *w, const object_space_rays *from, const pov_ray *const *rays, hit *const *hits,
                        uint32_t n, incidence *out);

/* Some hundred times the error of normals. */
#define WORLD_GRAZING 0x1p-36

enum { SURFACE_POINT_AGREES = 1 / (offsetof(hit, point_lo) == sizeof(pov_vec3) && offsetof(pov_ray, org_lo) == sizeof(pov_vec3)) };

/* Start a ray at the point of a hit. */
static inline void world_origin_put(pov_ray *ray, const hit *h) { simd_copy(ray, h, 2 * sizeof(pov_vec3)); }

/* Record the surface on which a secondary ray starts. The mark is assembled in registers first: the next read would
 * otherwise stall on store forwarding. */
static inline void world_set_origin(pov_ray *ray, const hit *h, uint32_t known)
{
    const pov_mark *mark = &h->crossing.mark;

    ray->origin_surface = h->object;
    ray->origin_mark.feature = mark->feature;
    ray->origin_mark.flags = mark->flags | known;
    ray->origin_mark.u = mark->u;
    ray->origin_mark.v = mark->v;
}

/* Set the origin surface of a reflected ray, at this cosine to the normal. Up to WORLD_GRAZING neither outward nor
 * inward is claimed. */
static inline void world_origin_reflect(pov_ray *ray, const hit *h, double cosine)
{
    world_set_origin(ray, h, cosine > WORLD_GRAZING ? (h->outside ? POV_MARK_OUTWARD : POV_MARK_INWARD) : 0);
}

/* The same for a transmitted ray. */
static inline void world_origin_transmit(pov_ray *ray, const hit *h, double cosine)
{
    world_set_origin(ray, h, cosine > WORLD_GRAZING ? (h->outside ? POV_MARK_INWARD : POV_MARK_OUTWARD) : 0);
}

/* Add to the origin surface of a ray, set without a side, which one it goes to, as below; outside: the one that `along` is
 * measured to is. */
static inline void world_origin_leave(pov_ray *ray, bool outside, double along, double length)
{
    const bool up = along > WORLD_GRAZING * length, down = -along > WORLD_GRAZING * length;

    ray->origin_mark.flags |= (up ? (outside ? POV_MARK_OUTWARD : POV_MARK_INWARD) : 0) |
                              (down ? (outside ? POV_MARK_INWARD : POV_MARK_OUTWARD) : 0);
}

/* Of a ray whose origin surface is set: the side that it goes to, by its component along the surface's normal and by an
 * upper bound of its length. */
static inline void world_origin_aim(pov_ray *ray, const hit *h, double along, double length)
{
    ray->origin_mark.flags = h->crossing.mark.flags;
    world_origin_leave(ray, h->outside, along, length);
}

#endif
