#include "support/shapes.h"

#include "support/check.h"

#include "base/vec.h"

#include <povtrace/exact.h>

#include <string.h>

/* ---- spheres ---- */

static bool sphere_bounds(const void *self, pov_box *out)
{
    const test_sphere_shape *b = self;
    double r = b->radius;

    out->lo = pov_vec3_of(nextafter(b->centre.x - r, -HUGE_VAL), nextafter(b->centre.y - r, -HUGE_VAL),
                          nextafter(b->centre.z - r, -HUGE_VAL));
    out->hi = pov_vec3_of(nextafter(b->centre.x + r, HUGE_VAL), nextafter(b->centre.y + r, HUGE_VAL),
                          nextafter(b->centre.z + r, HUGE_VAL));
    return true;
}

static pov_two3 sphere_centred(const test_sphere_shape *b, const pov_ray *ray, double t)
{
    pov_two3 w;

    w.x = pov_two_add(pov_recentre(ray->org.x, ray->org_lo.x, b->centre.x, t, ray->dir.x),
                      pov_two_product(t, ray->dir_lo.x));
    w.y = pov_two_add(pov_recentre(ray->org.y, ray->org_lo.y, b->centre.y, t, ray->dir.y),
                      pov_two_product(t, ray->dir_lo.y));
    w.z = pov_two_add(pov_recentre(ray->org.z, ray->org_lo.z, b->centre.z, t, ray->dir.z),
                      pov_two_product(t, ray->dir_lo.z));
    return w;
}

static pov_two3 scaled(pov_two3 v, double s)
{
    v.x = pov_two_of(v.x.hi * s, v.x.lo * s);
    v.y = pov_two_of(v.y.hi * s, v.y.lo * s);
    v.z = pov_two_of(v.z.hi * s, v.z.lo * s);
    return v;
}

/* The power of two that scales x near 1. */
static double unscale(double x)
{
    int e;

    frexp(x, &e);
    return ldexp(1.0, -e);
}

/* All in double-double, in units of the radius and of the direction's length. For a ray that leaves the sphere, the
 * root nearer to its start is left out. */
static void sphere_intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const test_sphere_shape *b = self;
    double size = pov_largest(ray->dir), by = unscale(b->radius > 0.0 ? b->radius : 1.0), faster = unscale(size), tc;
    pov_vec3 unit = pov_scale(ray->dir, 1.0 / size);
    pov_two3 w, d = scaled(pov_two3_of(ray->dir, ray->dir_lo), faster);
    pov_two a, h, c, discriminant, root, t[2];
    pov_mark mark = { 0, POV_MARK_CLOSED, 0.0, 0.0 };
    int i, left = -1;

    tc = -pov_dot(pov_sub(ray->org, b->centre), unit) / pov_dot(unit, unit) / size;
    if (!(fabs(tc) < 1e250))
        return;
    w = scaled(sphere_centred(b, ray, tc), by);
    if (!(pov_largest(pov_two3_hi(w)) < 1e50))
        return;
    a = pov_two3_dot(d, d);
    h = pov_two3_dot(w, d);
    c = pov_two_sub(pov_two3_dot(w, w), pov_two_product(b->radius * by, b->radius * by));
    discriminant = pov_two_sub(pov_two_mul(h, h), pov_two_mul(a, c));
    if (discriminant.hi < 0.0)
        return;
    root = pov_two_sqrt(discriminant);
    t[0] = pov_two_div(pov_two_neg(pov_two_add(h, root)), a);
    t[1] = pov_two_div(pov_two_sub(root, h), a);
    for (i = 0; i < 2; i++)
        t[i] = pov_two_add_double(pov_two_of(t[i].hi / by * faster, t[i].lo / by * faster), tc);
    if (ray->origin_surface == hits->owner)
        left = fabs(t[1].hi) < fabs(t[0].hi);
    for (i = 0; i < 2; i++) {
        mark.feature = (uint32_t)i;
        if (i != left && !pov_cross(hits, t[i].hi, t[i].lo, mark))
            return;
    }
}

