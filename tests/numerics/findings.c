#include "numerics/findings.h"

#include "numerics/draw.h"

static int whole(int lo, int hi) { return lo + (int)((hi - lo + 1) * U()); }
static double whole_place(void) { return whole(-1000, 1000); }
static pov_vec3 whole_vector(int reach) { return pov_vec3_of(whole(-reach, reach), whole(-reach, reach), whole(-reach, reach)); }

static pov_vec3 row(const double *m, int at) { return pov_vec3_of(m[at], m[at + 1], m[at + 2]); }

static void put_map(double *m, int at, pov_vec3 v)
{
    m[at] = v.x;
    m[at + 1] = v.y;
    m[at + 2] = v.z;
}

/* ---- points that lie on a surface exactly: whole numbers, times a power of two at the end ---- */

/* Whole numbers of which the squares of three add up to that of the fourth. */
static double quadruple(pov_vec3 *v)
{
    double m, n, p, r;

    do {
        m = whole(-8, 8), n = whole(-8, 8), p = whole(-8, 8), r = whole(-8, 8);
    } while (m == 0.0 && n == 0.0 && p == 0.0 && r == 0.0);
    *v = pov_vec3_of(m * m + n * n - p * p - r * r, 2.0 * (m * r + n * p), 2.0 * (n * r - m * p));
    return m * m + n * n + p * p + r * r;
}

static double triple(double *a, double *b)
{
    const double m = whole(1, 9), n = whole(0, 9), x = m * m - n * n, y = 2.0 * m * n;
    const bool turned = U() < 0.5;

    *a = either(turned ? y : x);
    *b = either(turned ? x : y);
    return m * m + n * n;
}

static pov_vec3 along_axis(int axis, double along, double a, double b)
{
    double v[3];

    v[axis] = along;
    v[(axis + 1) % 3] = a;
    v[(axis + 2) % 3] = b;
    return pov_vec3_of(v[0], v[1], v[2]);
}

static void on_sphere(question *q)
{
    const pov_vec3 centre = whole_vector(1000);

    q->p.number[3] = quadruple(&q->normal);
    put(&q->p, 0, centre);
    q->p.count = 4;
    q->on = pov_add(centre, q->normal);
    q->p.size = q->p.number[3];
}

/* Of any corners, or of whole ones. */
static void on_box(question *q, bool is_whole)
{
    const pov_vec3 place = small_place(1.0);
    double v[3], n[3] = { 0.0, 0.0, 0.0 };
    const int axis = whole(0, 2), side = whole(0, 1);
    int i;

    families_shape(&q->p, 1.0, place);
    for (i = 0; i < 3 && is_whole; i++) {
        q->p.number[i] = whole_place();
        q->p.number[3 + i] = q->p.number[i] + whole(1, 50);
    }
    for (i = 0; i < 3; i++)
        v[i] = i == axis ? q->p.number[i + 3 * side] : floor(1024.0 * between(q->p.number[i], q->p.number[3 + i])) / 1024.0;
    n[axis] = side ? 1.0 : -1.0;
    q->on = pov_vec3_of(v[0], v[1], v[2]);
    q->normal = pov_vec3_of(n[0], n[1], n[2]);
}

/* A cone's side has a slope of a whole number, so that radii are whole where heights are. */
static void on_side(question *q, int axis, pov_vec3 base)
{
    double a, b;
    const double r = triple(&a, &b), slope = whole(1, 3), more = whole(1, 50), less = whole(0, (int)r - 1 < 0 ? 0 : (int)r - 1);
    const int top = q->p.kind == CONE ? 4 : 3;
    const bool is_cone = q->p.kind == CONE;
    const double below = is_cone ? slope * more : more, above = is_cone ? slope * (r - less) : whole(1, 50);

    q->p.number[is_cone ? 3 : 6] = is_cone ? r + more : r;
    if (is_cone)
        q->p.number[7] = less;
    put(&q->p, 0, base);
    put(&q->p, top, pov_add(base, along_axis(axis, below + above, 0.0, 0.0)));
    q->on = pov_add(base, along_axis(axis, below, a, b));
    q->normal = pov_unit(along_axis(axis, is_cone ? r / slope : 0.0, a, b));
    q->p.size = r < below + above ? r : below + above;
}

