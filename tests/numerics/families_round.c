/* Probes of tori, planes and discs, and the families that only these have. */
#include "numerics/families_round.h"

#include "numerics/draw.h"

/* The radii of the ring and of the tube. */
static void put_torus(probe *p, double major, double minor)
{
    p->number[0] = major;
    p->number[1] = minor;
    p->count = 2;
    p->size = major + minor;
}

static pov_vec3 any_normal(void)
{
    return U() < 0.3 ? pov_vec3_of(0.0, either(between(0.5, 2.0)), 0.0) : pov_scale(families_direction(), between(0.3, 3.0));
}

void round_make(probe *p, double size, pov_vec3 place)
{
    const pov_vec3 normal = any_normal();

    if (p->kind == TORUS) {
        const double major = size * between(0.3, 1.0);

        put_torus(p, major, major * (U() < 0.3 ? between(1.0, 3.0) : log_between(-1.5, 0.0)));
        return;
    }
    p->size = size;
    if (p->kind == PLANE) {
        put(p, 0, normal);
        p->number[3] = pov_dot(pov_unit(normal), place);
        p->count = 4;
        return;
    }
    put(p, 0, place);
    put(p, 3, normal);
    p->number[6] = size * between(0.5, 1.5);
    p->number[7] = U() < 0.5 ? 0.0 : p->number[6] * between(0.1, 0.95);
    p->count = 8;
}

/* Of the outer sheet, at an angle around the axis and one around the tube. */
static void point_on_torus(const probe *p, pov_vec3 *at, pov_vec3 *normal)
{
    const double R = p->number[0], r = p->number[1], turn = 6.283185307179586 * U();
    const double limit = r > R ? acos(-R / r) : 3.141592653589793, tube = between(-limit, limit);
    const double out = R + r * cos(tube);

    *at = pov_vec3_of(out * cos(turn), r * sin(tube), out * sin(turn));
    *normal = pov_vec3_of(cos(tube) * cos(turn), sin(tube), cos(tube) * sin(turn));
}

void round_point(const probe *p, pov_vec3 place, pov_vec3 *at, pov_vec3 *normal)
{
    double least, most;
    pov_vec3 along;

    if (p->kind == TORUS) {
        point_on_torus(p, at, normal);
        return;
    }
    *normal = pov_unit(get(p, p->kind == PLANE ? 0 : 3));
    along = across(*normal);
    least = p->kind == PLANE ? 0.0 : p->number[7];
    most = p->kind == PLANE ? p->size : p->number[6];
    *at = pov_add(place, pov_scale(along, sqrt(least * least + (most * most - least * least) * U())));
}

static void aim(probe *p, pov_vec3 target, pov_vec3 dir, double distance)
{
    const pov_vec3 org = pov_sub(target, pov_scale(dir, distance));

    ray_of(p, org, pov_unit(pov_sub(target, org)));
}

static void aim_at_torus(probe *p)
{
    pov_vec3 at, normal;

    point_on_torus(p, &at, &normal);
    aim(p, pov_add(at, pov_scale(families_direction(), U() * p->number[1])), families_direction(), p->size * log_between(0.0, 3.0));
}

/* parameter: the tube over the ring: thin ones, and spindles whose poles are nearly or hardly there */
void round_tubes(probe *p, double parameter)
{
    put_torus(p, 1.0, parameter * (U() < 0.5 ? 1.0 : between(0.9, 1.1)));
    aim_at_torus(p);
}

/* Rays that touch the tube along its highest or lowest circle, its innermost or its outermost, or at two points at once, and
 * are off by ten to the parameter at least. */
void round_tangents(probe *p, double parameter)
{
    const double R = 1.0, r = between(0.1, 0.9), turn = 6.283185307179586 * U(), tilt = asin(r / R);
    const double off = either(log_between(parameter, -2.0));
    const pov_vec3 around = { cos(turn), 0.0, sin(turn) }, along = { -sin(turn), 0.0, cos(turn) }, up = { 0.0, 1.0, 0.0 };
    const int form = (int)(4.0 * U());

    put_torus(p, R, r);
    if (form == 0)
        aim(p, pov_add(pov_scale(around, R * U()), pov_scale(up, either(r) + off)), along, log_between(-0.5, 3.0));
    else if (form == 1)
        aim(p, pov_scale(around, R - r + off), U() < 0.5 ? along : up, log_between(0.3, 3.0));
    else if (form == 2)
        aim(p, pov_scale(around, R + r + off), U() < 0.5 ? along : up, log_between(-0.5, 3.0));
    else
        aim(p, pov_scale(up, off), pov_add(pov_scale(around, cos(tilt)), pov_scale(up, either(sin(tilt)))), log_between(0.5, 3.0));
}

/* Along the axis, or at the poles of a spindle, missed by ten to the parameter at least. */
void round_axes(probe *p, double parameter)
{
    const pov_vec3 up = { 0.0, 1.0, 0.0 };
    double r = between(0.3, 3.0), pole;

    put_torus(p, 1.0, r);
    pole = r > 1.0 ? sqrt(r * r - 1.0) : 0.0;
    aim(p, pov_add(pov_scale(up, either(pole)), pov_scale(families_direction(), log_between(parameter, -1.0))),
        U() < 0.5 ? families_direction() : pov_unit(pov_add(up, pov_scale(families_direction(), log_between(parameter, -1.0)))),
        log_between(0.5, 3.0));
}

/* At the rims of a disc, missed by ten to the parameter at least. */
void round_rims(probe *p, double parameter)
{
    const pov_vec3 place = small_place(1.0);
    double radius;

    round_make(p, 1.0, place);
    radius = p->number[U() < 0.5 && p->number[7] > 0.0 ? 7 : 6];
    aim(p, pov_add(pov_add(place, pov_scale(across(pov_unit(get(p, 3))), radius)),
                   pov_scale(families_direction(), log_between(parameter, -2.0))), families_direction(), log_between(-1.0, 3.0));
}
