/* triangle { <a>, <b>, <c> } */
#include "common/triangle_shape.h"

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    common_triangle *t = self;
    pov_vec3 corner[3];
    bool is_number = true;
    int i;

    for (i = 0; i < 3; i++) {
        if (i > 0)
            host->accept(in, ",");
        host->vector(in, &corner[i]);
        is_number &= corner[i].x == corner[i].x;
    }
    if (!is_number)
        memset(corner, 0, sizeof corner);
    common_triangle_make(t, corner);
    if (!t->seen)
        host->warn(in, "the corners of this triangle lie on a line: it is not seen");
}

static const pov_shape_fast triangle_fast = {
    .size = sizeof(pov_shape_fast),
    .block_size = sizeof(common_planar_block),
    .single_block_size = COMMON_PLANAR_SINGLE,
    .block_pack = common_triangle_pack,
    .block_filter = common_planar_filter,
};

static const void *extension(const char *name) { return common_is_fast(name) ? &triangle_fast : NULL; }

static const pov_shape_class triangle_class = {
    .size = sizeof(pov_shape_class),
    .flags = POV_SHAPE_CONVEX | POV_SHAPE_FACETED | POV_SHAPE_CERTIFIED,
    .keyword = "triangle",
    .instance_size = offsetof(common_triangle, at_corner),
    .parse = parse,
    .bounds = common_triangle_bounds,
    .intersect = common_triangle_intersect,
    .normal = common_triangle_plane_normal,
    .extension = extension,
    .face = common_triangle_face,
};

static const pov_shape_class *const shapes[] = { &triangle_class, NULL };

POV_PLUGIN(triangle) = {
    .abi = POV_PLUGIN_ABI,
    .size = sizeof(pov_plugin),
    .name = "triangle",
    .version = "1",
    .shapes = shapes,
};