/* On the cap of one that leans as it likes. */
static void on_cap(question *q, pov_vec3 base)
{
    const int top = q->p.kind == CONE ? 4 : 3;
    pov_vec3 axis;
    double u, v, r;

    do
        axis = whole_vector(9);
    while (axis.x == 0.0 || axis.y == 0.0);
    u = whole(-9, 9), v = whole(-9, 9);
    q->normal = axis;
    q->on = pov_add(base, pov_vec3_of(u * axis.y, v * axis.z - u * axis.x, -v * axis.y));
    r = floor(sqrt(pov_dot(pov_sub(q->on, base), pov_sub(q->on, base)))) + whole(1, 20);
    q->p.number[q->p.kind == CONE ? 3 : 6] = r;
    if (q->p.kind == CONE)
        q->p.number[7] = r + whole(1, 9);
    put(&q->p, 0, base);
    put(&q->p, top, pov_sub(base, axis));
    q->p.size = fmin(r, sqrt(pov_dot(axis, axis)));
}

static void on_cone(question *q)
{
    const pov_vec3 base = whole_vector(1000);

    if (U() < 0.5)
        on_side(q, whole(0, 2), base);
    else
        on_cap(q, base);
    q->p.count = q->p.kind == CONE ? 8 : 7;
}

/* Any whole coefficients, and a whole point: the last of them puts it on the surface. */
static void on_quadric(question *q)
{
    const pov_vec3 at = whole_vector(U() < 0.5 ? 9 : 1000);
    double *c = q->p.number;
    pov_vec3 half;
    int i;

    do {
        for (i = 0; i < 9; i++)
            c[i] = U() < 0.4 ? 0.0 : whole(-9, 9);
        half = pov_vec3_of(c[0] * at.x + c[3] * at.y + c[6], c[1] * at.y + c[5] * at.z + c[7], c[2] * at.z + c[4] * at.x + c[8]);
        q->normal = pov_vec3_of(half.x + c[0] * at.x + c[4] * at.z, half.y + c[1] * at.y + c[3] * at.x,
                                half.z + c[2] * at.z + c[5] * at.y);
        c[9] = -pov_dot(half, at);
    } while (pov_dot(q->normal, q->normal) == 0.0 || (c[0] == 0.0 && c[1] == 0.0 && c[2] == 0.0 && c[3] == 0.0 && c[4] == 0.0 && c[5] == 0.0));
    q->p.count = 10;
    q->on = at;
    q->p.size = fmax(1.0, pov_largest(at));
}

/* Whole vectors across a normal of whole numbers, added up. */
static pov_vec3 whole_across(pov_vec3 n)
{
    const double u = whole(-9, 9), v = whole(-9, 9), w = whole(-9, 9);

    return pov_vec3_of(u * n.y - w * n.z, v * n.z - u * n.x, w * n.x - v * n.y);
}

/* A normal of whole length, so that the distance from the origin is whole where the plane goes through whole places. */
static void on_plane(question *q)
{
    double length;

    do
        length = quadruple(&q->normal);
    while (length > 1e4);
    q->p.number[3] = length * whole(-9, 9);
    q->on = pov_add(pov_scale(q->normal, q->p.number[3] / length), whole_across(q->normal));
    put(&q->p, 0, q->normal);
    q->p.count = 4;
    q->p.size = fmax(1.0, pov_largest(q->on));
}

static void on_disc(question *q)
{
    const pov_vec3 centre = whole_vector(1000);
    pov_vec3 to;
    double out;

    do {
        q->normal = whole_vector(9);
        to = whole_across(q->normal);
    } while (pov_largest(q->normal) == 0.0 || pov_largest(to) == 0.0);
    out = floor(sqrt(pov_dot(to, to)));
    put(&q->p, 0, centre);
    put(&q->p, 3, q->normal);
    q->p.number[6] = out + whole(1, 20);
    q->p.number[7] = U() < 0.5 ? 0.0 : floor(out * U());
    q->p.count = 8;
    q->on = pov_add(centre, to);
    q->p.size = q->p.number[6];
}

/* Whole numbers along the tube and around the axis. */
static void on_torus(question *q)
{
    double along, up, x, z, out, tube;

    do {
        tube = triple(&along, &up);
        out = triple(&x, &z);
    } while (!(out > along));
    q->p.number[0] = out - along;
    q->p.number[1] = tube;
    q->p.count = 2;
    q->on = pov_vec3_of(x, up, z);
    q->normal = pov_vec3_of(along * x / out, up, along * z / out);
    q->p.size = q->p.number[0] + tube;
}

/* Corners and point in a plane through whole places. */
static void on_flat(question *q)
{
    double s = whole(1, 127) / 256.0, t = whole(1, 128) / 256.0;
    pov_vec3 a, b, c;

    families_shape(&q->p, 1.0, small_place(1.0));
    a = get(&q->p, 1), b = get(&q->p, 4), c = get(&q->p, 7);
    if (U() < 0.5)
        s = 1.0 - s - t;
    q->on = pov_add(a, pov_add(pov_scale(pov_sub(b, a), s), pov_scale(pov_sub(c, a), t)));
    q->normal = pov_cross_product(pov_sub(b, a), pov_sub(c, a));
}

