/* sphere { <centre>, radius } */
#include "kit/affine.h"
#include "kit/ball_block.h"

typedef struct sphere_text { pov_vec3 centre; double radius; } sphere_text;

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    sphere_text *text = self;
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
    if (radius < 0.0) {
        host->warn(in, "a negative radius is taken as positive");
        radius = -radius;
    }
    text->centre = centre;
    text->radius = radius;
}

static void prepare(void *self, const void *written)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    const sphere_text *text = written;
    kit_ball *s = self;

    s->centre = pov_two3_of(text->centre, zero);
    s->radius = pov_two_of(text->radius, 0.0);
}

static void interval(pov_two centre, pov_two radius, double *lo, double *hi)
{
    *lo = kit_below(pov_two_sub(centre, radius).hi);
    *hi = kit_above(pov_two_add(centre, radius).hi);
}

static bool bounds(const void *self, pov_box *out)
{
    const kit_ball *s = self;

    interval(s->centre.x, s->radius, &out->lo.x, &out->hi.x);
    interval(s->centre.y, s->radius, &out->lo.y, &out->hi.y);
    interval(s->centre.z, s->radius, &out->lo.z, &out->hi.z);
    return true;
}

static bool inside(const void *self, pov_vec3 point, pov_vec3 point_lo)
{
    const kit_ball *s = self;
    pov_two3 w = kit_offset(point, point_lo, s->centre, kit_ball_scale(s));

    return pov_two_less(pov_two3_dot(w, w), kit_ball_square(s));
}

static bool absorb(void *self, const pov_affine *map)
{
    kit_ball *s = self;
    pov_two factor;

    if (!kit_is_similarity(map, &factor))
        return false;
    s->centre = kit_map_point(map, s->centre);
    s->radius = pov_two_mul(s->radius, factor);
    return true;
}

static const pov_shape_fast sphere_fast = {
    .size = sizeof(pov_shape_fast),
    .full_leaves = true,
    .block_size = sizeof(kit_ball_block),
    .block_pack = kit_ball_pack,
    .block_filter = kit_ball_filter,
    .intersect_many = kit_ball_intersect_many,
    .normal_many = kit_ball_normal_many,
};

static const void *extension(const char *name) { return kit_is_fast(name) ? &sphere_fast : NULL; }

static const pov_shape_class sphere_class = {
    .size = sizeof(pov_shape_class),
    .flags = POV_SHAPE_SOLID | POV_SHAPE_CONVEX | POV_SHAPE_BALL | POV_SHAPE_CERTIFIED,
    .keyword = "sphere",
    .instance_size = sizeof(kit_ball),
    .parse = parse,
    .bounds = bounds,
    .intersect = kit_ball_intersect,
    .normal = kit_ball_normal,
    .inside = inside,
    .absorb = absorb,
    .parsed_size = sizeof(sphere_text),
    .prepare = prepare,
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
