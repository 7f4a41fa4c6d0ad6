/* plane { <normal>, distance }: the points p with n . p = distance, n the unit normal; inside where n . p is not larger.
 *
 * A quadric without second-order terms. The normal is taken as written and the distance is multiplied by its length, in
 * double-double: dividing the normal would turn the plane by a rounding. */
#include "common/quadric_block.h"

typedef struct plane_parsed { pov_vec3 normal; double distance; } plane_parsed;

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    plane_parsed *p = self;

    host->vector(in, &p->normal);
    host->accept(in, ",");
    p->distance = host->number(in);
    if (!(pov_largest(p->normal) > 0.0))
        host->fail(in, "the normal of a plane must have a direction");
}

static pov_two length_of(pov_vec3 v)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    const pov_two3 two = pov_two3_of(v, zero);

    return pov_two_sqrt(pov_two3_dot(two, two));
}

static void prepare(void *self, const void *parsed)
{
    const plane_parsed *p = parsed;
    const double near_one = pov_inverse_power(pov_largest(p->normal));
    const pov_vec3 n = pov_scale(p->normal, near_one);
    pov_two q[COEFFICIENTS] = { { 0.0, 0.0 } };

    q[G].hi = n.x;
    q[H].hi = n.y;
    q[I].hi = n.z;
    q[J] = pov_two_mul_double(length_of(n), -p->distance);
    common_quadric_make_two(self, q);
}

static bool bounds(const void *self, pov_box *out)
{
    (void)self;
    (void)out;
    return false;
}

static bool absorb(void *self, const pov_affine *map) { return common_quadric_absorb(self, map); }

static const pov_shape_fast plane_fast = {
    .size = sizeof(pov_shape_fast),
    .block_size = sizeof(common_quadric_block),
    .block_pack = common_quadric_pack,
    .block_filter = common_quadric_filter,
    .intersect_many = common_plane_intersect_pairs,
    .half_space = common_quadric_half_space,
    .outline = common_quadric_outline,
    .cross_sure = common_plane_cross_sure,
    .block_bounds = common_plane_bounds,
};

static const void *extension(const char *name) { return common_is_fast(name) ? &plane_fast : NULL; }

static const pov_shape_class plane_class = {
    .size = sizeof(pov_shape_class),
    .flags = POV_SHAPE_SOLID | POV_SHAPE_CONVEX | POV_SHAPE_FACETED | POV_SHAPE_CERTIFIED,
    .keyword = "plane",
    .instance_size = sizeof(common_quadric),
    .parse = parse,
    .bounds = bounds,
    .intersect = common_quadric_intersect,
    .normal = common_quadric_normal,
    .inside = common_quadric_inside,
    .absorb = absorb,
    .parsed_size = sizeof(plane_parsed),
    .prepare = prepare,
    .extension = extension,
};

static const pov_shape_class *const shapes[] = { &plane_class, NULL };

POV_PLUGIN(plane) = {
    .abi = POV_PLUGIN_ABI,
    .size = sizeof(pov_plugin),
    .name = "plane",
    .version = "1",
    .shapes = shapes,
};