/* A map of small whole numbers: stretched, sheared, turned over. The point is moved without a rounding. */
static void map_whole(question *q)
{
    double *m = q->matrix, n[3], det;
    const pov_vec3 at = q->on;
    int i;

    do {
        for (i = 0; i < MATRIX; i++)
            m[i] = i < 9 ? whole(-3, 3) : whole_place();
        det = m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) + m[2] * (m[3] * m[7] - m[4] * m[6]);
    } while (det == 0.0);
    for (i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;

        n[i] = (q->normal.x * (m[3 + j] * m[6 + k] - m[3 + k] * m[6 + j]) + q->normal.y * (m[6 + j] * m[k] - m[6 + k] * m[j])
                + q->normal.z * (m[j] * m[3 + k] - m[k] * m[3 + j])) / det;
    }
    q->on = pov_vec3_of(at.x * m[0] + at.y * m[3] + at.z * m[6] + m[9], at.x * m[1] + at.y * m[4] + at.z * m[7] + m[10],
                        at.x * m[2] + at.y * m[5] + at.z * m[8] + m[11]);
    q->normal = pov_vec3_of(n[0], n[1], n[2]);
    q->mapped = true;
}

static void scale_all(question *q, double power)
{
    int i;

    probe_scale(&q->p, power);
    q->on = pov_scale(q->on, power);
    for (i = 9; i < MATRIX; i++)
        q->matrix[i] *= power;
}

/* parameter: 1 maps it */
static void make_on(question *q, double parameter)
{
    if (q->p.kind == SPHERE)
        on_sphere(q);
    else if (q->p.kind == BOX)
        on_box(q, parameter > 0.0);
    else if (q->p.kind == QUADRIC)
        on_quadric(q);
    else if (kind_has_corners(q->p.kind))
        on_flat(q);
    else if (q->p.kind == PLANE)
        on_plane(q);
    else if (q->p.kind == DISC)
        on_disc(q);
    else if (q->p.kind == TORUS)
        on_torus(q);
    else
        on_cone(q);
    if (parameter > 0.0)
        map_whole(q);
    q->normal = pov_unit(q->normal);
    scale_all(q, ldexp(1.0, whole(-40, 40)));
}

/* ---- rays ---- */

/* Any direction, or one that grazes the surface at 1e-8 at least. */
static pov_vec3 off(const question *q, double least)
{
    if (U() < 0.5)
        return families_direction();
    return pov_unit(pov_add(across(q->normal), pov_scale(q->normal, either(log_between(least, 0.0)))));
}

static void start_on(question *q, double parameter)
{
    (void)parameter;
    ray_of(&q->p, q->on, off(q, -8.0));
}

static void segment(question *q, pov_vec3 from, pov_vec3 to)
{
    ray_of(&q->p, from, pov_sub(to, from));
    q->to = to;
}

/* parameter: sizes that it is seen from, at most, as an exponent of ten */
static void end_on(question *q, double parameter)
{
    segment(q, pov_add(q->on, pov_scale(off(q, -4.0), q->p.size * log_between(0.0, parameter))), q->on);
}

/* 1e-16 to 1e-5 sizes off the surface. */
static void end_near(question *q, double parameter)
{
    const pov_vec3 to = pov_add(q->on, pov_scale(q->normal, either(q->p.size * log_between(-16.0, -5.0))));

    segment(q, pov_add(to, pov_scale(off(q, -4.0), q->p.size * log_between(0.0, parameter))), to);
}

/* The place of a light: the point, or an ulp from it. */
static void light_on(question *q, double parameter)
{
    (void)parameter;
    q->to = q->on;
    if (U() < 0.66)
        q->to.y = nextafter(q->to.y, either(HUGE_VAL));
}

/* ---- shapes whose distances or normals lay beyond the promise ---- */

/* parameter: the cosine that it is met at, as an exponent of ten, at least. From 1e-13 to 1e2 sizes away. */
static void graze(question *q, double parameter)
{
    const pov_vec3 dir = pov_unit(pov_add(across(q->normal), pov_scale(q->normal, either(log_between(parameter, 0.0)))));
    const double away = U() < 0.5 ? log_between(-13.0, -1.0) : log_between(-1.0, 2.0);

    ray_of(&q->p, pov_sub(q->on, pov_scale(dir, q->p.size * away)), dir);
}

