#include "numerics/families.h"

#include "numerics/draw.h"
#include "numerics/families_round.h"

#include <float.h>
#include <string.h>

static uint64_t state;

void families_seed(uint64_t seed) { state = seed * 2862933555777941757u + 3037000493u; }

double families_uniform(void)
{
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return (double)(state >> 11) * 0x1p-53;
}

pov_vec3 families_direction(void)
{
    double z = between(-1.0, 1.0), angle = 6.283185307179586 * U(), r = sqrt(1.0 - z * z);
    return pov_vec3_of(r * cos(angle), r * sin(angle), z);
}

/* ---- shapes of size about `size` about a place ---- */

static void make_cone(probe *p, double size, pov_vec3 place, double ratio)
{
    pov_vec3 axis = U() < 0.3 ? pov_vec3_of(0.0, either(1.0), 0.0) : families_direction();
    pov_vec3 top = pov_add(place, pov_scale(axis, size * between(0.3, 2.0)));
    double r = size * between(0.2, 1.5);

    put(p, 0, place);
    p->open = U() < 0.3;
    if (p->kind == CYLINDER) {
        put(p, 3, top);
        p->number[6] = r;
        p->count = 7;
        return;
    }
    p->number[3] = r;
    put(p, 4, top);
    p->number[7] = r * ratio;
    p->count = 8;
}

/* A flat star or quadrangle, or with a hole, its points exactly in a plane of small whole slopes. */
static void make_polygon(probe *p, double size, pov_vec3 place)
{
    const bool is_triangle = p->kind != POLYGON;
    const int corners = 3 + (int)(5.0 * U() * !is_triangle), loops = U() < 0.3 && !is_triangle ? 2 : 1;
    const int axis = (int)(3.0 * U());
    const double step = ldexp(1.0, (int)ceil(log2(size)) - 16), turn = U();
    /* Whole multiples of a step, and a plane of slopes 0, 1 or 2: all of it exact. */
    const double grid = ldexp(1.0, -40) * ldexp(1.0, (int)ceil(log2(size + pov_largest(place))));
    const double unit = step > grid ? step : grid;
    const double slope_u = floor(3.0 * U()), slope_v = floor(3.0 * U());
    int at = 1, loop, i;

    for (loop = 0; loop < loops; loop++) {
        const int first = at;

        for (i = 0; i <= corners; i++, at += 3) {
            const double angle = 6.283185307179586 * (i + turn) / corners,
                         r = size / unit * (loop ? 0.3 : between(0.5, 1.0));
            double uv[2], xyz[3];

            if (i == corners) {
                put(p, at, get(p, first));
                continue;
            }
            uv[0] = unit * floor(r * cos(angle));
            uv[1] = unit * floor(r * sin(angle));
            xyz[axis] = uv[0];
            xyz[(axis + 1) % 3] = uv[1];
            xyz[(axis + 2) % 3] = slope_u * uv[0] + slope_v * uv[1];
            put(p, at,
                pov_vec3_of(unit * floor(place.x / unit) + xyz[0], unit * floor(place.y / unit) + xyz[1],
                            unit * floor(place.z / unit) + xyz[2]));
        }
    }
    p->count = at;
    p->number[0] = (at - 1) / 3;
}

/* About a place; the terms are written out, so at a far place they cancel: the doubles are what they are. */
static void make_quadric(probe *p, double size, pov_vec3 place, double spread)
{
    double a[6], *q = p->number;
    int i;

    for (i = 0; i < 3; i++)
        a[i] = log_between(-spread, spread) / (size * size) * (U() < 0.3 ? -1.0 : 1.0);
    for (i = 3; i < 6; i++)
        a[i] = U() < 0.5 ? 0.0 : between(-0.5, 0.5) / (size * size);
    if (U() < 0.15)
        a[(int)(3.0 * U())] = 0.0;
    memcpy(q, a, sizeof a);
    q[6] = -(2.0 * a[0] * place.x + a[3] * place.y + a[4] * place.z);
    q[7] = -(2.0 * a[1] * place.y + a[3] * place.x + a[5] * place.z);
    q[8] = -(2.0 * a[2] * place.z + a[4] * place.x + a[5] * place.y);
    q[9] = -0.5 * (q[6] * place.x + q[7] * place.y + q[8] * place.z) - (U() < 0.1 ? 0.0 : 1.0);
    if (U() < 0.2)
        q[6 + (int)(3.0 * U())] += either(1.0) / size;
    p->count = 10;
}

