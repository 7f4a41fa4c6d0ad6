#include "texture/pattern.h"

#include "texture/inner.h"
#include "texture/warp.h"

#include <string.h>

const pattern_class pattern_average = { .keyword = "average" };

extern const pattern_class pattern_agate, pattern_aoi, pattern_boxed, pattern_bozo, pattern_brick,
    pattern_bump_map, pattern_bumps, pattern_cells, pattern_checker, pattern_crackle, pattern_cubic,
    pattern_cylindrical, pattern_dents, pattern_facets, pattern_gradient, pattern_granite, pattern_hexagon,
    pattern_image_pattern, pattern_julia, pattern_leopard, pattern_magnet, pattern_mandel,
    pattern_marble, pattern_onion, pattern_pavement, pattern_planar, pattern_quilted, pattern_radial,
    pattern_ripples, pattern_slope, pattern_spherical, pattern_spiral1, pattern_spiral2, pattern_spotted,
    pattern_square, pattern_tiling, pattern_triangular, pattern_waves, pattern_wood, pattern_wrinkles;

static const pattern_class *const classes[] = {
    &pattern_agate, &pattern_aoi, &pattern_average, &pattern_boxed, &pattern_bozo, &pattern_brick,
    &pattern_bump_map, &pattern_bumps, &pattern_cells, &pattern_checker, &pattern_crackle, &pattern_cubic,
    &pattern_cylindrical, &pattern_density_file, &pattern_dents, &pattern_facets, &pattern_function, &pattern_gradient,
    &pattern_granite, &pattern_hexagon, &pattern_image_map, &pattern_image_pattern, &pattern_julia,
    &pattern_leopard, &pattern_magnet, &pattern_mandel, &pattern_marble, &pattern_object, &pattern_onion,
    &pattern_pavement, &pattern_pigment_pattern, &pattern_planar, &pattern_quilted, &pattern_radial,
    &pattern_ripples, &pattern_slope, &pattern_spherical, &pattern_spiral1, &pattern_spiral2, &pattern_spotted,
    &pattern_square, &pattern_tiling, &pattern_triangular, &pattern_waves, &pattern_wood, &pattern_wrinkles,
};

const pattern_class *pattern_find(const char *keyword)
{
    for (size_t i = 0; i < sizeof classes / sizeof classes[0]; i++)
        if (strcmp(classes[i]->keyword, keyword) == 0)
            return classes[i];
    return NULL;
}

const pattern_class *pattern_at(size_t index)
{
    return index < sizeof classes / sizeof classes[0] ? classes[index] : NULL;
}

bool pattern_needs_noise(const pattern *p)
{
    return (p->class->flags & PATTERN_NEEDS_NOISE) || !turbulence_is_none(&p->turbulence) || warp_needs_noise(p->warps);
}
