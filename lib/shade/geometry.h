/* geometry.h - directions at surfaces, by lane. */
#ifndef SHADE_GEOMETRY_H
#define SHADE_GEOMETRY_H

#include "world/surface.h"

/* How surfaces lie towards the rays that hit them. Light is computed with the shading normals; to which side of a surface
 * a ray goes is decided by the geometric ones. */
typedef struct geometry {
    incidence to;                /* its normals are the geometric ones */
    const vec_lanes *shading;    /* the shading normals, unit, turned towards the ray's start: those of `to` unless they
                                  * differ for some surface */
    vec_lanes bent;              /* memory for shading normals that differ */
    vec_lanes view;              /* the direction, unit */
    vec_lanes reflected;         /* view, mirrored; unit */
    double cosine[WORLD_MANY];   /* between shading normal and the direction back, >= 0 */
    const double *view_side, *reflected_side;   /* cosines between geometric normals and the directions view, back, and
                                  * reflected: `cosine` unless the shading normals differ */
    double sides[2][WORLD_MANY];   /* memory for these */
} geometry;

/* Do the two kinds of normals differ? */
static inline bool geometry_is_bent(const geometry *g) { return g->shading != &g->to.normal; }

/* Of no surfaces yet: lanes hold what is computed with like any other. */
void geometry_begin(geometry *g);
/* What n rays and shading normals make of view, mirrored direction and cosine. */
void geometry_turn(geometry *g, uint32_t n);

/* The unit vector along one whose squares stay within double's range; it is pov_unit()'s bit for bit. 0 and not -1: it
 * is one of the others, and what was put out is worth nothing. (An integer as wide as a double makes the shortest
 * loops.) */
static inline int64_t geometry_unit(double x, double y, double z, pov_vec3 *out)
{
    const double square = x * x + y * y + z * z, length = sqrt(square);

    *out = pov_vec3_of(x / length, y / length, z / length);
    return ((square >= 1e-239) & (square <= 1e239)) ? -1 : 0;
}

#endif