void families_shape(probe *p, double size, pov_vec3 place)
{
    p->size = size;
    p->open = false;
    if (p->kind == SPHERE) {
        put(p, 0, place);
        p->number[3] = size * between(0.5, 1.5);
        p->count = 4;
    } else if (p->kind == BOX) {
        put(p, 0, pov_sub(place, pov_scale(pov_vec3_of(U(), U(), U()), size)));
        put(p, 3, pov_add(place, pov_scale(pov_vec3_of(U(), U(), U()), size)));
        p->count = 6;
    } else if (p->kind == QUADRIC) {
        make_quadric(p, size, place, 0.3);
    } else if (kind_has_corners(p->kind)) {
        make_polygon(p, size, place);
    } else if (p->kind == TORUS || p->kind == PLANE || p->kind == DISC) {
        round_make(p, size, place);
    } else {
        make_cone(p, size, place, U() < 0.2 ? 0.0 : between(0.0, 2.0));
    }
}

/* ---- points on them, and the normals there: near enough, in double ---- */

static void point_on_box(const probe *p, pov_vec3 *at, pov_vec3 *normal)
{
    double v[3], n[3] = { 0.0, 0.0, 0.0 };
    const int axis = (int)(3.0 * U()), side = U() < 0.5;
    int i;

    for (i = 0; i < 3; i++)
        v[i] = i == axis ? p->number[i + 3 * side] : p->number[i] + (p->number[3 + i] - p->number[i]) * U();
    n[axis] = p->number[axis + 3 * side] > p->number[axis + 3 * !side] ? 1.0 : -1.0;
    *at = pov_vec3_of(v[0], v[1], v[2]);
    *normal = pov_vec3_of(n[0], n[1], n[2]);
}

static void point_on_cone(const probe *p, pov_vec3 *at, pov_vec3 *normal)
{
    const int top = p->kind == CONE ? 4 : 3;
    const double r0 = p->number[p->kind == CONE ? 3 : 6], r1 = p->number[p->kind == CONE ? 7 : 6], y = U();
    const pov_vec3 base = get(p, 0), axis = pov_sub(get(p, top), base), unit = pov_unit(axis), out = across(unit);
    const double length = sqrt(pov_dot(axis, axis)), r = r0 + y * (r1 - r0);

    if (U() < 0.25 && !p->open) {
        const bool is_top = U() < 0.5;
        *at = pov_add(pov_add(base, pov_scale(axis, is_top)), pov_scale(out, (is_top ? r1 : r0) * sqrt(U())));
        *normal = pov_scale(unit, is_top ? 1.0 : -1.0);
        return;
    }
    *at = pov_add(pov_add(base, pov_scale(axis, y)), pov_scale(out, r));
    *normal = pov_unit(pov_sub(out, pov_scale(unit, (r1 - r0) / length)));
}

static pov_vec3 gradient_at(const double *q, pov_vec3 v)
{
    return pov_vec3_of(2.0 * q[0] * v.x + q[3] * v.y + q[4] * v.z + q[6],
                       2.0 * q[1] * v.y + q[3] * v.x + q[5] * v.z + q[7],
                       2.0 * q[2] * v.z + q[4] * v.x + q[5] * v.y + q[8]);
}

