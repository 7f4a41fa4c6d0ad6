#include "orbit.h"

static const double PI = 3.14159265358979323846;
/* The camera stays at least this far from straight up and down, in radians, so that up stays up. */
static const double STEEPEST = 0.01;

/* ---- vectors ---- */

static double length(pov_vec3 v)
{
    double most = pov_largest(v);

    return most > 0.0 ? most * sqrt(pov_dot(pov_scale(v, 1.0 / most), pov_scale(v, 1.0 / most))) : 0.0;
}

static pov_vec3 with_length(pov_vec3 v, double wanted)
{
    return pov_scale(pov_unit(v), wanted);
}

/* Rodrigues' rotation about a unit axis; with y up from z to x. The length is restored, so that many rotations do not
 * change it. */
static pov_vec3 turned(pov_vec3 v, pov_vec3 axis, double angle)
{
    double c = cos(angle), s = sin(angle);
    pov_vec3 along = pov_scale(axis, pov_dot(axis, v) * (1.0 - c));
    pov_vec3 sum = pov_add(pov_add(pov_scale(v, c), pov_scale(pov_cross_product(axis, v), s)), along);

    return with_length(sum, length(v));
}

static void turn_frame(orbit *o, pov_vec3 axis, double angle)
{
    o->camera.direction = turned(o->camera.direction, axis, angle);
    o->camera.right = turned(o->camera.right, axis, angle);
    o->camera.up = turned(o->camera.up, axis, angle);
}

/* ---- what is up ---- */

/* A camera without roll has `right` perpendicular to the vertical. Of the possible axes y is chosen unless the
 * picture's up hardly points there, else the axis closest to it; a rolled camera has its own up. */
static pov_vec3 find_sky(const pov_camera *c)
{
    const double square = 1e-6, hardly = 0.1;
    const pov_vec3 axes[3] = { pov_vec3_of(0, 1, 0), pov_vec3_of(0, 0, 1), pov_vec3_of(1, 0, 0) };
    pov_vec3 right = pov_unit(c->right), up = pov_unit(c->up), sky = up;
    double most = hardly;

    for (int i = 0; i < 3; i++) {
        double along = pov_dot(up, axes[i]);

        if (fabs(pov_dot(right, axes[i])) > square || fabs(along) <= most)
            continue;
        sky = pov_scale(axes[i], along < 0.0 ? -1.0 : 1.0);
        most = i == 0 ? 1.0 : fabs(along);
    }
    return sky;
}

static double find_mirror(const pov_camera *c)
{
    return pov_dot(pov_cross_product(c->up, c->direction), c->right) < 0.0 ? -1.0 : 1.0;
}

/* The horizontal axis of tilting, from up towards ahead. */
static pov_vec3 tilt_axis(const orbit *o)
{
    pov_vec3 side = pov_cross_product(o->sky, o->camera.direction);

    if (length(side) < 0.01 * STEEPEST * length(o->camera.direction))
        side = pov_scale(o->camera.right, o->mirror);
    return pov_unit(side);
}

/* ---- where it is ---- */

static void go_home(orbit *o)
{
    o->camera = o->home;
    o->reach = o->home_reach;
    o->first_shape = o->home_shape;
    o->sky = find_sky(&o->home);
    o->mirror = find_mirror(&o->home);
    o->moved = false;
}

void orbit_init(orbit *o, const pov_camera *home, double reach, double shape)
{
    o->home = *home;
    o->home_reach = reach > 0.0 ? reach : 1.0;
    o->shape = o->home_shape = shape;
    go_home(o);
}

void orbit_set_home(orbit *o, const pov_camera *home, double reach, double shape)
{
    o->home = *home;
    o->home_reach = reach > 0.0 ? reach : o->home_reach;
    o->home_shape = shape;
    if (!o->moved)
        go_home(o);
}

void orbit_fit(orbit *o, int width, int height)
{
    if (width > 0 && height > 0)
        o->shape = (double)width / height;
}

