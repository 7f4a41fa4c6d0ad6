/* quadric { <A,B,C>, <D,E,F>, <G,H,I>, J }: A x^2 + B y^2 + C z^2 + D xy + E xz + F yz + G x + H y + I z + J = 0,
 * inside where it is not positive.
 */
#include "common/quadric_block.h"

typedef struct quadric_parsed { double q[COEFFICIENTS]; } quadric_parsed;

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    double *q = ((quadric_parsed *)self)->q;
    pov_vec3 v;
    int i;

    for (i = 0; i < 3; i++) {
        host->vector(in, &v);
        host->accept(in, ",");
        q[3 * i] = v.x;
        q[3 * i + 1] = v.y;
        q[3 * i + 2] = v.z;
    }
    q[J] = host->number(in);
}

static void prepare(void *self, const void *parsed) { common_quadric_make(self, ((const quadric_parsed *)parsed)->q); }

static bool bounds(const void *self, pov_box *out) { return common_quadric_bounds(self, out); }
static bool ellipsoid(const void *self, pov_ellipsoid *out) { return common_quadric_ellipsoid(self, out); }
static bool absorb(void *self, const pov_affine *map) { return common_quadric_absorb(self, map); }

static const pov_shape_fast quadric_fast = {
    .size = sizeof(pov_shape_fast),
    .block_size = sizeof(common_quadric_block),
    .block_pack = common_quadric_pack,
    .block_filter = common_quadric_filter,
    .intersect_many = common_quadric_intersect_pairs,
    .normal_many = common_quadric_normal_pairs,
    .ellipsoid = ellipsoid,
    .half_space = common_quadric_half_space,
    .hull = common_quadric_hull,
    .outline = common_quadric_outline,
};

static const void *extension(const char *name) { return common_is_fast(name) ? &quadric_fast : NULL; }

static const pov_shape_class quadric_class = {
    .size = sizeof(pov_shape_class),
    .flags = POV_SHAPE_SOLID | POV_SHAPE_CERTIFIED,
    .keyword = "quadric",
    .instance_size = sizeof(common_quadric),
    .parse = parse,
    .bounds = bounds,
    .intersect = common_quadric_intersect,
    .normal = common_quadric_normal,
    .inside = common_quadric_inside,
    .absorb = absorb,
    .parsed_size = sizeof(quadric_parsed),
    .prepare = prepare,
    .extension = extension,
};

static const pov_shape_class *const shapes[] = { &quadric_class, NULL };

POV_PLUGIN(quadric) = {
    .abi = POV_PLUGIN_ABI,
    .size = sizeof(pov_plugin),
    .name = "quadric",
    .version = "1",
    .shapes = shapes,
};