/* Newton's steps from anywhere near. */
static void point_on_quadric(const probe *p, pov_vec3 place, pov_vec3 *at, pov_vec3 *normal)
{
    const double *q = p->number;
    pov_vec3 v = pov_add(place, pov_scale(families_direction(), p->size * between(0.5, 1.5)));
    int i;

    for (i = 0; i < 40; i++) {
        const pov_vec3 g = gradient_at(q, v), linear = pov_vec3_of(q[6], q[7], q[8]);
        const double value = 0.5 * pov_dot(v, pov_add(g, linear)) + q[9], gg = pov_dot(g, g);

        if (!(gg > 0.0) || !isfinite(value / gg))
            break;
        v = pov_sub(v, pov_scale(g, value / gg));
    }
    *at = v;
    *normal = pov_unit(gradient_at(q, v));
}

static void point_on_polygon(const probe *p, pov_vec3 *at, pov_vec3 *normal)
{
    const int n = (int)p->number[0], i = (int)((n - 2) * U());
    const pov_vec3 a = get(p, 1), b = get(p, 4 + 3 * i), c = get(p, 4 + 3 * ((i + 1) % (n - 1)));
    const double s = U(), t = U();

    *at = pov_add(a, pov_add(pov_scale(pov_sub(b, a), s), pov_scale(pov_sub(c, a), t)));
    *normal = pov_unit(pov_cross_product(pov_sub(get(p, 4), a), pov_sub(get(p, 7), a)));
}

void families_point(const probe *p, pov_vec3 place, pov_vec3 *at, pov_vec3 *normal)
{
    if (p->kind == SPHERE) {
        *normal = families_direction();
        *at = pov_add(get(p, 0), pov_scale(*normal, p->number[3]));
    } else if (p->kind == BOX) {
        point_on_box(p, at, normal);
    } else if (p->kind == QUADRIC) {
        point_on_quadric(p, place, at, normal);
    } else if (kind_has_corners(p->kind)) {
        point_on_polygon(p, at, normal);
    } else if (p->kind == TORUS || p->kind == PLANE || p->kind == DISC) {
        round_point(p, place, at, normal);
    } else {
        point_on_cone(p, at, normal);
    }
}

/* ---- rays ---- */

/* From a distance towards a point; the direction is what the rounded origin makes it. */
static void ray_from(probe *p, pov_vec3 target, pov_vec3 dir, double distance)
{
    const pov_vec3 org = pov_sub(target, pov_scale(dir, distance));

    ray_of(p, org, distance > 0.0 ? pov_unit(pov_sub(target, org)) : dir);
}

/* Somewhere on or about the shape. */
static pov_vec3 target_near(const probe *p, pov_vec3 place)
{
    pov_vec3 at, normal;

    families_point(p, place, &at, &normal);
    return pov_add(at, pov_scale(families_direction(), p->size * 0.5 * U() * U()));
}

/* parameter: distance over size */
static void from_distance(probe *p, double parameter)
{
    const pov_vec3 place = small_place(1.0);

    families_shape(p, 1.0, place);
    ray_from(p, target_near(p, place), families_direction(), parameter * p->size);
}

/* parameter: translation over size */
static void translated(probe *p, double parameter)
{
    const pov_vec3 place = pov_scale(pov_vec3_of(between(-1, 1), between(-1, 1), between(-1, 1)), parameter);

    families_shape(p, 1.0, place);
    ray_from(p, target_near(p, place), families_direction(), between(0.0, 10.0));
}

static void scaled(probe *p, double parameter)
{
    const pov_vec3 place = small_place(parameter);

    families_shape(p, parameter, place);
    ray_from(p, target_near(p, place), families_direction(), parameter * between(0.0, 10.0));
}

