/* smooth_triangle { <a>, <normal at a>, <b>, <normal at b>, <c>, <normal at c> }: flat to rays, while light sees the
 * blend of the three normals. */
#include "common/triangle_shape.h"

static void read_vector(const pov_host *host, pov_reader *in, pov_vec3 *out)
{
    host->vector(in, out);
    host->accept(in, ",");
}

/* As in POV-Ray the side of the normals is the front, and a triangle whose normals are not all on one side is dropped. */
static bool choose_side(common_triangle *t)
{
    int front = 0, back = 0, i;

    for (i = 0; i < 3; i++) {
        const double side = pov_dot(t->normal, t->at_corner[i]);

        front += side > 0.0;
        back += side < 0.0;
    }
    if (back == 3)
        t->normal = pov_scale(t->normal, -1.0);
    return front == 3 || back == 3;
}

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    common_triangle *t = self;
    pov_vec3 corner[3], normal;
    int i;

    for (i = 0; i < 3; i++) {
        read_vector(host, in, &corner[i]);
        if (i < 2)
            read_vector(host, in, &normal);
        else
            host->vector(in, &normal);
        t->at_corner[i] = pov_unit(normal);
    }
    common_triangle_make(t, corner);
    if (!t->seen)
        host->warn(in, "the corners of this triangle lie on a line: it is not seen");
    else if (!choose_side(t)) {
        t->seen = false;
        host->warn(in, "the normals of this triangle are not all on one side of it: it is not seen");
    }
}

static const pov_shape_fast smooth_triangle_fast = {
    .size = sizeof(pov_shape_fast),
    .block_size = sizeof(common_planar_block),
    .single_block_size = COMMON_PLANAR_SINGLE,
    .block_pack = common_triangle_pack,
    .block_filter = common_planar_filter,
};

static const void *extension(const char *name) { return common_is_fast(name) ? &smooth_triangle_fast : NULL; }

static const pov_shape_class smooth_triangle_class = {
    .size = sizeof(pov_shape_class),
    .flags = POV_SHAPE_CONVEX | POV_SHAPE_FACETED | POV_SHAPE_CERTIFIED,
    .keyword = "smooth_triangle",
    .instance_size = sizeof(common_triangle),
    .parse = parse,
    .bounds = common_triangle_bounds,
    .intersect = common_triangle_intersect,
    .normal = common_triangle_plane_normal,
    .shading_normals = common_triangle_shading_normals,
    .extension = extension,
};

static const pov_shape_class *const shapes[] = { &smooth_triangle_class, NULL };

POV_PLUGIN(smooth_triangle) = {
    .abi = POV_PLUGIN_ABI,
    .size = sizeof(pov_plugin),
    .name = "smooth_triangle",
    .version = "1",
    .shapes = shapes,
};
