#include "texture/pattern.h"

#include "texture/warp.h"

#include <string.h>

const pattern_class pattern_average = { .keyword = "average" };

extern const pattern_class pattern_checker, pattern_square;

static const pattern_class *const classes[] = {
    &pattern_average,
    &pattern_checker,
    &pattern_square,
};

const pattern_class *pattern_find(const char *keyword)
{
    for (size_t i = 0; i < sizeof classes / sizeof classes[0]; i++)
        if (strcmp(classes[i]->keyword, keyword) == 0)
            return classes[i];
    return NULL;
}

bool pattern_needs_noise(const pattern *p)
{
    return (p->class->flags & PATTERN_NEEDS_NOISE) || !turbulence_is_none(&p->turbulence) || warp_needs_noise(p->warps);
}
