#include "light/light.h"

static const light_class *const classes[LIGHT_TYPES] = {
    [LIGHT_POINT] = &light_point,
    [LIGHT_SPOT] = &light_spot,
    [LIGHT_CYLINDER] = &light_cylinder,
    [LIGHT_PARALLEL] = &light_parallel,
};

const light_class *light_class_of(const light *l)
{
    return l->type == LIGHT_POINT && light_fades(l) ? &light_fading : classes[l->type];
}
