/* light.h - light sources. */
#ifndef MODEL_LIGHT_H
#define MODEL_LIGHT_H

#include "model/colour.h"

#include <povtrace/math.h>
#include <stdint.h>

/* POINT: emits alike in all directions. SPOT: in a cone around its axis. CYLINDER: parallel rays within a distance of the
 * axis. PARALLEL: parallel rays everywhere. */
typedef enum light_type { LIGHT_POINT, LIGHT_SPOT, LIGHT_CYLINDER, LIGHT_PARALLEL, LIGHT_TYPES } light_type;

enum {
    LIGHT_SHADOWLESS = 1,        /* no shadows and no highlights */
    LIGHT_AREA = 2, LIGHT_CIRCULAR = 4, LIGHT_ORIENT = 8, LIGHT_JITTER = 16, LIGHT_AREA_ILLUMINATION = 32,
    LIGHT_NO_MEDIA = 64,         /* no medium scatters it */
    LIGHT_ATTENUATED = 128,      /* the atmosphere and fog dim it on its whole way */
    LIGHT_AHEAD = 256            /* PARALLEL: it shines on nothing behind the plane through its place */
};

/* A grid of rows x columns points around the position, side by side along two axes, from end to end. */
typedef struct light_area { pov_vec3 axes[2]; uint32_t counts[2]; } light_area;

/* Objects that lights of their own shine on. The first group's number is 1; leaf and leaf_count name its objects, which
 * are consecutive. A group within another one stands before it, and has the greater number; the lights of those around it that
 * have at most the number `from` shine on its objects too. */
typedef struct light_group { uint32_t leaf, leaf_count, number, from; bool global_lights; } light_group;

typedef struct light {
    light_type type;
    uint32_t flags;              /* LIGHT_* */
    pov_vec3 position, position_lo;   /* world space, the sum of both */
    pov_vec3 axis;               /* unit; away from the light */
    double aim;                  /* how far along the axis it points at; beams from points of an area all meet there */
    colour color;
    double radius, falloff, tightness;   /* SPOT: cosines of the angles; CYLINDER: distances from the axis */
    double fade_distance, fade_power;    /* it fades if both are above 0 */
    light_area area;
    uint32_t through, through_count;     /* leaves that its rays have to cross to give light, unseen otherwise; 0: none */
    uint32_t group;              /* number of the group that it lights; 0: all objects but those of groups without
                                  * global lights */
} light;

static inline bool light_fades(const light *l) { return l->fade_distance > 0.0 && l->fade_power > 0.0; }

#endif
