/* light.h - light sources. */
#ifndef MODEL_LIGHT_H
#define MODEL_LIGHT_H

#include "model/colour.h"

#include <povtrace/math.h>

/* POINT: emits alike in all directions, and does not fade. */
typedef enum light_type { LIGHT_POINT, LIGHT_TYPES } light_type;

typedef struct light {
    light_type type;
    pov_vec3 position, position_lo;   /* world space, the sum of both */
    colour color;
} light;

#endif