static void sphere_normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    const test_sphere_shape *b = self;
    pov_two3 w = sphere_centred(b, ray, at->t);

    *out = pov_unit(
        pov_vec3_of(w.x.hi + at->t_lo * ray->dir.x, w.y.hi + at->t_lo * ray->dir.y, w.z.hi + at->t_lo * ray->dir.z));
}

static void sphere_intersect_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits,
                                  uint32_t n)
{
    uint32_t i;

    for (i = 0; i < n; i++)
        sphere_intersect(selves[i], rays[i], hits[i]);
}

static void sphere_normal_many(const void *const *selves, const pov_ray *const *rays, const pov_crossing *const *at,
                               pov_vec3 *const *out, uint32_t n)
{
    uint32_t i;

    for (i = 0; i < n; i++)
        sphere_normal(selves[i], rays[i], at[i], out[i]);
}

static bool sphere_inside(const void *self, pov_vec3 p, pov_vec3 lo)
{
    const test_sphere_shape *b = self;
    pov_two3 w;

    w.x = pov_two_add_double(pov_two_sum(p.x, -b->centre.x), lo.x);
    w.y = pov_two_add_double(pov_two_sum(p.y, -b->centre.y), lo.y);
    w.z = pov_two_add_double(pov_two_sum(p.z, -b->centre.z), lo.z);
    return pov_two_less(pov_two3_dot(w, w), pov_two_product(b->radius, b->radius));
}

/* Translation, or scaling by the same factor along each axis. */
static bool sphere_absorb(void *self, const pov_affine *map)
{
    test_sphere_shape *b = self;
    double s = map->m[0][0];
    pov_two p[3];
    int i, j;

    for (i = 0; i < 3; i++)
        for (j = 0; j < 3; j++)
            if (map->m_lo[i][j] != 0.0 || map->m[i][j] != (i == j ? s : 0.0))
                return false;
    p[0] = pov_two_add_double(pov_two_product(s, b->centre.x), map->m[0][3]);
    p[1] = pov_two_add_double(pov_two_product(s, b->centre.y), map->m[1][3]);
    p[2] = pov_two_add_double(pov_two_product(s, b->centre.z), map->m[2][3]);
    if (p[0].lo != 0.0 || p[1].lo != 0.0 || p[2].lo != 0.0 || map->m_lo[0][3] != 0.0 || map->m_lo[1][3] != 0.0 ||
        map->m_lo[2][3] != 0.0)
        return false;
    b->centre = pov_vec3_of(p[0].hi, p[1].hi, p[2].hi);
    b->radius *= fabs(s);
    return true;
}

typedef struct sphere_block { uint32_t count; test_sphere_shape sphere[POV_BLOCK_MAX]; } sphere_block;

/* Very large spheres are declined, so that one class with and without blocks is tested too. */
static bool sphere_pack(void *block, const pov_frame *frame, const void *const *selves, uint32_t n)
{
    sphere_block *b = block;
    uint32_t i;

    (void)frame;
    b->count = n;
    for (i = 0; i < n; i++) {
        b->sphere[i] = *(const test_sphere_shape *)selves[i];
        if (b->sphere[i].radius > 1e20)
            return false;
    }
    return true;
}

/* In doubles, with wide bounds. False: definite miss. */
static bool test_sphere(const test_sphere_shape *sphere, pov_vec3 org, pov_vec3 dir, double tmax, pov_candidate *out)
{
    const double length = sqrt(pov_dot(dir, dir));
    pov_vec3 f = pov_sub(sphere->centre, org), w;
    double along = pov_dot(f, dir) / length, error, depth, half;

    w = pov_sub(f, pov_scale(dir, along / length));
    error = 1e-12 * (fabs(along) + pov_largest(f) + sphere->radius) + 1e-15 * pov_largest(org);
    depth = (sphere->radius + error) * (sphere->radius + error) - pov_dot(w, w);
    out->definite = out->definite_pair = false;
    out->lo = 0.0;
    if (!(along < 1e150 && along > -1e150 && length > 1e-150 && length < 1e150))
        return true;
    if (depth < -error * error || along + sphere->radius + error < 0.0 ||
        along - sphere->radius - error > tmax * length)
        return false;
    half = sqrt(fmax(depth, 0.0));
    out->lo = (along - half - error) / length;
    depth = (sphere->radius - error) * (sphere->radius - error) - pov_dot(w, w);
    if (depth <= 0.0 || sphere->radius <= error)
        return true;
    out->hi = (along - sqrt(depth) + error) / length;
    out->definite = out->lo > 0.0 && out->hi < tmax;
    out->definite_pair = out->definite && (along + half + error) / length < tmax;
    return true;
}

