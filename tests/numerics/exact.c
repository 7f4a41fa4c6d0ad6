/* exact.c - the primitives once more, by the plainest mathematics there is, in 512 bits. */
#include "numerics/exact_torus.h"
#include "numerics/probe.h"

typedef struct line { real3 o, d; } line;

static real3 point(const double *v) { return real3_of(real_of(v[0]), real_of(v[1]), real_of(v[2])); }

static real3 in_dd(pov_vec3 hi, pov_vec3 lo)
{
    return real3_of(real_of2(hi.x, lo.x), real_of2(hi.y, lo.y), real_of2(hi.z, lo.z));
}

static void add(exact_result *out, real t, uint32_t feature, real3 normal, double clearance)
{
    const real length = real_sqrt(real3_dot(normal, normal));
    exact_crossing c, *at = out->at;
    int i = out->count;

    c.t = t;
    c.feature = feature;
    c.clearance = clearance;
    c.normal[0] = real_double(real_div(normal.x, length));
    c.normal[1] = real_double(real_div(normal.y, length));
    c.normal[2] = real_double(real_div(normal.z, length));
    for (; i > 0 && real_compare(t, at[i - 1].t) < 0; i--)
        at[i] = at[i - 1];
    at[i] = c;
    out->count++;
}

/* Roots of a t^2 + 2 b t + c: entering where the value falls. Gives how many. */
static int roots(real a, real b, real c, real t[2], uint32_t feature[2])
{
    const real discriminant = real_sub(real_mul(b, b), real_mul(a, c));
    const bool rises = real_sign(b) > 0;
    real sum;

    if (real_sign(discriminant) < 0 || (real_sign(a) == 0 && real_sign(b) == 0))
        return 0;
    /* Neither root is a difference: 512 bits are not enough for roots 1e200 apart. */
    sum = rises ? real_neg(real_add(b, real_sqrt(discriminant))) : real_sub(real_sqrt(discriminant), b);
    feature[0] = rises;
    feature[1] = !rises;
    t[0] = t[1] = sum;
    if (real_sign(sum) != 0)
        t[0] = real_div(c, sum);
    if (real_sign(a) == 0)
        return 1;
    t[1] = real_div(sum, a);
    return 2;
}

static void sphere(const probe *p, line l, exact_result *out)
{
    const real3 f = real3_sub(l.o, point(p->number));
    const real r = real_of(p->number[3]);
    uint32_t feature[2];
    real t[2];
    int n = roots(real3_dot(l.d, l.d), real3_dot(f, l.d), real_sub(real3_dot(f, f), real_mul(r, r)), t, feature), i;

    for (i = 0; i < n; i++)
        add(out, t[i], feature[i], real3_add(f, real3_scale(l.d, t[i])), HUGE_VAL);
}

static real component(real3 v, int i) { return i == 0 ? v.x : i == 1 ? v.y : v.z; }

static real3 axis_vector(int feature)
{
    const real zero = real_of(0.0), one = real_of(feature % 2 ? 1.0 : -1.0);
    return real3_of(feature / 2 == 0 ? one : zero, feature / 2 == 1 ? one : zero, feature / 2 == 2 ? one : zero);
}

static void box(const probe *p, line l, exact_result *out)
{
    int entry = -1, leave = -1, i;
    real first = NULL, last = NULL;

    for (i = 0; i < 3; i++) {
        const double a = p->number[i], b = p->number[3 + i];
        const real lo = real_of(a < b ? a : b), hi = real_of(a < b ? b : a), o = component(l.o, i),
                   d = component(l.d, i);
        const int up = real_sign(d) > 0;
        real near, far;

        if (real_sign(d) == 0) {
            if (real_compare(o, lo) < 0 || real_compare(o, hi) > 0)
                return;
            continue;
        }
        near = real_div(real_sub(up ? lo : hi, o), d);
        far = real_div(real_sub(up ? hi : lo, o), d);
        if (entry < 0 || real_compare(near, first) > 0) {
            entry = 2 * i + !up;
            first = near;
        }
        if (leave < 0 || real_compare(far, last) < 0) {
            leave = 2 * i + up;
            last = far;
        }
    }
    if (entry < 0 || real_compare(first, last) > 0)
        return;
    add(out, first, (uint32_t)entry, axis_vector(entry), HUGE_VAL);
    if (entry / 2 == leave / 2 && p->number[entry / 2] == p->number[3 + entry / 2])
        return;   /* planar: one surface */
    add(out, last, (uint32_t)leave, axis_vector(leave), HUGE_VAL);
}

