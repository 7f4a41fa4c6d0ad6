/* geometry.h - directions at surfaces, by lane. */
#ifndef SHADE_GEOMETRY_H
#define SHADE_GEOMETRY_H

#include "world/surface.h"

#include <povtrace/exact.h>

/* Geometry of surfaces relative to the incident rays. Light uses the shading normals; the side to which a ray leaves
 * follows from the geometric ones. */
typedef struct geometry {
    incidence to;                /* its normals are the geometric ones */
    const vec_lanes *shading;    /* the shading normals, unit, facing the ray's start but for some that a
                                  * texture perturbed: those of `to` unless some
                                  * surface's differ */
    vec_lanes bent;              /* memory for shading normals that differ */
    vec_lanes view;              /* the direction, unit */
    vec_lanes reflected;         /* view, mirrored; unit */
    const vec_lanes *raw;        /* the shading normals before textures perturbed them */
    const vec_lanes *mirrored;   /* directions of reflected rays: `reflected` unless some ray would go into the surface */
    vec_lanes turned, smooth;    /* memory for these */
    double cosine[WORLD_MANY];   /* between shading normal and the direction back; negative where a perturbed
                                  * normal does not face it */
    const double *view_side, *reflected_side;   /* cosines between geometric normals and the directions view, back, and
                                  * mirrored: `cosine` unless the shading normals differ; the latter is negative where
                                  * the ray goes to the other side */
    double sides[2][WORLD_MANY];   /* memory for these */
} geometry;

/* Do the two kinds of normals differ? */
static inline bool geometry_is_bent(const geometry *g) { return g->shading != &g->to.normal; }

/* Initialise all lanes with valid numbers. */
void geometry_begin(geometry *g);
/* Compute view, reflected direction and cosine from n rays and shading normals. */
void geometry_turn(geometry *g, uint32_t n);

/* The cosines to the shading normal of the ways to and from lane i's mirror, added up. They differ where a perturbed normal
 * would mirror the ray into the surface. */
static inline double geometry_cosines(const geometry *g, uint32_t i)
{
    const pov_vec3 mirrored = lanes_at(g->mirrored, i);

    if (g->cosine[i] >= 0.0 && g->mirrored->x[i] == g->reflected.x[i] && g->mirrored->y[i] == g->reflected.y[i] && g->mirrored->z[i] == g->reflected.z[i])
        return 2.0 * g->cosine[i];
    return fabs(g->cosine[i]) + fabs(pov_dot(lanes_at(g->shading, i), mirrored));
}

/* Normalise a vector whose squared length is within double's range, bit for bit as pov_unit(). Returns -1, or 0 if it
 * or a component is out of range and the result invalid. (An integer as wide as a double makes the shortest loops.) */
static inline int64_t geometry_unit(double x, double y, double z, pov_vec3 *out)
{
    const double square = x * x + y * y + z * z, length = sqrt(square), inverse = 1.0 / length;
    const int moderate = pov_is_moderate(x) & pov_is_moderate(y) & pov_is_moderate(z);

    *out = pov_vec3_of(pov_quotient(x, length, inverse), pov_quotient(y, length, inverse), pov_quotient(z, length, inverse));
    return ((square >= 1e-239) & (square <= 1e239) & moderate) ? -1 : 0;
}

#endif