static uint32_t sphere_filter(const void *block, const uint32_t *owners, const pov_rays *rays, uint64_t lanes,
                              pov_candidate *out)
{
    const sphere_block *b = block;
    uint32_t n = 0, at, i;

    (void)owners;
    for (at = 0; at < POV_RAYS_MAX; at++) {
        const pov_vec3 org = pov_vec3_of(rays->org[0][at], rays->org[1][at], rays->org[2][at]);
        const pov_vec3 dir = pov_vec3_of(rays->dir[0][at], rays->dir[1][at], rays->dir[2][at]);

        for (i = 0; (lanes >> at & 1) && i < b->count; i++)
            if (test_sphere(&b->sphere[i], org, dir, rays->tmax[at], &out[n])) {
                out[n].ray = (uint8_t)at;
                out[n++].lane = (uint8_t)i;
            }
    }
    return n;
}

const shape_class test_sphere_class = {
    .flags = POV_SHAPE_SOLID,
    .full_leaves = true,
    .keyword = "ball",
    .instance_size = sizeof(test_sphere_shape),
    .bounds = sphere_bounds,
    .intersect = sphere_intersect,
    .normal = sphere_normal,
    .inside = sphere_inside,
    .absorb = sphere_absorb,
    .block_size = sizeof(sphere_block),
    .block_pack = sphere_pack,
    .block_filter = sphere_filter,
    .intersect_many = sphere_intersect_many,
    .normal_many = sphere_normal_many,
};

static bool no_bounds(const void *self, pov_box *out)
{
    (void)self;
    (void)out;
    return false;
}

const shape_class test_loose_sphere_class = {
    .flags = POV_SHAPE_SOLID,
    .keyword = "loose_ball",
    .instance_size = sizeof(test_sphere_shape),
    .bounds = no_bounds,
    .intersect = sphere_intersect,
    .normal = sphere_normal,
    .inside = sphere_inside,
    .block_size = sizeof(sphere_block),
    .block_pack = sphere_pack,
    .block_filter = sphere_filter,
};

const shape_class test_plain_sphere_class = {
    .flags = POV_SHAPE_SOLID,
    .keyword = "plain_ball",
    .instance_size = sizeof(test_sphere_shape),
    .bounds = sphere_bounds,
    .intersect = sphere_intersect,
    .normal = sphere_normal,
    .inside = sphere_inside,
};

/* ---- bricks ---- */

static bool brick_bounds(const void *self, pov_box *out)
{
    const test_brick *b = self;

    out->lo = b->lo;
    out->hi = b->hi;
    return true;
}

/* Clip the interval to the slab; false: miss. In double-double, so that far rays hit and miss correctly. */
static bool slab(double o, double o_lo, double d, double lo, double hi, int axis, pov_two t[2], int face[2])
{
    pov_two to_lo = pov_two_add_double(pov_two_sum(lo, -o), -o_lo),
            to_hi = pov_two_add_double(pov_two_sum(hi, -o), -o_lo);
    pov_two a, b, swap;

    if (d == 0.0)
        return to_lo.hi < 0.0 && to_hi.hi > 0.0;
    a = pov_two_div(to_lo, pov_two_of(d, 0.0));
    b = pov_two_div(to_hi, pov_two_of(d, 0.0));
    if (pov_two_less(b, a)) {
        swap = a;
        a = b;
        b = swap;
    }
    if (pov_two_less(t[0], a)) {
        t[0] = a;
        face[0] = axis;
    }
    if (pov_two_less(b, t[1])) {
        t[1] = b;
        face[1] = axis;
    }
    return pov_two_less(t[0], t[1]);
}

