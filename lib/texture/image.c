#include "texture/image_sample.h"
#include "texture/pattern.h"

/* The patterns that images are: image_map gives colours, image_pattern brightness, material_map numbers of textures, and
 * bump_map bends normals. */

static void colours(const pattern_input *in, pigment *out)
{
    const image_map *map = in->of->self;
    image_place at[LANES_MAX];

    if (image_has_lanes(map)) {
        image_colours(map, in->at, in->n, out);
        return;
    }
    image_places(map, in->at, in->n, at);
    for (uint32_t i = 0; i < in->n; i++)
        out[i] = image_colour(map, at[i]);
}

/* What interpolation or bright pixels give beyond 0..1 ends there, and does not begin again as other patterns do. */
static double brightness(const image_map *map, image_place at)
{
    double value;

    if (at.is_outside)
        return 0.0;
    value = map->use_alpha ? image_colour(map, at).transmit : image_grey(map, at);
    return value > 0.0 ? value < 1.0 ? value : 1.0 : 0.0;
}

static void values(const pattern_input *in, double *value)
{
    image_place at[LANES_MAX];

    image_places(in->of->self, in->at, in->n, at);
    for (uint32_t i = 0; i < in->n; i++)
        value[i] = brightness(in->of->self, at[i]);
}

/* The number after the last one is the last texture too; larger ones begin again. */
static double texture_number(double index, uint32_t count)
{
    const uint32_t i = (uint32_t)(index > 0.0 ? index : 0.0);

    return i < count ? i : i == count ? count - 1 : i % count;
}

static void numbers(const pattern_input *in, double *value)
{
    const image_map *map = in->of->self;
    image_place at[LANES_MAX];

    image_places(map, in->at, in->n, at);
    for (uint32_t i = 0; i < in->n; i++)
        value[i] = at[i].is_outside ? 0.0 : texture_number(image_index(map, at[i]), map->count);
}

/* ---- bumps ---- */

static double height(const image_map *map, image_place at, double left, double up)
{
    at.u += left / map->image->width;
    at.v += up / map->image->height;
    return map->use_index && map->palette ? trunc(image_index(map, at)) : image_grey(map, at);
}

/* Across the normal: in the xz plane, and upwards. */
static void find_axes(pov_vec3 n, pov_vec3 *across, pov_vec3 *up)
{
    const double square = n.x * n.x + n.z * n.z;

    if (!(square > 0.0)) {
        *across = pov_vec3_of(1.0, 0.0, 0.0);
        *up = pov_vec3_of(0.0, 0.0, n.y > 0.0 ? 1.0 : -1.0);
        return;
    }
    *across = pov_unit(pov_vec3_of(-n.z, 0.0, n.x));
    *up = pov_unit(pov_sub(pov_vec3_of(0.0, 1.0, 0.0), pov_scale(n, n.y)));
}

/* Three heights one pixel apart are a plane. */
static void bump(const pattern_input *in, double amount, vec_lanes *normal)
{
    const image_map *map = in->of->self;
    image_place places[LANES_MAX];

    image_places(map, in->at, in->n, places);
    for (uint32_t i = 0; i < in->n; i++) {
        const pov_vec3 n = lanes_at(normal, i), unit = pov_unit(n);
        const image_place at = places[i];
        const double h0 = height(map, at, 0.0, 0.0), h1 = height(map, at, -1.0, -1.0), h2 = height(map, at, 1.0, -1.0);
        pov_vec3 across, up;

        if (at.is_outside)
            continue;
        find_axes(unit, &across, &up);
        lanes_put(normal, i, pov_add(n, pov_add(pov_scale(across, amount * 0.5 * (h1 - h2)),
                                                pov_scale(up, amount * (0.5 * (h1 + h2) - h0)))));
    }
}

static pigment most(const void *self) { return image_most(self); }

#define IMAGE_CLASS(name, shaped) .keyword = #name, .self_size = sizeof(image_map), .flags = PATTERN_FILE | (shaped)

const pattern_class pattern_image_map = {
    IMAGE_CLASS(image_map, PATTERN_UNSHAPED), .evaluate = values, .colours = colours, .most = most,
};
const pattern_class pattern_image_pattern = { IMAGE_CLASS(image_pattern, PATTERN_UNFOLDED), .evaluate = values };
const pattern_class pattern_material_map = { IMAGE_CLASS(material_map, PATTERN_UNSHAPED), .evaluate = numbers };
const pattern_class pattern_bump_map = { IMAGE_CLASS(bump_map, 0), .evaluate = values, .perturb = bump };