pov_camera orbit_camera(const orbit *o)
{
    pov_camera c = o->camera;

    if (o->shape != o->first_shape)
        c.right = pov_scale(c.right, o->shape / o->first_shape);
    return c;
}

pov_vec3 orbit_ray(const orbit *o, double x, double y)
{
    pov_camera c = orbit_camera(o);

    return pov_add(c.direction, pov_add(pov_scale(c.right, x - 0.5), pov_scale(c.up, 0.5 - y)));
}

pov_vec3 orbit_pivot(const orbit *o)
{
    return pov_add(o->camera.location, pov_scale(o->camera.direction, o->reach));
}

void orbit_set_reach(orbit *o, double reach)
{
    if (reach > 0.0 && reach < HUGE_VAL)
        o->reach = reach;
}

/* ---- how it moves ---- */

/* Limit a tilt: the camera's angle from the sky stays within the limits, or does not go further out. */
static double allowed_tilt(const orbit *o, double angle)
{
    pov_vec3 ahead = pov_unit(o->camera.direction);
    double from_sky = atan2(length(pov_cross_product(o->sky, ahead)), pov_dot(o->sky, ahead));
    double down_most = PI - STEEPEST - from_sky, up_most = STEEPEST - from_sky;

    if (angle > 0.0)
        return angle < down_most ? angle : down_most > 0.0 ? down_most : 0.0;
    return angle > up_most ? angle : up_most < 0.0 ? up_most : 0.0;
}

/* Rotate by `yaw` about the sky and by `tilt` downwards; positive yaw turns the view to the picture's right. */
static void turn_view(orbit *o, double yaw, double tilt)
{
    turn_frame(o, tilt_axis(o), allowed_tilt(o, tilt));
    turn_frame(o, o->sky, yaw * o->mirror);
    o->moved = true;
}

void orbit_turn(orbit *o, double right, double down)
{
    pov_vec3 pivot = orbit_pivot(o);

    turn_view(o, PI * right * o->shape, PI * down);
    o->camera.location = pov_sub(pivot, pov_scale(o->camera.direction, o->reach));
}

void orbit_pan(orbit *o, double right, double down)
{
    pov_camera c = orbit_camera(o);
    pov_vec3 way = pov_add(pov_scale(c.right, -right), pov_scale(c.up, down));

    o->camera.location = pov_add(o->camera.location, pov_scale(way, o->reach));
    o->moved = true;
}

void orbit_dolly(orbit *o, double x, double y, double reach, double steps)
{
    double left = pow(0.9, steps);
    pov_vec3 ray = orbit_ray(o, x, y);

    if (!(reach > 0.0))
        reach = o->reach;
    o->camera.location = pov_add(o->camera.location, pov_scale(ray, reach * (1.0 - left)));
    o->reach *= left;
    o->moved = true;
}

void orbit_look(orbit *o, double right, double down)
{
    pov_camera c = orbit_camera(o);
    double ahead = length(c.direction);

    turn_view(o, right * 2.0 * atan(0.5 * length(c.right) / ahead), down * 2.0 * atan(0.5 * length(c.up) / ahead));
}

void orbit_fly(orbit *o, double right, double up, double ahead)
{
    const pov_camera *c = &o->camera;
    pov_vec3 across = pov_add(with_length(c->right, right), with_length(c->up, up));

    o->camera.location = pov_add(c->location, pov_add(across, with_length(c->direction, ahead)));
    o->moved = true;
}

/* The axes of front, right and top: z is ahead where y is up, y where z is. */
static void find_axes(const orbit *o, pov_vec3 *ahead, pov_vec3 *side)
{
    pov_vec3 z = pov_vec3_of(0, 0, 1), y = pov_vec3_of(0, 1, 0);
    pov_vec3 axis = fabs(pov_dot(o->sky, z)) < 0.9 ? z : y;

    axis = pov_sub(axis, pov_scale(o->sky, pov_dot(axis, o->sky)));
    *ahead = pov_unit(axis);
    *side = pov_scale(pov_unit(pov_cross_product(o->sky, *ahead)), o->mirror);
}