static void brick_intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const test_brick *b = self;
    pov_two t[2] = { { -1e300, 0.0 }, { 1e300, 0.0 } };
    pov_mark mark = { 0, POV_MARK_CLOSED, 0.0, 0.0 };
    int face[2] = { 0, 0 }, i, left = -1;
    double by = unscale(pov_largest(ray->dir));
    pov_vec3 d = pov_scale(ray->dir, by);

    if (!slab(ray->org.x, ray->org_lo.x, d.x, b->lo.x, b->hi.x, 0, t, face) ||
        !slab(ray->org.y, ray->org_lo.y, d.y, b->lo.y, b->hi.y, 1, t, face) ||
        !slab(ray->org.z, ray->org_lo.z, d.z, b->lo.z, b->hi.z, 2, t, face))
        return;
    if (ray->origin_surface == hits->owner)
        left = fabs(t[1].hi) < fabs(t[0].hi);
    for (i = 0; i < 2; i++) {
        mark.feature = (uint32_t)face[i];
        if (i != left && !pov_cross(hits, t[i].hi * by, t[i].lo * by, mark))
            return;
    }
}

static void brick_normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    const test_brick *b = self;
    double p[3], lo[3] = {b->lo.x, b->lo.y, b->lo.z}, hi[3] = {b->hi.x, b->hi.y, b->hi.z}, n[3] = {0.0, 0.0, 0.0};
    uint32_t axis = at->mark.feature;

    p[0] = ray->org.x + at->t * ray->dir.x;
    p[1] = ray->org.y + at->t * ray->dir.y;
    p[2] = ray->org.z + at->t * ray->dir.z;
    n[axis] = p[axis] > 0.5 * lo[axis] + 0.5 * hi[axis] ? 1.0 : -1.0;
    *out = pov_vec3_of(n[0], n[1], n[2]);
}

static bool brick_inside(const void *self, pov_vec3 p, pov_vec3 lo)
{
    const test_brick *b = self;

    return (p.x - b->lo.x) + lo.x > 0.0 && (p.x - b->hi.x) + lo.x < 0.0 && (p.y - b->lo.y) + lo.y > 0.0 &&
           (p.y - b->hi.y) + lo.y < 0.0 && (p.z - b->lo.z) + lo.z > 0.0 && (p.z - b->hi.z) + lo.z < 0.0;
}

const shape_class test_brick_class = {
    .flags = POV_SHAPE_SOLID,
    .keyword = "brick",
    .instance_size = sizeof(test_brick),
    .bounds = brick_bounds,
    .intersect = brick_intersect,
    .normal = brick_normal,
    .inside = brick_inside,
};

/* ---- the ground ---- */

static bool ground_bounds(const void *self, pov_box *out)
{
    (void)self;
    (void)out;
    return false;
}

static void ground_intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const test_ground *g = self;
    pov_mark mark = { 0, 0, 0.0, 0.0 };

    if (ray->dir.y != 0.0 && ray->origin_surface != hits->owner)
        pov_cross(hits, ((g->height - ray->org.y) - ray->org_lo.y) / ray->dir.y, 0.0, mark);
}

static void ground_normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    (void)self;
    (void)ray;
    (void)at;
    *out = pov_vec3_of(0.0, 1.0, 0.0);
}

static bool ground_inside(const void *self, pov_vec3 p, pov_vec3 lo)
{
    const test_ground *g = self;

    return (p.y - g->height) + lo.y < 0.0;
}

const shape_class test_ground_class = {
    .flags = POV_SHAPE_SOLID,
    .keyword = "ground",
    .instance_size = sizeof(test_ground),
    .bounds = ground_bounds,
    .intersect = ground_intersect,
    .normal = ground_normal,
    .inside = ground_inside,
};

/* ---- random numbers (splitmix64) ---- */