/* parameter: how near to a tangent, as an exponent of ten, at most */
static void grazing(probe *p, double parameter)
{
    const pov_vec3 place = small_place(1.0);
    const double off = either(log_between(parameter, -2.0));
    pov_vec3 at, normal, dir;

    families_shape(p, 1.0, place);
    families_point(p, place, &at, &normal);
    dir = across(normal);
    if (U() < 0.5)
        dir = pov_unit(pov_add(dir, pov_scale(normal, either(log_between(parameter, -2.0)))));
    ray_from(p, pov_add(at, pov_scale(normal, off * p->size)), dir, p->size * log_between(-1.0, 3.0));
}

/* parameter: how far off the surface the ray starts, as an exponent of ten, at least */
static void at_surface(probe *p, double parameter)
{
    const pov_vec3 place = small_place(1.0);
    pov_vec3 at, normal;

    families_shape(p, 1.0, place);
    families_point(p, place, &at, &normal);
    ray_of(p, pov_add(at, pov_scale(normal, either(p->size * log_between(parameter, -2.0)))), families_direction());
}

/* Both at once. parameter: how far off the surface the ray starts, as an exponent of ten, at least; its cosine to the
 * normal is 1e-9 at least. */
static void near_and_grazing(probe *p, double parameter)
{
    const pov_vec3 place = small_place(1.0);
    pov_vec3 at, normal, dir;

    families_shape(p, 1.0, place);
    families_point(p, place, &at, &normal);
    dir = pov_unit(pov_add(across(normal), pov_scale(normal, either(log_between(-9.0, -4.0)))));
    ray_of(p, pov_add(at, pov_scale(normal, either(p->size * log_between(parameter, -2.0)))), dir);
}

/* parameter: the exponent of the direction's length */
static void of_length(probe *p, double parameter)
{
    from_distance(p, 10.0);
    p->ray.dir = pov_scale(p->ray.dir, pow(10.0, parameter));
}

/* Components that are zero, -0, denormal or tiny. */
static void axis_parallel(probe *p, double parameter)
{
    static const double odd[] = { 0.0, -0.0, 5e-324, -5e-324, 1e-310, 1e-200, 1e-30, -1e-16 };
    const pov_vec3 place = small_place(1.0);
    double d[3], o[3];
    const int axis = (int)(3.0 * U());
    pov_vec3 target;
    int i;

    (void)parameter;
    families_shape(p, 1.0, place);
    target = target_near(p, place);
    o[0] = target.x, o[1] = target.y, o[2] = target.z;
    for (i = 0; i < 3; i++) {
        d[i] = i == axis ? either(1.0) : odd[(int)(8.0 * U())];
        if (i != axis && U() < 0.3)
            o[i] = ldexp(floor(ldexp(o[i], 2)), -2);
    }
    o[axis] -= 5.0 * d[axis] * U();
    ray_of(p, pov_vec3_of(o[0], o[1], o[2]), pov_vec3_of(d[0], d[1], d[2]));
}

/* Origins and directions in double-double, as maps and secondary rays make them. */
static void in_dd(probe *p, double parameter)
{
    const double f = 0x1p-54 * parameter;

    if (U() < 0.5)
        from_distance(p, log_between(0.0, 6.0));
    else
        grazing(p, -15.0);
    p->ray.org_lo = pov_vec3_of(p->ray.org.x * f * U(), p->ray.org.y * -f * U(), p->ray.org.z * f * U());
    p->ray.dir_lo = pov_vec3_of(p->ray.dir.x * f * U(), p->ray.dir.y * -f * U(), p->ray.dir.z * f * U());
}

/* Along the axis or a generator, tilted by ten to the parameter at most. */
static void near_parallel(probe *p, double parameter)
{
    const pov_vec3 place = small_place(1.0);
    pov_vec3 at, normal, axis;

    families_shape(p, 1.0, place);
    point_on_cone(p, &at, &normal);
    axis = pov_unit(pov_sub(get(p, p->kind == CONE ? 4 : 3), get(p, 0)));
    if (U() < 0.7)
        axis = pov_unit(pov_sub(axis, pov_scale(normal, pov_dot(axis, normal))));
    axis = pov_unit(pov_add(axis, pov_scale(families_direction(), log_between(parameter, -1.0))));
    ray_from(p, at, axis, log_between(-1.0, 2.0));
}

