#include "texture/warp.h"

#include "base/elementary.h"
#include "base/powers.h"

/* ---- repeat ---- */

static double *along(vec_lanes *at, int axis)
{
    return axis == 0 ? at->x : axis == 1 ? at->y : at->z;
}

/* Cells along the axis: their numbers, and places in them, which begin where floats do, as POV-Ray's. Odd ones are turned
 * round if asked. */
SIMD_CLONES static void to_cells(double width, bool flips, uint32_t n, double *restrict at, double *restrict cell)
{
    for (uint32_t i = 0; i < n; i++) {
        const double k = floor(at[i] / width), inside = at[i] - (double)(float)(k * width);
        const bool is_odd = k - 2.0 * floor(0.5 * k) != 0.0;

        at[i] = is_odd && flips ? width - inside : inside;
        cell[i] = k;
    }
}

SIMD_CLONES static void flip_odd(const double *restrict cell, uint32_t n, double *restrict at)
{
    for (uint32_t i = 0; i < n; i++)
        at[i] = cell[i] - 2.0 * floor(0.5 * cell[i]) != 0.0 ? -at[i] : at[i];
}

SIMD_CLONES static void add_steps(const double *restrict cell, double step, uint32_t n, double *restrict at)
{
    for (uint32_t i = 0; i < n; i++)
        at[i] += cell[i] * step;
}

static void repeat(const warp_repeat *w, vec_lanes *at, uint32_t n)
{
    const double step[3] = { w->offset.x, w->offset.y, w->offset.z };
    SIMD_ALIGNED double cell[LANES_MAX];

    to_cells(w->width, w->flip[w->axis], n, along(at, w->axis), cell);
    for (int axis = 0; axis < 3; axis++) {
        if (w->flip[axis] && axis != w->axis)
            flip_odd(cell, n, along(at, axis));
        if (step[axis] != 0.0)
            add_steps(cell, step[axis], n, along(at, axis));
    }
}

/* ---- black_hole ---- */

/* Along one axis: cells of that length, 0: none. A hole that is repeated stands wholly in its cell, wherever turbulence
 * moves it. */
typedef struct hole_axis { double length, center, turbulence; } hole_axis;

static hole_axis hole_along(double length, double center, double moved, double radius)
{
    hole_axis out = { 0.0, center, moved };
    double least;

    if (length <= 0.0)
        return out;
    out.center = center < radius ? radius : center;
    least = out.center + radius + moved;
    out.length = length < least ? least : length;
    return out;
}

SIMD_INLINE double cell_of(const hole_axis *a, double at) { return a->length > 0.0 ? floor(at / a->length) : 0.0; }

/* Random numbers of each cell: where its hole stands. */
static void move_holes(const noise_tables *t, const hole_axis axis[3], const vec_lanes *at, uint32_t n, vec_lanes *center)
{
    for (uint32_t i = 0; i < n; i++) {
        const double x = cell_of(&axis[0], at->x[i]), y = cell_of(&axis[1], at->y[i]), z = cell_of(&axis[2], at->z[i]);
        const double *random = t->cell + noise_hash(t, noise_whole(x), noise_whole(y), noise_whole(z));

        center->x[i] += axis[0].turbulence * random[0];
        center->y[i] += axis[1].turbulence * random[1];
        center->z[i] += axis[2].turbulence * random[2];
    }
}

/* The holes that the points stand next to. */
SIMD_CLONES static void find_holes(const hole_axis axis[3], const vec_lanes *restrict at, uint32_t n,
                                   vec_lanes *restrict center)
{
    for (uint32_t i = 0; i < n; i++) {
        center->x[i] = axis[0].center + axis[0].length * cell_of(&axis[0], at->x[i]);
        center->y[i] = axis[1].center + axis[1].length * cell_of(&axis[1], at->y[i]);
        center->z[i] = axis[2].center + axis[2].length * cell_of(&axis[2], at->z[i]);
    }
}

SIMD_CLONES static void find_distances(const vec_lanes *restrict center, uint32_t n, const vec_lanes *restrict at, double *restrict out)
{
    for (uint32_t i = 0; i < n; i++) {
        const double x = at->x[i] - center->x[i], y = at->y[i] - center->y[i], z = at->z[i] - center->z[i];

        out[i] = sqrt(x * x + y * y + z * z);
    }
}

SIMD_CLONES static void find_inside(double radius, const double *restrict distance, uint32_t n, double *restrict out)
{
    for (uint32_t i = 0; i < n; i++) {
        const double inside = 1.0 - distance[i] / radius;

        out[i] = inside > 0.0 ? inside : 0.0;
    }
}

