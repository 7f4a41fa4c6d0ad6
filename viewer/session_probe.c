#include "session_state.h"

/* Rays of a grid over the picture, and of one close to the pointer for objects that it misses. Who is near sees little of
 * an object: it is looked at again from further back. */
enum { ACROSS = 32, DOWN = 24, ROUNDS = 8 };

static bool hit_at(const session *s, const pov_camera *camera, double x, double y, pov_hit *hit)
{
    pov_vec3 org, dir;

    return s->tracer && pov_camera_ray(camera, x - 0.5, 0.5 - y, &org, &dir) && pov_trace_hit(s->tracer, org, dir, hit);
}

double session_probe(void *user, double x, double y)
{
    const session *s = user;
    pov_camera camera = app_camera(s->app);
    pov_hit hit = POV_INIT(hit);

    return hit_at(s, &camera, x, y, &hit) ? hit.distance : 0.0;
}

static void widen(pov_box *box, pov_vec3 p)
{
    box->lo = pov_vec3_of(fmin(box->lo.x, p.x), fmin(box->lo.y, p.y), fmin(box->lo.z, p.z));
    box->hi = pov_vec3_of(fmax(box->hi.x, p.x), fmax(box->hi.y, p.y), fmax(box->hi.z, p.z));
}

/* Widen the box by what rays of a grid, whose middle and size are in parts of the picture, see of the object. */
static void look_for(const session *s, const pov_camera *camera, uint32_t object, double x, double y, double size, pov_box *box)
{
    pov_hit hit = POV_INIT(hit);

    for (int i = 0; i < ACROSS * DOWN; i++) {
        double right = (i % ACROSS + 0.5) / ACROSS - 0.5, down = ((double)(i / ACROSS) + 0.5) / DOWN - 0.5;

        if (hit_at(s, camera, x + size * right, y + size * down, &hit) && hit.object == object)
            widen(box, hit.point);
    }
}

static pov_box around(pov_vec3 middle, double half)
{
    pov_vec3 away = pov_vec3_of(half, half, half);

    return (pov_box){ pov_sub(middle, away), pov_add(middle, away) };
}

/* Step back until the object is whole. */
static void step_back(const session *s, uint32_t object, pov_box *box)
{
    const double hardly = 1.02;
    orbit from = s->app->orbit;
    double before = 0.0, after = pov_largest(pov_sub(box->hi, box->lo));

    for (int i = 0; i < ROUNDS && after > hardly * before && orbit_frame(&from, box); i++) {
        pov_camera camera = orbit_camera(&from);

        look_for(s, &camera, object, 0.5, 0.5, 1.0, box);
        before = after;
        after = pov_largest(pov_sub(box->hi, box->lo));
    }
}

/* An object without an end, or one beside which the scene is small, has no extent to show: a part of it has. */
bool session_extent(void *user, double x, double y, pov_box *out)
{
    const double least = 0.01, part = 0.25;
    const session *s = user;
    pov_camera camera = app_camera(s->app);
    pov_hit hit = POV_INIT(hit);
    uint32_t object;
    pov_vec3 first;
    double far;

    if (!hit_at(s, &camera, x, y, &hit))
        return false;
    object = hit.object;
    first = hit.point;
    far = hit.distance * sqrt(pov_dot(camera.direction, camera.direction));
    *out = around(first, least * far);
    look_for(s, &camera, object, 0.5, 0.5, 1.0, out);
    look_for(s, &camera, object, x, y, 1.0 / DOWN, out);
    step_back(s, object, out);
    if (!(pov_largest(pov_sub(out->hi, out->lo)) <= 2.0 * s->app->size))
        *out = around(first, part * far);
    return true;
}

double session_measure(const pov_scene *scene, const pov_camera *c, double *reach)
{
    double along = pov_dot(c->direction, c->direction), size;
    pov_vec3 middle, across;
    pov_box box;

    if (!pov_scene_get_bounds(scene, &box))
        return 10.0 * sqrt(along);
    across = pov_sub(box.hi, box.lo);
    size = sqrt(pov_dot(across, across));
    middle = pov_add(box.lo, pov_scale(across, 0.5));
    if (!(*reach > 0.0))
        *reach = pov_dot(pov_sub(middle, c->location), c->direction) / along;
    if (!(*reach > 0.0))
        *reach = size / sqrt(along);
    return size;
}
