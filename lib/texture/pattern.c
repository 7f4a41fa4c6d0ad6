#include "texture/pattern.h"

#include "texture/warp.h"

#include <string.h>

const pattern_class pattern_average = { .keyword = "average" };

extern const pattern_class pattern_aoi, pattern_brick, pattern_bump_map, pattern_cells, pattern_checker,
    pattern_crackle, pattern_facets, pattern_hexagon, pattern_image_map, pattern_image_pattern, pattern_julia,
    pattern_magnet, pattern_mandel, pattern_slope, pattern_square, pattern_triangular;

static const pattern_class *const classes[] = {
    &pattern_aoi, &pattern_average, &pattern_brick, &pattern_bump_map, &pattern_cells, &pattern_checker,
    &pattern_crackle, &pattern_density_file, &pattern_facets, &pattern_hexagon, &pattern_image_map,
    &pattern_image_pattern, &pattern_julia, &pattern_magnet, &pattern_mandel, &pattern_slope, &pattern_square,
    &pattern_triangular,
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