/* Roots on the infinite double cone that lie between the ends, and caps within their radius. */
static void cone(const probe *p, line l, const double *base, double r0, const double *top, double r1,
                 exact_result *out)
{
    const real3 a = real3_sub(point(top), point(base)), f = real3_sub(l.o, point(base));
    const real m = real3_dot(a, a), y = real_div(real3_dot(f, a), m), e = real_div(real3_dot(l.d, a), m);
    const real k = real_sub(real_of(r1), real_of(r0)), r = real_add(real_of(r0), real_mul(k, y)), s = real_mul(k, e);
    const real3 w = real3_sub(f, real3_scale(a, y)), v = real3_sub(l.d, real3_scale(a, e));
    const real one = real_of(1.0);
    uint32_t feature[2];
    real t[2];
    int n = roots(real_sub(real3_dot(v, v), real_mul(s, s)), real_sub(real3_dot(w, v), real_mul(r, s)),
                  real_sub(real3_dot(w, w), real_mul(r, r)), t, feature), i;

    for (i = 0; i < n; i++) {
        const real height = real_add(y, real_mul(t[i], e)), radius = real_add(r, real_mul(t[i], s));

        if (real_sign(height) >= 0 && real_compare(height, one) <= 0) {
            const real3 normal =
                real3_sub(real3_add(w, real3_scale(v, t[i])), real3_scale(a, real_div(real_mul(k, radius), m)));

            add(out, t[i], feature[i], normal, fabs(real_double(radius)));
        }
    }
    for (i = 0; i < 2 && !p->open && real_sign(e) != 0; i++) {
        const real at = real_div(real_sub(i ? one : real_of(0.0), y), e), limit = real_of(i ? r1 : r0);
        const real3 from_axis = real3_add(w, real3_scale(v, at));

        if (real_compare(real3_dot(from_axis, from_axis), real_mul(limit, limit)) <= 0)
            add(out, at, 2 + (uint32_t)i, i ? a : real3_scale(a, real_of(-1.0)), HUGE_VAL);
    }
}

static real3 gradient(const double *q, real3 p, bool linear)
{
    const real two = real_of(2.0), zero = real_of(0.0), d = real_of(q[3]), e = real_of(q[4]), f = real_of(q[5]);
    real3 g = real3_of(linear ? real_of(q[6]) : zero, linear ? real_of(q[7]) : zero, linear ? real_of(q[8]) : zero);

    g = real3_add(g, real3_scale(real3_of(real_mul(real_of(q[0]), p.x), real_mul(real_of(q[1]), p.y),
                                          real_mul(real_of(q[2]), p.z)), two));
    return real3_add(g, real3_of(real_add(real_mul(d, p.y), real_mul(e, p.z)),
                                 real_add(real_mul(d, p.x), real_mul(f, p.z)),
                                 real_add(real_mul(e, p.x), real_mul(f, p.y))));
}

static void quadric(const probe *p, line l, exact_result *out)
{
    const double *q = p->number;
    const real half = real_of(0.5);
    const real3 linear = real3_of(real_of(q[6]), real_of(q[7]), real_of(q[8]));
    const real a = real_mul(half, real3_dot(l.d, gradient(q, l.d, false)));
    const real b = real_mul(half, real3_dot(l.d, gradient(q, l.o, true)));
    const real c = real_add(real_mul(half, real3_dot(l.o, real3_add(gradient(q, l.o, true), linear))), real_of(q[9]));
    double curvature = 0.0;
    uint32_t feature[2];
    real t[2];
    int n = roots(a, b, c, t, feature), i;

    for (i = 0; i < 6; i++)
        curvature = fmax(curvature, fabs(q[i]));
    for (i = 0; i < n; i++) {
        const real3 g = gradient(q, real3_add(l.o, real3_scale(l.d, t[i])), true);

        add(out, t[i], feature[i], g, real_double(real_sqrt(real3_dot(g, g))) / (2.0 * curvature));
    }
}

/* The axis that the ray goes along most. */
static int forward_of(const probe *p)
{
    const pov_vec3 d = p->ray.dir;

    return fabs(d.x) > fabs(d.y) ? (fabs(d.x) > fabs(d.z) ? 0 : 2) : fabs(d.y) > fabs(d.z) ? 1 : 2;
}

/* In the ray's own view, the other two axes over that one. */
static void view(const probe *p, line l, const double *v, real *across, real *up)
{
    const int forward = forward_of(p);
    const real3 w = real3_sub(point(v), l.o);
    const real depth = real_div(component(w, forward), component(l.d, forward));

    *across = real_sub(component(w, (forward + 1) % 3), real_mul(depth, component(l.d, (forward + 1) % 3)));
    *up = real_sub(component(w, (forward + 2) % 3), real_mul(depth, component(l.d, (forward + 2) % 3)));
}

/* Even-odd: edges that pass the ray to the right, of those that cross its level. The up coordinate divides
 * by the depth's slope, so its sign turns with it; the plugin multiplies. */