/* parameter: r1 / r0 - 1 */
static void near_cylinder(probe *p, double parameter)
{
    const pov_vec3 place = small_place(1.0);

    p->size = 1.0;
    make_cone(p, 1.0, place, 1.0 + parameter);
    ray_from(p, target_near(p, place), families_direction(), log_between(0.0, 2.0));
}

/* Towards the apex, or the rim of a cap, missed by ten to the parameter at least. */
static void rims(probe *p, double parameter)
{
    const pov_vec3 place = small_place(1.0);
    const double off = log_between(parameter, -2.0);
    pov_vec3 axis, target;
    double r;

    p->size = 1.0;
    make_cone(p, 1.0, place, U() < 0.5 ? 0.0 : between(0.2, 2.0));
    axis = pov_sub(get(p, p->kind == CONE ? 4 : 3), get(p, 0));
    r = p->number[p->kind == CONE ? 3 : 6];
    target = get(p, 0);
    if (U() < 0.5 && p->kind == CONE) {
        target = get(p, 4);
        r = p->number[7];
    }
    target = pov_add(target, pov_scale(across(pov_unit(axis)), r));
    ray_from(p, pov_add(target, pov_scale(families_direction(), off)), families_direction(), log_between(-1.0, 3.0));
}

/* parameter: length over radius, or its inverse */
static void needles(probe *p, double parameter)
{
    const pov_vec3 place = small_place(1.0), axis = families_direction();
    const double r = parameter > 1.0 ? 1.0 / parameter : 1.0, length = parameter > 1.0 ? 1.0 : parameter;
    pov_vec3 at, normal;

    p->size = r < length ? r : length;
    p->open = U() < 0.3;
    put(p, 0, place);
    put(p, p->kind == CONE ? 4 : 3, pov_add(place, pov_scale(axis, length)));
    p->number[p->kind == CONE ? 3 : 6] = r;
    if (p->kind == CONE)
        p->number[7] = r * U();
    p->count = p->kind == CONE ? 8 : 7;
    point_on_cone(p, &at, &normal);
    ray_from(p, pov_add(at, pov_scale(families_direction(), p->size * U())), families_direction(),
             log_between(0.0, 3.0));
}

/* parameter: thickness */
static void thin_boxes(probe *p, double parameter)
{
    const pov_vec3 place = small_place(1.0);
    const int axis = (int)(3.0 * U());
    pov_vec3 at, normal;

    families_shape(p, 1.0, place);
    p->number[3 + axis] = p->number[axis] + parameter * (U() < 0.5 ? 1.0 : U());
    point_on_box(p, &at, &normal);
    ray_from(p, at, families_direction(), log_between(-1.0, 3.0));
}

/* Rays at edges and corners, missed by ten to the parameter at least, or not at all. */
static void box_edges(probe *p, double parameter)
{
    const pov_vec3 place = small_place(1.0);
    double v[3];
    int i;

    families_shape(p, 1.0, place);
    for (i = 0; i < 3; i++)
        v[i] = U() < 0.7 ? p->number[i + 3 * (U() < 0.5)] : p->number[i] + (p->number[3 + i] - p->number[i]) * U();
    ray_from(p,
             pov_add(pov_vec3_of(v[0], v[1], v[2]),
                     pov_scale(families_direction(), U() < 0.3 ? 0.0 : log_between(parameter, -2.0))),
             families_direction(), log_between(-1.0, 3.0));
}

