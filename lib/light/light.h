/* light.h - the kinds of light sources: incident light at points. One row of a table, and one file, each. */
#ifndef LIGHT_LIGHT_H
#define LIGHT_LIGHT_H

#include "base/lanes.h"
#include "model/light.h"

/* Incident light, by lane. Surfaces between a point and point + tmax dir cast a shadow there. */
typedef struct light_lanes {
    vec_lanes dir;
    double tmax;
    bool uniform;                /* the incident light is `color` in all lanes; red, green and blue are not filled */
    colour color;
    float red[LANES_MAX], green[LANES_MAX], blue[LANES_MAX];
} light_lanes;

/* A point is the sum of point and point_lo. Lanes past n, up to whole vectors of the processor, may be read and
 * written. */
typedef struct light_points { const vec_lanes *point, *point_lo; uint32_t n; } light_points;

/* The light that l sends from `from` + `from_lo`: its position, or a point of its area. */
typedef struct light_origin { pov_vec3 from, from_lo; } light_origin;

typedef struct light_class {
    void (*incident)(const light *l, const light_origin *from, const light_points *at, light_lanes *out);
    bool parallel;               /* light does not come from the origin itself, but from a plane through it */
} light_class;

/* The row of a light. */
const light_class *light_class_of(const light *l);

static inline light_origin light_own_origin(const light *l)
{
    const light_origin o = { l->position, l->position_lo };

    return o;
}

extern const light_class light_point, light_fading, light_spot, light_cylinder, light_parallel;

#endif