static uint64_t next(test_random *r)
{
    uint64_t z = (r->state += 0x9e3779b97f4a7c15u);

    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

double test_uniform(test_random *r, double lo, double hi)
{
    return lo + (hi - lo) * (double)(next(r) >> 11) * 0x1p-53;
}

uint32_t test_below(test_random *r, uint32_t n)
{
    return (uint32_t)(next(r) % n);
}

pov_vec3 test_direction(test_random *r)
{
    pov_vec3 d;

    do {
        d.x = test_uniform(r, -1.0, 1.0);
        d.y = test_uniform(r, -1.0, 1.0);
        d.z = test_uniform(r, -1.0, 1.0);
    } while (pov_dot(d, d) > 1.0 || pov_dot(d, d) < 0.01);
    return d;
}

/* ---- models ---- */

static env malloc_env;

void test_leave(pov_ray *ray, const hit *h)
{
    const double rise = pov_dot(pov_unit(ray->dir), h->normal);

    if ((rise > 0.0) == h->entering)
        world_origin_reflect(ray, h, fabs(rise));
    else
        world_origin_transmit(ray, h, fabs(rise));
}

bool test_nearest(const world *w, query_context *k, const pov_ray *ray, double tmax, hit *out)
{
    const bool found = query_nearest(w, k, &ray, 1, tmax, out) != 0;

    if (!found)
        out->object = POV_NO_OWNER;
    return found;
}

bool test_light(const world *w, query_context *k, const pov_ray *ray, double tmax, uint32_t owners[TEST_CROSSINGS],
                uint32_t *count)
{
    occlusion found;
    const bool open = query_occlusion(w, k, &ray, 1, tmax, &found) != 0;

    *count = found.crossed ? found.count[0] : 0;
    for (uint32_t i = 0; i < TEST_CROSSINGS; i++)
        owners[i] = i < *count ? found.at[0][i].owner : POV_NO_OWNER;
    return open;
}

void test_model_init(model *m, const env *e)
{
    env_init(&malloc_env, NULL, NULL, NULL);
    model_init(m, e ? e : &malloc_env);
    m->dialect = POV_DIALECT_POVRAY;
    m->dialect_reason = "a test";
    m->max_trace_level = 5;
    test_add_material(m, colour_of(1.0f, 1.0f, 1.0f), 0.0f, 0.0f, false);
}

uint32_t test_add_material(model *m, colour c, float filter, float transmit, bool has_interior)
{
    material s;

    material_init(&s);
    s.pigment = c;
    s.filter = filter;
    s.transmit = transmit;
    s.interior.given = has_interior;
    s.interior.ior = has_interior ? 1.5 : 1.0;
    assert_true(VEC_PUSH(m->env, &m->materials, s));
    return (uint32_t)m->materials.count - 1;
}

void test_add_light(model *m, float brightness)
{
    light lamp;

    memset(&lamp, 0, sizeof lamp);
    lamp.position = pov_vec3_of(0.0, 9.0, 0.0);
    lamp.color = colour_of(brightness, brightness, brightness);
    assert_true(VEC_PUSH(m->env, &m->lights, lamp));
}

uint32_t test_add(model *m, const shape_class *shape, const void *instance, const transform *map, uint32_t surface,
                  uint32_t flags)
{
    leaf_node o;

    memset(&o, 0, sizeof o);
    o.shape = shape;
    o.instance = arena_alloc(&m->memory, shape->instance_size, 32);
    assert_non_null(o.instance);
    memcpy(o.instance, instance, shape->instance_size);
    o.map = map;
    o.material = surface;
    o.flags = flags;
    assert_true(VEC_PUSH(m->env, &m->leaves, o));
    return (uint32_t)m->leaves.count - 1;
}

uint32_t test_add_sphere(model *m, pov_vec3 centre, double radius, uint32_t surface)
{
    test_sphere_shape b = { centre, radius };
    return test_add(m, &test_sphere_class, &b, NULL, surface, 0);
}

const transform *test_transform(model *m, const transform *before, transform_kind kind, double x, double y, double z)
{
    double v[3] = { x, y, z };
    return transform_append(&m->maps, before, kind, v);
}