static void polygon_edges(probe *p, double parameter)
{
    const pov_vec3 place = small_place(1.0);
    int i;
    pov_vec3 a, b;

    families_shape(p, 1.0, place);
    i = (int)(((int)p->number[0] - 1) * U());
    a = get(p, 1 + 3 * i);
    b = get(p, 4 + 3 * i);
    ray_from(p, pov_add(pov_add(a, pov_scale(pov_sub(b, a), U() < 0.3 ? 0.0 : U())),
                        pov_scale(families_direction(), U() < 0.3 ? 0.0 : log_between(parameter, -2.0))),
             families_direction(), log_between(-1.0, 3.0));
}

/* A triangle as thin as the parameter. */
static void slivers(probe *p, double parameter)
{
    const pov_vec3 a = small_place(1.0), b = pov_add(a, families_direction());
    const pov_vec3 c = pov_add(a, pov_add(pov_scale(pov_sub(b, a), U()), pov_scale(families_direction(), parameter)));

    p->number[0] = 4.0;
    put(p, 1, a);
    put(p, 4, b);
    put(p, 7, c);
    put(p, 10, a);
    p->count = 13;
    p->size = 1.0;
    ray_from(p, pov_add(pov_add(a, pov_scale(pov_sub(b, a), U())), pov_scale(pov_sub(c, a), 0.5 * U())),
             families_direction(), log_between(-1.0, 3.0));
}

/* parameter: decades of the coefficients to either side */
static void spread(probe *p, double parameter)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    pov_vec3 at, normal;

    p->size = 1.0;
    make_quadric(p, 1.0, zero, parameter);
    p->number[3] = p->number[4] = p->number[5] = 0.0;
    point_on_quadric(p, zero, &at, &normal);
    ray_from(p, pov_add(at, pov_scale(families_direction(), 0.1 * U())), families_direction(), log_between(-1.0, 3.0));
}

/* Planes, pairs of planes, paraboloids, and squares that are almost not there. */
static void degenerate(probe *p, double parameter)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    double *q = p->number;
    const int form = (int)(5.0 * U());
    pov_vec3 at, normal;

    memset(q, 0, 10 * sizeof *q);
    p->count = 10;
    p->size = 1.0;
    if (form == 0) {
        q[6] = between(-1, 1), q[7] = 1.0, q[8] = between(-1, 1), q[9] = between(-1, 1);
    } else if (form == 1) {
        q[0] = 1.0, q[9] = -U();
    } else if (form == 2) {
        q[0] = 1.0, q[2] = either(1.0), q[7] = either(1.0);
    } else if (form == 3) {
        q[0] = either(log_between(parameter, 0.0)), q[2] = either(log_between(parameter, 0.0)), q[7] = 1.0, q[9] = -U();
    } else {
        q[0] = 1.0, q[1] = 1.0, q[2] = -between(0.5, 2.0);
    }
    point_on_quadric(p, zero, &at, &normal);
    ray_from(p, pov_add(at, pov_scale(families_direction(), 0.1 * U())), families_direction(), log_between(-1.0, 3.0));
}

/* parameter: the second order over the first, as an exponent of ten, at least; met at cosines of 1e-8 to 1 */
static void nearly_planes(probe *p, double parameter)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    double *q = p->number;
    pov_vec3 at, normal, dir;
    int i;

    memset(q, 0, 10 * sizeof *q);
    for (i = 0; i < 6; i++)
        q[i] = either(log_between(parameter, -3.0));
    for (i = 6; i < 9; i++)
        q[i] = either(log_between(-2.0, 0.0));
    q[9] = 0.1 * U();
    p->count = 10;
    p->size = 1.0;
    point_on_quadric(p, zero, &at, &normal);
    dir = pov_unit(pov_add(across(normal), pov_scale(normal, either(log_between(-8.0, 0.0)))));
    ray_from(p, at, dir, log_between(-1.0, 2.0));
}