static void make_any(question *q, double parameter)
{
    const pov_vec3 place = small_place(1.0);

    (void)parameter;
    families_shape(&q->p, 1.0, place);
    families_point(&q->p, place, &q->on, &q->normal);
}

/* parameter: width over length, as an exponent of ten, at least */
static void make_sliver(question *q, double parameter)
{
    const pov_vec3 a = small_place(1.0), b = pov_add(a, families_direction());
    const double width = log_between(parameter, -3.0);
    const pov_vec3 c = pov_add(a, pov_add(pov_scale(pov_sub(b, a), U()), pov_scale(families_direction(), width)));

    q->p.number[0] = 4.0;
    put(&q->p, 1, a);
    put(&q->p, 4, b);
    put(&q->p, 7, c);
    put(&q->p, 10, a);
    q->p.count = 13;
    q->p.size = 1.0;
    q->on = pov_add(pov_add(a, pov_scale(pov_sub(b, a), 0.5 * U())), pov_scale(pov_sub(c, a), 0.5 * U()));
    q->normal = pov_unit(pov_cross_product(pov_sub(b, a), pov_sub(c, a)));
}

/* parameter: the second order over the first, as an exponent of ten, at least */
static void make_nearly_plane(question *q, double parameter)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    int i;

    for (i = 0; i < 9; i++)
        q->p.number[i] = either(i < 6 ? log_between(parameter, -3.0) : log_between(-2.0, 0.0));
    q->p.number[9] = 0.1 * U();
    q->p.count = 10;
    q->p.size = 1.0;
    families_point(&q->p, zero, &q->on, &q->normal);
}

/* parameter: how far away it is written out, in sizes */
static void make_far_quadric(question *q, double parameter)
{
    const pov_vec3 at = pov_scale(families_direction(), parameter);
    const pov_vec3 place = pov_vec3_of(floor(at.x), floor(at.y), floor(at.z));

    families_shape(&q->p, 1.0, place);
    families_point(&q->p, place, &q->on, &q->normal);
}

/* Two planes through whole places, that are not one. */
static void make_planes(question *q, double parameter)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    const double d = whole(-4, 4), e = whole(-4, 4);
    double *c = q->p.number;
    pov_vec3 a, b;

    (void)parameter;
    do
        a = whole_vector(4), b = whole_vector(4);
    while (pov_largest(pov_cross_product(a, b)) == 0.0);
    c[0] = a.x * b.x, c[1] = a.y * b.y, c[2] = a.z * b.z;
    c[3] = a.x * b.y + a.y * b.x, c[4] = a.x * b.z + a.z * b.x, c[5] = a.y * b.z + a.z * b.y;
    c[6] = a.x * e + b.x * d, c[7] = a.y * e + b.y * d, c[8] = a.z * e + b.z * d;
    c[9] = d * e;
    q->p.count = 10;
    q->p.size = 1.0;
    families_point(&q->p, zero, &q->on, &q->normal);
}

/* A map of any numbers: uneven, and for half of them sheared. parameter: the largest factor, as an exponent of ten. */
static void make_mapped(question *q, double parameter)
{
    double *m = q->matrix;
    pov_vec3 at, n, x, y, z;
    double s[3];
    int i;

    make_any(q, 0.0);
    x = families_direction(), y = across(x), z = pov_cross_product(x, y);
    if (U() < 0.5)
        y = pov_add(y, pov_scale(x, either(2.0 * U())));
    for (i = 0; i < 3; i++)
        s[i] = log_between(-parameter, parameter);
    put_map(m, 0, pov_scale(x, s[0]));
    put_map(m, 3, pov_scale(y, s[1]));
    put_map(m, 6, pov_scale(z, s[2]));
    put_map(m, 9, small_place(10.0));
    at = q->on, n = q->normal;
    x = row(m, 0), y = row(m, 3), z = row(m, 6);
    q->on = pov_add(row(m, 9), pov_add(pov_scale(x, at.x), pov_add(pov_scale(y, at.y), pov_scale(z, at.z))));
    q->normal = pov_unit(pov_add(pov_scale(pov_cross_product(y, z), n.x), pov_add(pov_scale(pov_cross_product(z, x), n.y),
                         pov_scale(pov_cross_product(x, y), n.z))));
    q->mapped = true;
}

/* parameter: distance over size, as an exponent of ten */
static void from_far(question *q, double parameter)
{
    const pov_vec3 dir = off(q, -6.0);
    const pov_vec3 org = pov_sub(q->on, pov_scale(dir, pow(10.0, parameter * U())));

    ray_of(&q->p, org, pov_unit(pov_sub(q->on, org)));
}