SIMD_CLONES static void pull(const warp_black_hole *w, const vec_lanes *restrict center, const double *restrict distance,
                             const double *restrict power, uint32_t n, vec_lanes *restrict at)
{
    const double sign = w->is_inverse ? -1.0 : 1.0;

    for (uint32_t i = 0; i < n; i++) {
        const double x = at->x[i] - center->x[i], y = at->y[i] - center->y[i], z = at->z[i] - center->z[i];
        const double strength = w->strength * power[i];
        const double a = distance[i] < w->radius ? sign * (strength < 1.0 ? strength : 1.0) : 0.0;

        at->x[i] += a * x;
        at->y[i] += a * y;
        at->z[i] += a * z;
    }
}

static void attract(const warp_black_hole *w, const vec_lanes *center, uint32_t n, vec_lanes *at)
{
    SIMD_ALIGNED double distance[LANES_MAX], power[LANES_MAX];

    find_distances(center, n, at, distance);
    find_inside(w->radius, distance, n, power);
    powers_raise(w->falloff, n, power);
    pull(w, center, distance, power, n, at);
}

/* Only holes that are repeated are moved, then on all axes. */
static bool is_turbulent(const warp_black_hole *w)
{
    return (w->turbulence.x != 0.0 || w->turbulence.y != 0.0 || w->turbulence.z != 0.0) &&
           (w->repeat.x > 0.0 || w->repeat.y > 0.0 || w->repeat.z > 0.0);
}

static void black_hole(const warp_black_hole *w, const noise_tables *noise, vec_lanes *at, uint32_t n)
{
    const hole_axis axis[3] = { hole_along(w->repeat.x, w->center.x, w->turbulence.x, w->radius),
                                hole_along(w->repeat.y, w->center.y, w->turbulence.y, w->radius),
                                hole_along(w->repeat.z, w->center.z, w->turbulence.z, w->radius) };
    vec_lanes center;

    find_holes(axis, at, n, &center);
    if (is_turbulent(w))
        move_holes(noise, axis, at, n, &center);
    attract(w, &center, n, at);
}

/* ---- mappings ---- */

/* The angle about the y axis in turns, 0..1, from x to z. */
SIMD_INLINE double turn_of(double z, double x)
{
    const double t = elementary_atan2(z, x) * 0.15915494309189535;

    return t < 0.0 ? t + 1.0 : t;
}

SIMD_INLINE double half_turns(double angle) { return angle * 0.3183098861837907; }

SIMD_CLONES static void cylindrical(double exponent, uint32_t n, vec_lanes *restrict at)
{
    for (uint32_t i = 0; i < n; i++) {
        const double radius = sqrt(at->x[i] * at->x[i] + at->z[i] * at->z[i]);

        at->x[i] = turn_of(at->z[i], at->x[i]) * elementary_pow(radius, exponent);
        at->z[i] = radius;
    }
}

SIMD_CLONES static void spherical(double exponent, uint32_t n, vec_lanes *restrict at)
{
    for (uint32_t i = 0; i < n; i++) {
        const double flat = at->x[i] * at->x[i] + at->z[i] * at->z[i], radius = sqrt(flat + at->y[i] * at->y[i]);
        const double size = elementary_pow(radius, exponent);

        at->x[i] = turn_of(at->z[i], at->x[i]) * size;
        at->y[i] = (0.5 + half_turns(elementary_atan2(at->y[i], sqrt(flat)))) * size;
        at->z[i] = radius;
    }
}

SIMD_CLONES static void toroidal(double major, double exponent, uint32_t n, vec_lanes *restrict at)
{
    for (uint32_t i = 0; i < n; i++) {
        const double out = sqrt(at->x[i] * at->x[i] + at->z[i] * at->z[i]) - major, y = at->y[i];
        const double radius = sqrt(out * out + y * y), size = elementary_pow(radius, exponent);

        at->x[i] = turn_of(at->z[i], at->x[i]) * size;
        at->y[i] = (0.5 + 0.5 * half_turns(elementary_atan2(y, out))) * size;
        at->z[i] = radius;
    }
}

SIMD_CLONES static void planar(double distance, uint32_t n, vec_lanes *restrict at)
{
    for (uint32_t i = 0; i < n; i++)
        at->z[i] = distance;
}