static void torture(probe *p, double parameter)
{
    uint32_t mine[64], n = 0, i;

    (void)parameter;
    for (i = 0; families[i].make != torture; i++) {
        if (families[i].kinds & (1u << p->kind))
            mine[n++] = i;
    }
    i = mine[(uint32_t)(n * U())];
    families[i].make(p, families[i].parameter);
    if (U() < 0.2) {
        const double scale = ldexp(1.0, (int)between(-300.0, 300.0));
        p->ray.dir = pov_scale(p->ray.dir, scale);
        p->ray.dir_lo = pov_scale(p->ray.dir_lo, scale);
    }
}

enum {
    PLANAR_SIDES = 1u << BOX, AXIAL = 1u << CONE | 1u << CYLINDER, SECOND = 1u << QUADRIC,
    FLAT = 1u << POLYGON | 1u << TRIANGLE | 1u << MESH | 1u << SMOOTH_TRIANGLE, RING = 1u << TORUS, ALL = (1u << KINDS) - 1,
    MOVED = ALL & ~RING
};

const family families[] = {
    { "distance", 1.0, ALL, from_distance },
    { "distance", 1e3, ALL, from_distance },
    { "distance", 1e6, ALL, from_distance },
    { "distance", 1e9, ALL, from_distance },
    { "distance", 1e12, ALL, from_distance },
    { "translation", 1e3, MOVED, translated },
    { "translation", 1e6, MOVED, translated },
    { "translation", 1e9, MOVED, translated },
    { "scale", 1e-100, ALL, scaled },
    { "scale", 1e-12, ALL, scaled },
    { "scale", 1e-6, ALL, scaled },
    { "scale", 1e6, ALL, scaled },
    { "scale", 1e12, ALL, scaled },
    { "scale", 1e100, ALL, scaled },
    { "grazing", -15.0, ALL, grazing },
    { "at_surface", -14.0, ALL, at_surface },
    { "near_grazing", -6.0, ALL, near_and_grazing },
    { "near_grazing", -13.0, ALL, near_and_grazing },
    { "dir_length", -280.0, ALL, of_length },
    { "dir_length", 280.0, ALL, of_length },
    { "axis_parallel", 0.0, ALL, axis_parallel },
    { "two_parts", 1.0, ALL, in_dd },
    { "near_parallel", -10.0, AXIAL, near_parallel },
    { "near_cylinder", 1e-3, 1u << CONE, near_cylinder },
    { "near_cylinder", 1e-9, 1u << CONE, near_cylinder },
    { "near_cylinder", 1e-15, 1u << CONE, near_cylinder },
    { "rims", -15.0, AXIAL, rims },
    { "needle", 1e3, AXIAL, needles },
    { "needle", 1e9, AXIAL, needles },
    { "needle", 1e-9, AXIAL, needles },
    { "thin", 1e-6, PLANAR_SIDES, thin_boxes },
    { "thin", 1e-15, PLANAR_SIDES, thin_boxes },
    { "edges", -15.0, PLANAR_SIDES, box_edges },
    { "edges", -15.0, FLAT, polygon_edges },
    { "sliver", 1e-6, FLAT, slivers },
    { "sliver", 1e-12, FLAT, slivers },
    { "spread", 4.0, SECOND, spread },
    { "spread", 8.0, SECOND, spread },
    { "degenerate", -16.0, SECOND, degenerate },
    { "nearly_plane", -9.0, SECOND, nearly_planes },
    { "tube", 1e-3, RING, round_tubes },
    { "tube", 1e-6, RING, round_tubes },
    { "tube", 1.0 + 0x1p-30, RING, round_tubes },
    { "tube", 1.0, RING, round_tubes },
    { "tube", 1e3, RING, round_tubes },
    { "tangent", -15.0, RING, round_tangents },
    { "axis", -13.0, RING, round_axes },
    { "rims", -15.0, 1u << DISC, round_rims },
    { "torture", 0.0, ALL, torture },
    { NULL, 0.0, 0, NULL },
};