static bool polygon_within(const probe *p, line l)
{
    const int n = (p->count - 1) / 3;
    const double *v = p->number + 1, *start = v;
    real across[2] = { NULL, NULL }, up[2] = { NULL, NULL };
    const double d[3] = { p->ray.dir.x, p->ray.dir.y, p->ray.dir.z };
    const int flip = d[forward_of(p)] < 0.0 ? -1 : 1;
    bool within = false;
    int i;

    for (i = 0; i < n; i++, v += 3) {
        const bool starts = v == start;

        view(p, l, v, &across[1], &up[1]);
        if (!starts && (flip * real_sign(up[0]) > 0) != (flip * real_sign(up[1]) > 0)) {
            const real cross = real_sub(real_mul(across[0], up[1]), real_mul(across[1], up[0]));
            const int sign = real_sign(cross) * (flip * real_sign(up[1]) > 0 ? 1 : -1);

            within ^= sign >= 0;
        }
        if (!starts && v[0] == start[0] && v[1] == start[1] && v[2] == start[2])
            start = v + 3;
        across[0] = across[1];
        up[0] = up[1];
    }
    return within;
}

/* The area vector of the largest loop. */
static real3 polygon_normal(const probe *p)
{
    const int n = (p->count - 1) / 3;
    const double *v = p->number + 1, *start = v;
    const real zero = real_of(0.0);
    real3 best = real3_of(zero, zero, zero), sum = best;
    double largest = -1.0;
    int i;

    for (i = 0; i < n; i++, v += 3) {
        if (v == start) {
            sum = real3_of(zero, zero, zero);
            continue;
        }
        sum = real3_add(sum, real3_cross(real3_sub(point(v - 3), point(p->number + 1)),
                                         real3_sub(point(v), point(p->number + 1))));
        if (v[0] == start[0] && v[1] == start[1] && v[2] == start[2]) {
            const double size =
                fmax(fabs(real_double(sum.x)), fmax(fabs(real_double(sum.y)), fabs(real_double(sum.z))));

            if (size > largest) {
                largest = size;
                best = sum;
            }
            start = v + 3;
        }
    }
    return best;
}

static void polygon(const probe *p, line l, exact_result *out)
{
    const real3 n = polygon_normal(p);
    const real slope = real3_dot(n, l.d);

    if (real_sign(slope) != 0 && polygon_within(p, l))
        add(out, real_div(real3_dot(n, real3_sub(point(p->number + 1), l.o)), slope), 0, n, HUGE_VAL);
}

static void torus(const probe *p, line l, exact_result *out)
{
    const real R = real_of(p->number[0]);
    real t[4];
    const int n = exact_torus_roots(R, real_of(p->number[1]), l.o, l.d, t);

    for (int i = 0; i < n; i++) {
        real axis;
        const real3 normal = exact_torus_normal(R, real3_add(l.o, real3_scale(l.d, t[i])), &axis);

        add(out, t[i], real_sign(real3_dot(normal, l.d)) > 0, normal, real_double(axis));
    }
}

/* n . p = d |n| */
static void plane(const probe *p, line l, exact_result *out)
{
    const real3 n = point(p->number);
    const real slope = real3_dot(n, l.d), level = real_mul(real_of(p->number[3]), real_sqrt(real3_dot(n, n)));

    if (real_sign(slope) != 0)
        add(out, real_div(real_sub(level, real3_dot(n, l.o)), slope), real_sign(slope) > 0, n, HUGE_VAL);
}

static void disc(const probe *p, line l, exact_result *out)
{
    const real3 n = point(p->number + 3), from = real3_sub(l.o, point(p->number));
    const real slope = real3_dot(n, l.d), outer = real_of(p->number[6]), inner = real_of(p->number[7]);
    real t, square;
    real3 at;

    if (real_sign(slope) == 0)
        return;
    t = real_neg(real_div(real3_dot(n, from), slope));
    at = real3_add(from, real3_scale(l.d, t));
    square = real3_dot(at, at);
    if (real_compare(square, real_mul(outer, outer)) < 0 && real_compare(square, real_mul(inner, inner)) >= 0)
        add(out, t, 0, n, HUGE_VAL);
}

static void result(const probe *p, line l, exact_result *out)
{
    const double *n = p->number;

    out->count = 0;
    if (p->kind == SPHERE)
        sphere(p, l, out);
    else if (p->kind == BOX)
        box(p, l, out);
    else if (p->kind == CONE && n[7] < n[3])
        cone(p, l, n + 4, n[7], n, n[3], out);
    else if (p->kind == CONE)
        cone(p, l, n, n[3], n + 4, n[7], out);
    else if (p->kind == CYLINDER)
        cone(p, l, n, n[6], n + 3, n[6], out);
    else if (p->kind == QUADRIC)
        quadric(p, l, out);
    else if (p->kind == TORUS)
        torus(p, l, out);
    else if (p->kind == PLANE)
        plane(p, l, out);
    else if (p->kind == DISC)
        disc(p, l, out);
    else
        polygon(p, l, out);
}

void probe_exact(const probe *p, exact_result *out)
{
    const line l = { in_dd(p->ray.org, p->ray.org_lo), in_dd(p->ray.dir, p->ray.dir_lo) };
    result(p, l, out);
}

void probe_exact_line(const probe *p, real3 org, real3 dir, exact_result *out)
{
    const line l = { org, dir };
    result(p, l, out);
}
