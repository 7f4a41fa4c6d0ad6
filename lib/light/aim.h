/* aim.h - directions to lights, and what kinds of lights share. */
#ifndef LIGHT_AIM_H
#define LIGHT_AIM_H

#include "light/light.h"

static inline double light_length(pov_vec3 v)
{
    const double most = pov_largest(v);

    return most > 0.0 ? most * sqrt(pov_dot(pov_scale(v, 1.0 / most), pov_scale(v, 1.0 / most))) : 0.0;
}

/* Vectors from points to an origin, by lane, rounded once. */
void light_aim(const light_origin *from, const light_points *at, vec_lanes *dir);
/* The same to an origin each. */
void light_aim_each(const vec_lanes *from, const vec_lanes *from_lo, const light_points *at, vec_lanes *dir);
/* Directions against the axis, as long as the point's distance from the plane across it through the origin; hardly any
 * length behind that plane. The distances, negative behind it, are given, too. */
void light_aim_parallel(const light *l, const light_origin *from, const light_points *at, vec_lanes *dir, double *distance);
/* Lengths of directions, by lane. */
void light_lengths(const vec_lanes *dir, uint32_t n, double *length);
/* Colours of the light, dimmed by these factors, and where it fades by these distances. */
void light_dim(const light *l, const double *factor, const double *distance, uint32_t n, light_lanes *out);

#endif
