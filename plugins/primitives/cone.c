/* cone { <base>, base radius, <top>, top radius [open] } */
#include "kit/frustum.h"

static double radius_from(const pov_host *host, pov_reader *in)
{
    double radius;

    host->accept(in, ",");
    radius = host->number(in);
    if (radius < 0.0)
        host->warn(in, "a negative radius is taken as positive");
    return fabs(radius);
}

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    kit_frustum_text *text = self;

    host->vector(in, &text->base);
    text->base_radius = radius_from(host, in);
    host->accept(in, ",");
    host->vector(in, &text->top);
    if (pov_largest(pov_sub(text->top, text->base)) == 0.0)
        host->fail(in, "a cone needs two different ends");
    text->top_radius = radius_from(host, in);
    text->open = host->accept(in, "open");
}

static const pov_shape_fast cone_fast = {
    .size = sizeof(pov_shape_fast),
    .block_size = sizeof(kit_frustum_block),
    .single_block_size = KIT_FRUSTUM_ALONE,
    .block_pack = kit_frustum_pack,
    .block_filter = kit_frustum_filter,
    .intersect_many = kit_frustum_intersect_many,
    .normal_many = kit_frustum_normal_many,
};

static const void *extension(const char *name) { return kit_is_fast(name) ? &cone_fast : NULL; }

static const pov_shape_class cone_class = {
    .size = sizeof(pov_shape_class),
    .flags = POV_SHAPE_SOLID | POV_SHAPE_CONVEX | POV_SHAPE_CERTIFIED,
    .keyword = "cone",
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

static const pov_shape_class *const shapes[] = { &cone_class, NULL };

POV_PLUGIN(cone) = {
    .abi = POV_PLUGIN_ABI,
    .size = sizeof(pov_plugin),
    .name = "cone",
    .version = "1",
    .shapes = shapes,
};
