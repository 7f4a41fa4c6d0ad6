#include "light/light.h"

static const light_class *const classes[LIGHT_TYPES] = {
    [LIGHT_POINT] = &light_point,
};

const light_class *light_class_of(const light *l)
{
    return classes[l->type];
}
