/* light.h - a point light that does not fade. */
#ifndef MODEL_LIGHT_H
#define MODEL_LIGHT_H

#include "model/colour.h"

#include <povtrace/math.h>

typedef struct light {
    pov_vec3 position, position_lo;   /* world space, the sum of both */
    colour color;
} light;

#endif
