#include "light/reach.h"

/* A quadratic form along the line: positive where there may be light. */
typedef struct form { double a, b, c; } form;

static double form_at(const form *f, double t) { return (f->a * t + f->b) * t + f->c; }

/* Within the cone: (v.axis)^2 - cos^2 v.v > 0, and v.axis > 0, which the caller tests. */
static form cone_form(const light *l, pov_vec3 v, pov_vec3 dir)
{
    const double least = l->falloff < l->radius ? l->falloff : l->radius, square = least * least;
    const double along = pov_dot(v, l->axis), slope = pov_dot(dir, l->axis);
    const form f = { slope * slope - square, 2.0 * (along * slope - square * pov_dot(v, dir)),
                     along * along - square * pov_dot(v, v) };

    return f;
}

/* Within the cylinder: falloff^2 - the squared distance from the axis > 0. */
static form cylinder_form(const light *l, pov_vec3 v, pov_vec3 dir)
{
    const pov_vec3 off = pov_cross_product(v, l->axis), turn = pov_cross_product(dir, l->axis);
    const form f = { -pov_dot(turn, turn), -2.0 * pov_dot(off, turn), l->falloff * l->falloff - pov_dot(off, off) };

    return f;
}

/* Roots in order; false: none. */
static bool roots(const form *f, double root[2])
{
    const double d = f->b * f->b - 4.0 * f->a * f->c;
    double q, swap;

    if (d < 0.0)
        return false;
    q = -0.5 * (f->b + copysign(sqrt(d > 0.0 ? d : 0.0), f->b));
    if (!(d >= 0.0) || f->a == 0.0 || q == 0.0) {
        root[0] = root[1] = f->a == 0.0 && f->b != 0.0 ? -f->c / f->b : 0.0;
        return f->a == 0.0 && f->b != 0.0;
    }
    root[0] = q / f->a;
    root[1] = f->c / q;
    if (root[0] > root[1]) {
        swap = root[0];
        root[0] = root[1];
        root[1] = swap;
    }
    return true;
}

static double within(double t, double lo, double hi) { return t < lo ? lo : t > hi ? hi : t; }

/* May there be light at a place, on the way v + t dir from the light? */
static bool is_lit(const light *l, const form *f, pov_vec3 v, pov_vec3 dir, double t)
{
    return (l->type != LIGHT_SPOT || pov_dot(v, l->axis) + t * pov_dot(dir, l->axis) > 0.0) && form_at(f, t) > 0.0;
}

bool light_reach(const light *l, pov_vec3 from, pov_vec3 dir, double *lo, double *hi)
{
    const bool conical = l->type == LIGHT_SPOT;
    const pov_vec3 v = pov_sub(pov_sub(from, l->position), l->position_lo);
    double edge[4], root[2], first = HUGE_VAL, last = -HUGE_VAL;
    form f;

    if (!conical && l->type != LIGHT_CYLINDER)
        return *lo < *hi;
    if (conical && !(l->falloff > 0.0 && l->radius > 0.0))
        return *lo < *hi;
    f = conical ? cone_form(l, v, dir) : cylinder_form(l, v, dir);
    if (!roots(&f, root))
        return *lo < *hi && is_lit(l, &f, v, dir, 0.5 * (*lo + *hi));
    edge[0] = *lo;
    edge[1] = within(root[0], *lo, *hi);
    edge[2] = within(root[1], *lo, *hi);
    edge[3] = *hi;
    for (int i = 0; i < 3; i++) {
        if (edge[i] < edge[i + 1] && is_lit(l, &f, v, dir, 0.5 * (edge[i] + edge[i + 1]))) {
            first = edge[i] < first ? edge[i] : first;
            last = edge[i + 1];
        }
    }
    *lo = first;
    *hi = last;
    return first < last;
}
