/* cylinder { <base>, <top>, radius [open] } */
#include "kit/frustum.h"

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    kit_frustum_text *text = self;
    double radius;

    host->vector(in, &text->base);
    host->accept(in, ",");
    host->vector(in, &text->top);
    if (pov_largest(pov_sub(text->top, text->base)) == 0.0)
        host->fail(in, "a cylinder needs two different ends");
    host->accept(in, ",");
    radius = host->number(in);
    if (radius < 0.0) {
        host->warn(in, "a negative radius is taken as positive");
        radius = -radius;
    }
    text->base_radius = text->top_radius = radius;
    text->open = host->accept(in, "open");
}

static const pov_shape_fast cylinder_fast = {
    .size = sizeof(pov_shape_fast),
    .block_size = sizeof(kit_frustum_block),
    .single_block_size = KIT_FRUSTUM_ALONE,
    .block_pack = kit_frustum_pack,
    .block_filter = kit_frustum_filter,
    .intersect_many = kit_frustum_intersect_many,
    .normal_many = kit_frustum_normal_many,
};

static const void *extension(const char *name) { return kit_is_fast(name) ? &cylinder_fast : NULL; }

static const pov_shape_class cylinder_class = {
    .size = sizeof(pov_shape_class),
    .flags = POV_SHAPE_SOLID | POV_SHAPE_CONVEX | POV_SHAPE_CERTIFIED,
    .keyword = "cylinder",
    .instance_size = sizeof(kit_frustum),
    .parse = parse,
    .bounds = kit_frustum_bounds,
    .intersect = kit_frustum_intersect,
    .normal = kit_frustum_normal,
    .inside = kit_frustum_inside,
    .absorb = kit_frustum_absorb,
    .parsed_size = sizeof(kit_frustum_text),
    .prepare = kit_frustum_prepare,
    .extension = extension,
};

static const pov_shape_class *const shapes[] = { &cylinder_class, NULL };

POV_PLUGIN(cylinder) = {
    .abi = POV_PLUGIN_ABI,
    .size = sizeof(pov_plugin),
    .name = "cylinder",
    .version = "1",
    .shapes = shapes,
};