/* In the plane of a face or a cap, and across it by a component that is all but zero. */
static void make_upright(question *q, double parameter)
{
    (void)parameter;
    if (q->p.kind == BOX) {
        on_box(q, U() < 0.5);
    } else {
        on_side(q, whole(0, 2), whole_vector(1000));
        q->p.count = q->p.kind == CONE ? 8 : 7;
    }
}

static void leave_plane(question *q, double parameter)
{
    static const double tiny[] = { 5e-324, 1e-310, 2.2250738585072014e-308, 1e-305, 1e-300 };
    const pov_vec3 to = pov_add(q->on, pov_scale(families_direction(), q->p.size)), away = families_direction();
    const bool is_box = q->p.kind == BOX;
    const int top = is_box || q->p.kind == CYLINDER ? 3 : 4, side = whole(0, 1);
    const pov_vec3 base = get(&q->p, 0), other = get(&q->p, top), axis = pov_sub(other, base);
    const double b[3] = { base.x, base.y, base.z }, o[3] = { other.x, other.y, other.z };
    double d[3] = { away.x, away.y, away.z }, v[3] = { to.x, to.y, to.z };
    const int across_it = is_box ? whole(0, 2) : axis.x != 0.0 ? 0 : axis.y != 0.0 ? 1 : 2;
    int i;

    (void)parameter;
    v[across_it] = side ? o[across_it] : b[across_it];
    d[across_it] = either(tiny[whole(0, 4)]);
    if (U() < 0.4)
        d[(across_it + 1) % 3] = either(U() < 0.5 ? 0.0 : 1.0);
    for (i = 0; i < 3; i++)
        v[i] -= i == across_it ? 0.0 : d[i] * q->p.size * 4.0 * U();
    ray_of(&q->p, pov_vec3_of(v[0], v[1], v[2]), pov_vec3_of(d[0], d[1], d[2]));
}

enum {
    FLAT = 1u << POLYGON | 1u << TRIANGLE | 1u << MESH | 1u << SMOOTH_TRIANGLE, ALL = (1u << KINDS) - 1, SECOND = 1u << QUADRIC,
    UPRIGHT = 1u << BOX | 1u << CONE | 1u << CYLINDER
};

const finding findings[] = {
    { "n1_starts_on_a_surface", ALL, A_RAY, 512, 1e-13, make_on, 0.0, start_on, 0.0 },
    { "n1_starts_on_a_mapped_surface", ALL, A_RAY, 512, 1e-13, make_on, 1.0, start_on, 0.0 },
    { "n2_segments_that_end_near_a_surface", ALL, A_SEGMENT, 512, 0.0, make_any, 0.0, end_near, 12.0 },
    { "n2_segments_that_end_on_a_surface", ALL, A_SEGMENT, 512, 0.0, make_on, 0.0, end_on, 12.0 },
    { "n2_segments_that_end_near_a_mapped_surface", ALL, A_SEGMENT, 512, 0.0, make_mapped, 2.0, end_near, 12.0 },
    { "n2_segments_that_end_on_a_mapped_surface", ALL, A_SEGMENT, 512, 0.0, make_on, 1.0, end_on, 12.0 },
    { "n3_lights_on_a_surface", ALL, A_LIGHT, 512, 0.0, make_on, 0.0, light_on, 0.0 },
    { "n5_grazed_slivers", FLAT, A_RAY, 512, 1e-13, make_sliver, -13.0, graze, -13.0 },
    { "n5_grazed_quadrics_that_are_nearly_planes", SECOND, A_RAY, 512, 1e-13, make_nearly_plane, -9.0, graze, -15.0 },
    { "n5_quadrics_written_out_far_away", SECOND, A_RAY, 512, 1e-13, make_far_quadric, 1e8, graze, -8.0 },
    { "n5_starts_near_a_surface_that_graze_it", ALL, A_RAY, 512, 1e-13, make_any, 0.0, graze, -9.0 },
    { "n5_uneven_and_sheared_maps", ALL, A_RAY, 512, 1e-12, make_mapped, 2.0, graze, -9.0 },
    { "n6_denormal_components_leave_a_plane", UPRIGHT, A_RAY, 4096, 1e-13, make_upright, 0.0, leave_plane, 0.0 },
    { "n7_uneven_maps_from_far_away", ALL, A_RAY, 512, 1e-12, make_mapped, 2.0, from_far, 12.0 },
    { "n7_pairs_of_planes", SECOND, A_RAY, 512, 1e-10, make_planes, 0.0, graze, -12.0 },
    { NULL, 0, A_RAY, 0, 0.0, NULL, 0.0, NULL, 0.0 },
};
