/* torus { major, minor }: around the y axis: (p.p + R^2 - r^2)^2 = 4 R^2 (x^2 + z^2), negative inside.
 *
 * Along a ray this is a quartic. It is taken about the point of the ray that is nearest to the centre, over the stretch
 * within the sphere around the torus, so that distance changes nothing. Its roots are isolated with certainty and
 * completed in double-double. On a ray that starts on the torus that root is divided out. Of a spindle (r > R) the
 * outer sheet alone is the surface: what it holds is inside, and no ray meets the inner one. Without R that is a sphere, which
 * has two equal sheets and so a kernel of its own. */
#include "common/radius.h"
#include "common/narrow.h"
#include "common/torus.h"
#include "common/turns.h"

/* ---- loading ---- */

static void find_kind(torus *t, const pov_host *host, pov_reader *in)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };

    if (!(t->minor > 0.0)) {
        t->kind = TORUS_CIRCLE;
        host->warn(in, "the second radius of this torus is 0: it is not seen");
    } else if (!(t->major > 0.0)) {
        t->kind = TORUS_SPHERE;
        host->warn(in, "the first radius of this torus is 0: it is a sphere");
    }
    t->sphere.centre = pov_two3_of(zero, zero);
    t->sphere.radius = pov_two_of(t->minor, 0.0);
}

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    torus *t = self;
    pov_two minor_square;

    t->major = common_radius(host, in);
    host->accept(in, ",");
    t->minor = common_radius(host, in);
    if (host->accept(in, "sturm") && host->more(in))
        host->boolean(in);
    find_kind(t, host, in);
    t->scale = pov_inverse_power(pov_max(t->major, t->minor));
    t->R = t->major * t->scale;
    t->r = t->minor * t->scale;
    minor_square = pov_two_product(t->r, t->r);
    t->ring = pov_two_product(t->R, t->R);
    t->hollow = pov_two_sub(t->ring, minor_square);
    t->lens = pov_two_neg(t->hollow);
}

static bool bounds(const void *self, pov_box *out)
{
    const torus *t = self;
    const double reach = common_above(t->major + t->minor), high = t->minor;

    out->lo = pov_vec3_of(-reach, -high, -reach);
    out->hi = pov_vec3_of(reach, high, reach);
    return true;
}

/* ---- the surface ---- */

static void intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const torus *t = self;

    if (t->kind == TORUS_RING)
        common_torus_intersect(t, ray, hits);
    else if (t->kind == TORUS_SPHERE)
        common_sphere_intersect(&t->sphere, ray, hits);
}

static void normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    const torus *t = self;

    if (t->kind == TORUS_SPHERE)
        common_sphere_normal(&t->sphere, ray, at, out);
    else
        common_torus_normal(t, ray, at, out);
}

static bool are_rings(const void *const *selves, uint32_t n)
{
    while (n > 0 && ((const torus *)selves[n - 1])->kind == TORUS_RING)
        n--;
    return n == 0;
}

static void intersect_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    if (are_rings(selves, n)) {
        common_torus_intersect_many(selves, rays, hits, n);
        return;
    }
    for (uint32_t i = 0; i < n; i++)
        intersect(selves[i], rays[i], hits[i]);
}

static void normal_many(const void *const *selves, const pov_ray *const *rays, const pov_crossing *const *at, pov_vec3 *const *out, uint32_t n)
{
    if (are_rings(selves, n)) {
        common_torus_normal_many(selves, rays, at, out, n);
        return;
    }
    for (uint32_t i = 0; i < n; i++)
        normal(selves[i], rays[i], at[i], out[i]);
}

static uint32_t narrow(const void *self, const pov_own_map *map, uint32_t owner, const pov_rays *rays, pov_candidate *io, uint32_t n)
{
    return ((const torus *)self)->kind == TORUS_RING ? common_torus_narrow(self, map, owner, rays, io, n) : n;
}

/* Doubles tell, unless the point is near the surface: all terms of the equation are off by less than 2^-49 of their sum. */
static bool is_certainly_outside(const torus *t, pov_vec3 p)
{
    const double level = p.x * p.x + p.z * p.z, square = level + p.y * p.y, g = square + t->hollow.hi;
    const double most = square + t->R * t->R + t->r * t->r, ring = 4.0 * t->ring.hi * level;

    return t->lens.hi <= 0.0 && g * g - ring > 0x1p-48 * (most * most + ring);
}

static bool inside(const void *self, pov_vec3 point, pov_vec3 point_lo)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    const torus *t = self;
    const pov_two3 p = common_offset(point, point_lo, pov_two3_of(zero, zero), t->scale);

    return t->kind != TORUS_CIRCLE && !is_certainly_outside(t, pov_two3_hi(p)) && (is_in_lens(t, p) || value_at(t, p).hi <= 0.0);
}

static void uv(const void *self, pov_vec3 point, const pov_mark *mark, double out[2])
{
    const torus *t = self;

    (void)mark;
    out[0] = 0.5 - common_turn(point.z, point.x);
    out[1] = 0.5 + common_turn(point.y, sqrt(point.x * point.x + point.z * point.z) - t->major);
}

static bool ring(const void *self, double radii[2])
{
    const torus *t = self;

    radii[0] = t->major;
    radii[1] = t->minor;
    return t->kind == TORUS_RING && t->major > t->minor;
}

COMMON_NARROW_PACK(narrow)

static const pov_shape_fast torus_fast = {
    .size = sizeof(pov_shape_fast),
    .intersect_many = intersect_many,
    .normal_many = normal_many,
    COMMON_NARROW_BLOCKS(narrow),
    .ring = ring,
    .intersect_between = intersect,
    .intersect_between_many = intersect_many,
};

static const void *extension(const char *name) { return common_is_fast(name) ? &torus_fast : NULL; }

static const pov_shape_class torus_class = {
    .size = sizeof(pov_shape_class),
    .flags = POV_SHAPE_SOLID | POV_SHAPE_CERTIFIED,
    .keyword = "torus",
    .instance_size = sizeof(torus),
    .parse = parse,
    .bounds = bounds,
    .intersect = intersect,
    .normal = normal,
    .inside = inside,
    .uv = uv,
    .extension = extension,
};

static const pov_shape_class *const shapes[] = { &torus_class, NULL };

POV_PLUGIN(torus) = {
    .abi = POV_PLUGIN_ABI,
    .size = sizeof(pov_plugin),
    .name = "torus",
    .version = "1",
    .shapes = shapes,
};