void orbit_face(orbit *o, orbit_side which)
{
    pov_vec3 pivot = orbit_pivot(o), ahead, side, up = o->sky, view;
    double d = length(o->camera.direction), r = length(o->camera.right), u = length(o->camera.up);

    find_axes(o, &ahead, &side);
    view = ahead;
    if (which == ORBIT_RIGHT) {
        view = pov_scale(side, -1.0);
        side = ahead;
    } else if (which == ORBIT_TOP) {
        view = pov_scale(o->sky, -1.0);
        up = ahead;
    }
    o->camera.direction = pov_scale(view, d);
    o->camera.right = pov_scale(side, r);
    o->camera.up = pov_scale(up, u);
    o->camera.location = pov_sub(pivot, pov_scale(o->camera.direction, o->reach));
    o->moved = true;
}

void orbit_reset(orbit *o)
{
    go_home(o);
}

/* ---- what it sees ---- */

/* How far from the box's middle the camera must be to have a corner in view, and half of the picture that parallel rays
 * need, in its present halves. */
static void fit_corner(const pov_camera *c, pov_vec3 from_middle, double *away, double *part)
{
    double ahead = length(c->direction), across = 0.5 * length(c->right), up = 0.5 * length(c->up);
    double x = fabs(pov_dot(from_middle, pov_unit(c->right))), y = fabs(pov_dot(from_middle, pov_unit(c->up)));
    double depth = pov_dot(from_middle, pov_unit(c->direction));

    if (c->type == POV_CAMERA_PERSPECTIVE)
        depth -= ahead * fmax(x / across, y / up);
    else
        depth -= 2.0 * length(from_middle);
    *away = fmax(*away, -depth);
    *part = fmax(*part, fmax(x / across, y / up));
}

bool orbit_frame(orbit *o, const pov_box *box)
{
    const double margin = 1.05;
    pov_camera c = orbit_camera(o);
    pov_vec3 middle = pov_scale(pov_add(box->lo, box->hi), 0.5), half = pov_scale(pov_sub(box->hi, box->lo), 0.5);
    double away = 0.0, part = 0.0;

    for (int i = 0; i < 8; i++)
        fit_corner(&c, pov_vec3_of(i & 1 ? half.x : -half.x, i & 2 ? half.y : -half.y, i & 4 ? half.z : -half.z), &away, &part);
    away *= margin;
    if (!(away > 0.0 && away < HUGE_VAL && part > 0.0))
        return false;
    if (c.type == POV_CAMERA_ORTHOGRAPHIC) {
        o->camera.right = pov_scale(o->camera.right, margin * part);
        o->camera.up = pov_scale(o->camera.up, margin * part);
    }
    o->reach = away / length(c.direction);
    o->camera.location = pov_sub(middle, pov_scale(c.direction, o->reach));
    o->moved = true;
    return true;
}

double orbit_widen(orbit *o, double factor)
{
    const double narrowest = 1e-3, widest = 30.0;
    pov_camera c = orbit_camera(o);
    double wide = 0.5 * length(c.right) / length(c.direction);

    if (c.type == POV_CAMERA_ORTHOGRAPHIC) {
        o->camera.right = pov_scale(c.right, factor * o->first_shape / o->shape);
        o->camera.up = pov_scale(c.up, factor);
        o->moved = true;
        return 0.0;
    }
    if (c.type != POV_CAMERA_PERSPECTIVE)
        return -1.0;
    factor = fmin(fmax(wide * factor, fmin(wide, narrowest)), fmax(wide, widest)) / wide;
    o->camera.direction = pov_scale(c.direction, 1.0 / factor);
    o->reach *= factor;
    o->moved = true;
    return 2.0 * atan(wide * factor) * 180.0 / PI;
}
