#include "support/tiny.h"

#include "base/vec.h"
#include "support/near.h"

#include <string.h>

typedef struct sphere { pov_vec3 centre; double radius; } sphere;
typedef struct wall { pov_vec3 normal; double d; } wall;

static const pov_mark no_mark;

static bool sphere_bounds(const void *self, pov_box *out)
{
    const sphere *b = self;
    double r = b->radius * 1.0000001;

    out->lo = pov_sub(b->centre, pov_vec3_of(r, r, r));
    out->hi = pov_add(b->centre, pov_vec3_of(r, r, r));
    return true;
}

/* A ray starts on the root nearer to its start. */
static void sphere_intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const sphere *s = self;
    pov_vec3 o = pov_add(pov_sub(ray->org, s->centre), ray->org_lo);
    double a = pov_dot(ray->dir, ray->dir), b = pov_dot(o, ray->dir), c = pov_dot(o, o) - s->radius * s->radius;
    double root = b * b - a * c, near, far;
    bool left = ray->origin_surface == hits->owner;

    if (root < 0.0)
        return;
    near = (-b - sqrt(root)) / a;
    far = (-b + sqrt(root)) / a;
    if (!(left && fabs(near) <= fabs(far)) && !pov_cross(hits, near, 0.0, no_mark))
        return;
    if (!(left && fabs(far) < fabs(near)))
        pov_cross(hits, far, 0.0, no_mark);
}

static void sphere_normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    const sphere *b = self;

    *out = pov_unit(pov_sub(pov_add(ray->org, pov_scale(ray->dir, at->t)), b->centre));
}

static bool sphere_inside(const void *self, pov_vec3 point, pov_vec3 point_lo)
{
    const sphere *b = self;
    pov_vec3 o = pov_add(pov_sub(point, b->centre), point_lo);

    return pov_dot(o, o) < b->radius * b->radius;
}

static const shape_class sphere_class = {  .flags = POV_SHAPE_SOLID, .keyword = "ball", .instance_size = sizeof(sphere),
    .bounds = sphere_bounds, .intersect = sphere_intersect, .normal = sphere_normal, .inside = sphere_inside,
};

static bool wall_bounds(const void *self, pov_box *out)
{
    (void)self;
    (void)out;
    return false;
}

static void wall_intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const wall *w = self;
    double along = pov_dot(w->normal, ray->dir);

    if (along != 0.0 && ray->origin_surface != hits->owner)
        pov_cross(hits, (w->d - pov_dot(w->normal, ray->org)) / along, 0.0, no_mark);
}

static void wall_normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    (void)ray;
    (void)at;
    *out = ((const wall *)self)->normal;
}

static const shape_class wall_class = {  .keyword = "wall", .instance_size = sizeof(wall),
    .bounds = wall_bounds, .intersect = wall_intersect, .normal = wall_normal,
};

void tiny_begin(tiny *s, const pov_allocator *memory)
{
    pov_camera camera = POV_INIT(camera);

    memset(s, 0, sizeof *s);
    env_init(&s->env, memory, NULL, NULL);
    model_init(&s->model, &s->env);
    camera.direction = pov_vec3_of(0.0, 0.0, 1.0);
    camera.right = pov_vec3_of(1.0, 0.0, 0.0);
    camera.up = pov_vec3_of(0.0, 1.0, 0.0);
    s->model.camera = camera;
    s->model.ambient_light = colour_of(1.0f, 1.0f, 1.0f);
    s->model.max_trace_level = 5;
    s->model.adc_bailout = 1.0 / 255.0;
    s->model.gamma.decode = 1.0;
}

void tiny_end(tiny *s)
{
    tracer_destroy(s->tracer);
    shading_destroy(s->shading);
    world_destroy(s->world);
    model_free(&s->model);
}

material tiny_matt(void)
{
    material m;

    material_init(&m);
    m.pigment = colour_of(1.0f, 1.0f, 1.0f);
    m.finish.ambient = colour_of(0.0f, 0.0f, 0.0f);
    return m;
}

material tiny_emitted(float r, float g, float b)
{
    material m = tiny_matt();

    m.pigment = colour_of(r, g, b);
    m.finish.ambient = colour_of(1.0f, 1.0f, 1.0f);
    m.finish.diffuse = 0.0f;
    return m;
}

material tiny_glass(double ior)
{
    material m = tiny_matt();

    m.finish.diffuse = 0.0f;
    m.transmit = 1.0f;
    m.interior.given = true;
    m.interior.ior = ior;
    return m;
}

void tiny_add(tiny *s, const shape_class *shape, const void *instance, material m)
{
    leaf_node o = { .shape = shape, .material = (uint32_t)s->model.materials.count, .line = 1, .column = 1 };

    o.instance = arena_alloc(&s->model.memory, shape->instance_size, 32);
    assert_non_null(o.instance);
    memcpy(o.instance, instance, shape->instance_size);
    assert_true(VEC_PUSH(&s->env, &s->model.materials, m));
    assert_true(VEC_PUSH(&s->env, &s->model.leaves, o));
}

void tiny_sphere(tiny *s, double x, double y, double z, double radius, material m)
{
    sphere b = { { x, y, z }, radius };

    tiny_add(s, &sphere_class, &b, m);
}

void tiny_plane(tiny *s, double x, double y, double z, double d, material m)
{
    wall w = { { x, y, z }, d };

    tiny_add(s, &wall_class, &w, m);
}

void tiny_light(tiny *s, double x, double y, double z, float r, float g, float b)
{
    light l = { .position = { x, y, z }, .color = { r, g, b } };

    assert_true(VEC_PUSH(&s->env, &s->model.lights, l));
}

void tiny_build(tiny *s)
{
    world_options options = { .threads = 1 };

    assert_int_equal(world_create(&s->world, &s->model, &options, NULL), POV_OK);
    assert_int_equal(shading_create(&s->shading, &s->model, s->world, NULL), POV_OK);
    assert_int_equal(tracer_create(&s->tracer, s->shading, NULL), POV_OK);
}

colour tiny_trace(tiny *s, pov_vec3 from, double x, double y, double z)
{
    pov_ray ray = { .org = from, .dir = { x, y, z }, .origin_surface = POV_NO_OWNER };
    colour c = tracer_color(s->tracer, &ray);

    assert_false(s->tracer->context.failed);
    return c;
}

void assert_colour(colour c, double r, double g, double b, double tolerance)
{
    assert_near(c.r, r, tolerance);
    assert_near(c.g, g, tolerance);
    assert_near(c.b, b, tolerance);
}