/* A cube of side 2 is unfolded: u and v in 0..1, and the largest coordinate. Where two are equal, x comes before y. */
SIMD_CLONES static void cubic(uint32_t n, vec_lanes *restrict at)
{
    for (uint32_t i = 0; i < n; i++) {
        const double x = at->x[i], y = at->y[i], z = at->z[i], fx = fabs(x), fy = fabs(y), fz = fabs(z);
        const bool is_x = fx >= fy && fx >= fz, is_y = !is_x && fy >= fz;
        const double size = is_x ? fx : is_y ? fy : fz, per = size > 0.0 ? 0.5 / size : 0.0;
        const double a = 0.5 + per * x, b = 0.5 + per * y, c = 0.5 + per * z;
        const double side_x = x > 0.0 ? 3.0 - c : c, side_z = z > 0.0 ? 1.0 + a : 4.0 - a;

        at->x[i] = 0.25 * (is_x ? side_x : is_y ? 1.0 + a : side_z);
        at->y[i] = (is_y ? (y > 0.0 ? 3.0 - c : c) : 1.0 + b) / 3.0;
        at->z[i] = size;
    }
}

/* Along z a result stays as it is; along x it is (z, y, -x), along y (x, -z, y), and between them a mixture. */
SIMD_CLONES static void orient(pov_vec3 to, uint32_t n, vec_lanes *restrict at)
{
    for (uint32_t i = 0; i < n; i++) {
        const double x = at->x[i], y = at->y[i], z = at->z[i];

        at->x[i] = to.x * z + (to.y * x + to.z * x);
        at->y[i] = to.x * y + (to.z * y - to.y * z);
        at->z[i] = to.z * z + (to.y * y - to.x * x);
    }
}

static void map(const warp *w, vec_lanes *at, uint32_t n)
{
    const warp_mapping *m = &w->as.mapping;

    if (w->kind == WARP_CYLINDRICAL)
        cylindrical(m->dist_exp, n, at);
    else if (w->kind == WARP_SPHERICAL)
        spherical(m->dist_exp, n, at);
    else if (w->kind == WARP_TOROIDAL)
        toroidal(m->major_radius, m->dist_exp, n, at);
    else if (w->kind == WARP_CUBIC)
        cubic(n, at);
    else
        planar(m->distance, n, at);
    if (m->orientation.z != 1.0)
        orient(m->orientation, n, at);
}

/* ---- all of them ---- */

SIMD_CLONES static void add_scaled(const vec_lanes *restrict v, pov_vec3 by, uint32_t n, vec_lanes *restrict at)
{
    for (uint32_t i = 0; i < n; i++) {
        at->x[i] += by.x * v->x[i];
        at->y[i] += by.y * v->y[i];
        at->z[i] += by.z * v->z[i];
    }
}

void warp_displace(const turbulence *by, const noise_tables *noise, vec_lanes *at, uint32_t n)
{
    vec_lanes v;

    noise_vector_turbulence(noise, by, at, n, &v);
    add_scaled(&v, by->amount, n, at);
    for (uint32_t i = n; i < lanes_whole(n); i++)
        lanes_put(at, i, lanes_at(at, n - 1));
}

SIMD_CLONES static void transform(const double (*restrict m)[4], uint32_t n, vec_lanes *restrict at)
{
    for (uint32_t i = 0; i < n; i++) {
        const double x = at->x[i], y = at->y[i], z = at->z[i];

        at->x[i] = m[0][0] * x + m[0][1] * y + m[0][2] * z + m[0][3];
        at->y[i] = m[1][0] * x + m[1][1] * y + m[1][2] * z + m[1][3];
        at->z[i] = m[2][0] * x + m[2][1] * y + m[2][2] * z + m[2][3];
    }
}

void warp_apply(const warp *w, const noise_tables *noise, vec_lanes *at, uint32_t n)
{
    const uint32_t whole = lanes_whole(n);

    for (; w; w = w->next) {
        if (w->kind == WARP_REPEAT)
            repeat(&w->as.repeat, at, whole);
        else if (w->kind == WARP_BLACK_HOLE)
            black_hole(&w->as.black_hole, noise, at, whole);
        else if (w->kind == WARP_TURBULENCE)
            warp_displace(&w->as.turbulence, noise, at, n);
        else
            map(w, at, whole);
        if (w->has_map)
            transform(w->map, whole, at);
    }
}

bool warp_needs_noise(const warp *w)
{
    while (w && w->kind != WARP_TURBULENCE && !(w->kind == WARP_BLACK_HOLE && is_turbulent(&w->as.black_hole)))
        w = w->next;
    return w != NULL;
}
