/* sphere { <centre>, radius } */
#include "common/affine.h"
#include "common/radius.h"
#include "common/sphere_block.h"
#include "common/turns.h"

typedef struct sphere_parsed { pov_vec3 centre; double radius; } sphere_parsed;

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    sphere_parsed *parsed = self;
    pov_vec3 centre;
    double radius;

    host->vector(in, &centre);
    host->accept(in, ",");
    if (host->more(in)) {
        radius = host->number(in);
    } else if (centre.x != centre.y || centre.y != centre.z) {
        radius = host->number(in);   /* fails: the value read last is the centre */
    } else {
        host->warn(in, "a sphere without a centre stands about the origin");
        radius = centre.x;
        centre = zero;
    }
    parsed->centre = centre;
    parsed->radius = common_radius_of(host, in, radius);
}

static void prepare(void *self, const void *written)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    const sphere_parsed *parsed = written;
    common_sphere *s = self;

    s->centre = pov_two3_of(parsed->centre, zero);
    s->radius = pov_two_of(parsed->radius, 0.0);
}

static void interval(pov_two centre, pov_two radius, double *lo, double *hi)
{
    *lo = common_below(pov_two_sub(centre, radius).hi);
    *hi = common_above(pov_two_add(centre, radius).hi);
}

static bool bounds(const void *self, pov_box *out)
{
    const common_sphere *s = self;

    interval(s->centre.x, s->radius, &out->lo.x, &out->hi.x);
    interval(s->centre.y, s->radius, &out->lo.y, &out->hi.y);
    interval(s->centre.z, s->radius, &out->lo.z, &out->hi.z);
    return true;
}

static bool inside(const void *self, pov_vec3 point, pov_vec3 point_lo)
{
    const common_sphere *s = self;
    pov_two3 w = common_offset(point, point_lo, s->centre, common_sphere_scale(s));

    return pov_two_less(pov_two3_dot(w, w), common_sphere_square(s));
}

static bool absorb(void *self, const pov_affine *map)
{
    common_sphere *s = self;
    pov_two factor;

    if (!common_is_similarity(map, &factor))
        return false;
    s->centre = common_map_point(map, s->centre);
    s->radius = pov_two_mul(s->radius, factor);
    return true;
}

/* Seen from its centre: around the y axis from x to z, and from pole to pole. */
static void uv(const void *self, pov_vec3 point, const pov_mark *mark, double out[2])
{
    const common_sphere *s = self;
    const pov_vec3 zero = { 0.0, 0.0, 0.0 }, p = pov_two3_hi(common_offset(point, zero, s->centre, 1.0));

    (void)mark;
    out[0] = common_whole_turn(p.z, p.x);
    out[1] = 0.5 + 2.0 * common_turn(p.y, sqrt(p.x * p.x + p.z * p.z));
}

static bool outline(const void *self, pov_outline *out)
{
    const common_sphere *s = self;
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    const double inverse = 1.0 / (s->radius.hi * s->radius.hi);
    const pov_outline c = { .centre = pov_two3_hi(s->centre), .square = { inverse, inverse, inverse, 0.0, 0.0, 0.0 },
                           .constant = -1.0, .linear = zero, .round = true };

    *out = c;
    return s->radius.hi > 0.0;
}

static const pov_shape_fast sphere_fast = {
    .size = sizeof(pov_shape_fast),
    .full_leaves = true,
    .block_size = sizeof(common_sphere_block),
    .block_pack = common_sphere_pack,
    .block_filter = common_sphere_filter,
    .intersect_many = common_sphere_intersect_many,
    .cross_sure = common_sphere_cross_sure,
    .normal_many = common_sphere_normal_many,
    .normal_at_many = common_sphere_normal_at_many,
    .outline = outline,
};

static const void *extension(const char *name) { return common_is_fast(name) ? &sphere_fast : NULL; }

static const pov_shape_class sphere_class = {
    .size = sizeof(pov_shape_class),
    .flags = POV_SHAPE_SOLID | POV_SHAPE_CONVEX | POV_SHAPE_SPHERE | POV_SHAPE_CERTIFIED,
    .keyword = "sphere",
    .instance_size = sizeof(common_sphere),
    .parse = parse,
    .bounds = bounds,
    .intersect = common_sphere_intersect,
    .normal = common_sphere_normal,
    .inside = inside,
    .absorb = absorb,
    .parsed_size = sizeof(sphere_parsed),
    .prepare = prepare,
    .uv = uv,
    .extension = extension,
};

static const pov_shape_class *const shapes[] = { &sphere_class, NULL };

POV_PLUGIN(sphere) = {
    .abi = POV_PLUGIN_ABI,
    .size = sizeof(pov_plugin),
    .name = "sphere",
    .version = "1",
    .shapes = shapes,
};
