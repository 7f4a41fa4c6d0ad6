/* cylinder { <base>, <top>, radius [open] } */
#include "common/cone.h"
#include "common/radius.h"

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    common_cone_parsed *parsed = self;

    host->vector(in, &parsed->base);
    host->accept(in, ",");
    host->vector(in, &parsed->top);
    if (pov_largest(pov_sub(parsed->top, parsed->base)) == 0.0)
        host->fail(in, "a cylinder needs two different ends");
    host->accept(in, ",");
    parsed->base_radius = parsed->top_radius = common_radius(host, in);
    parsed->open = host->accept(in, "open");
}

static const pov_shape_fast cylinder_fast = {
    .size = sizeof(pov_shape_fast),
    .block_size = sizeof(common_cone_block),
    .single_block_size = COMMON_CONE_SINGLE,
    .block_pack = common_cone_pack,
    .block_filter = common_cone_filter,
    .intersect_many = common_cone_intersect_many,
    .normal_many = common_cone_normal_many,
    .outline = common_cone_outline,
    .reorder = common_cone_reorder,
};

static const void *extension(const char *name) { return common_is_fast(name) ? &cylinder_fast : NULL; }

static const pov_shape_class cylinder_class = {
    .size = sizeof(pov_shape_class),
    .flags = POV_SHAPE_SOLID | POV_SHAPE_CONVEX | POV_SHAPE_CERTIFIED,
    .keyword = "cylinder",
    .instance_size = sizeof(common_cone),
    .parse = parse,
    .bounds = common_cone_bounds,
    .intersect = common_cone_intersect,
    .normal = common_cone_normal,
    .inside = common_cone_inside,
    .absorb = common_cone_absorb,
    .parsed_size = sizeof(common_cone_parsed),
    .prepare = common_cone_prepare,
    .extension = extension,
    .open = common_cone_open,
};

static const pov_shape_class *const shapes[] = { &cylinder_class, NULL };

POV_PLUGIN(cylinder) = {
    .abi = POV_PLUGIN_ABI,
    .size = sizeof(pov_plugin),
    .name = "cylinder",
    .version = "1",
    .shapes = shapes,
};
