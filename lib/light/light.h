/* light.h - the kinds of light sources: incident light at points. One row of a table, and one file, each. */
#ifndef LIGHT_LIGHT_H
#define LIGHT_LIGHT_H

#include "base/lanes.h"
#include "model/light.h"

/* Light from one sample of a source, by lane. Surfaces between a point and point + tmax dir cast a shadow there. */
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

typedef struct light_class {
    /* Number of samples of the source. A surface is lit from sample 0, times the mean visibility of all samples. */
    uint32_t (*samples)(const light *l);
    void (*sample)(const light *l, uint32_t k, const light_points *at, light_lanes *out);
} light_class;

/* The row of l->type. */
const light_class *light_class_of(const light *l);

extern const light_class light_point;

#endif
