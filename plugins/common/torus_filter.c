/* Rays that come to a torus's box: which of them pass the torus, and which certainly hit it, by the sign of the equation along
 * several rays side by side, in doubles with bounds. docs/numerics.md ("Torus") derives these. */
#include "common/torus.h"

enum { TOGETHER = 8, HALF = TOGETHER / 2 };
typedef double lane[TOGETHER];

/* Rays of the scene; own is 1 where the ray starts on the torus. */
typedef struct ray_lanes { lane org[3], dir[3], size, tmax, own; } ray_lanes;

/* The map to a space where the torus's size is of the order of one, and the error of a ray there: of its start `off` and `off_far`
 * times its size, of its direction `off_dir` times that. */
typedef struct space { pov_vec3 anchor, column[3], from; double off, off_far, off_dir; } space;

/* 1 where a ray certainly passes the torus, or certainly hits it between two distances. */
typedef struct outcomes { lane passed, hit, lo, hi; } outcomes;

static double sum_of_sizes(pov_vec3 v) { return fabs(v.x) + fabs(v.y) + fabs(v.z); }

static void find_space(const pov_own_map *map, double scale, space *out)
{
    double most = 0.0;

    out->anchor = map->anchor;
    out->from = pov_scale(map->from, scale);
    for (int i = 0; i < 3; i++) {
        out->column[i] = pov_scale(map->column[i], scale);
        most = common_greater(most, pov_largest(out->column[i]));
    }
    out->off_far = out->off_dir = 0x1p-48 * most;
    out->off = out->off_far * sum_of_sizes(out->anchor) + 0x1p-48 * sum_of_sizes(out->from);
}

COMMON_INLINE pov_vec3 turn(const space *to, double x, double y, double z)
{
    const pov_vec3 *c = to->column;

    return pov_vec3_of(c[0].x * x + c[1].x * y + c[2].x * z, c[0].y * x + c[1].y * y + c[2].y * z, c[0].z * x + c[1].z * y + c[2].z * z);
}

COMMON_INLINE double half_of(double a, double b) { return 0.5 * (a + b); }

/* Bernstein coefficients of a piece, in the order of the ray. */
typedef struct quartic { double b0, b1, b2, b3, b4; } quartic;

COMMON_INLINE void halve(quartic q, quartic *left, quartic *right)
{
    const double c0 = half_of(q.b0, q.b1), c1 = half_of(q.b1, q.b2), c2 = half_of(q.b2, q.b3), c3 = half_of(q.b3, q.b4);
    const double d0 = half_of(c0, c1), d1 = half_of(c1, c2), d2 = half_of(c2, c3), e0 = half_of(d0, d1), e1 = half_of(d1, d2);
    const double middle = half_of(e0, e1);
    const quartic l = { q.b0, c0, d0, e0, middle }, r = { middle, e1, d2, c3, q.b4 };

    *left = l;
    *right = r;
}

COMMON_INLINE double least_of(quartic q)
{
    return common_lesser(common_lesser(common_lesser(q.b0, q.b1), common_lesser(q.b2, q.b3)), q.b4);
}

COMMON_INLINE quartic bernstein(const double a[5])
{
    const double even = a[0] + a[4], odd = 0.5 * (a[1] - a[3]), square = a[2] * (1.0 / 3.0);
    const quartic q = { (even + a[2]) - (a[1] + a[3]), (a[0] - a[4]) - odd, even - square, (a[0] - a[4]) + odd, (even + a[2]) + (a[1] + a[3]) };

    return q;
}

/* The least coefficient ahead of a start at x, whose root is divided out. */
COMMON_INLINE double least_ahead(const double a[5], double x)
{
    const double c3 = a[4], c2 = a[3] + c3 * x, c1 = a[2] + c2 * x, c0 = a[1] + c1 * x, m = 0.5 * (1.0 + x), h = 0.5 * (1.0 - x);
    const double d0 = c0 + m * (c1 + m * (c2 + m * c3)), d1 = h * (c1 + m * (2.0 * c2 + 3.0 * m * c3)), d2 = h * h * (c2 + 3.0 * m * c3);
    const double d3 = h * h * h * c3, part = (d1 + d2) * (1.0 / 3.0), other = (d1 - d2) * (1.0 / 3.0);
    const double b0 = d0 - d1 + d2 - d3, b1 = d0 - part + d3, b2 = d0 + other - d3, b3 = d0 + d1 + d2 + d3;
    const double e0 = half_of(b0, b1), e1 = half_of(b1, b2), e2 = half_of(b2, b3), f0 = half_of(e0, e1), f1 = half_of(e1, e2);

    return common_lesser(common_lesser(common_lesser(b0, b3), common_lesser(e0, e2)), common_lesser(common_lesser(f0, f1), half_of(f0, f1)));
}

/* The ray's part within the sphere and the slab around the torus, widened by all errors: its length is below zero if there is none. */
typedef struct part { stretch s; double length, off; } part;

COMMON_INLINE part part_of(const torus *t, const space *to, const ray_lanes *l, uint32_t i)
{
    const double dx = l->dir[0][i], dy = l->dir[1][i], dz = l->dir[2][i], reach = t->R + t->r;
    const pov_vec3 p = turn(to, l->org[0][i] - to->anchor.x, l->org[1][i] - to->anchor.y, l->org[2][i] - to->anchor.z);
    const pov_vec3 o = pov_add(p, to->from), d = turn(to, dx, dy, dz);
    const double square = pov_dot(d, d), inverse = 1.0 / square, middle = -pov_dot(o, d) * inverse;
    const pov_vec3 w = pov_add(o, pov_scale(d, middle));
    const double within = reach * reach * (1.0 + 0x1p-20) - pov_dot(w, w), half = sqrt(common_greater(within, 0x1p-30) * inverse);
    const double off = 2.0 * (to->off + to->off_far * l->size[i] + (fabs(middle) + half) * to->off_dir * (fabs(dx) + fabs(dy) + fabs(dz)));
    const double high = t->r * (1.0 + 0x1p-20) + off + 0x1p-46, slope = fabs(d.y) > 1e-200 ? d.y : 1e-200;
    const double a = (-high - w.y) / slope, b = (high - w.y) / slope;
    const double from = common_greater(common_lesser(a, b), -half), end = common_lesser(common_greater(a, b), half);
    part out;

    out.length = within + 16.0 * off < 0.0 ? -1.0 : end - from;
    out.off = square > 1e-200 ? square < 1e200 ? off : HUGE_VAL : HUGE_VAL;
    out.s.torus = t;
    out.s.ray.d = d;
    out.s.middle = middle + 0.5 * (from + end);
    out.s.half = out.length > 0.0 ? 0.5 * out.length : 0x1p-30 * half;
    out.s.w = pov_two3_of(pov_add(w, pov_scale(d, 0.5 * (from + end))), pov_vec3_of(0.0, 0.0, 0.0));
    out.s.lost = 16.0 * off;
    return out;
}

/* 1 if a piece of the part certainly lies outside of the torus, or before the start or behind the end; else 0. */
COMMON_INLINE double is_clear(quartic q, double error, double from, double end, double start, double last)
{
    const double outside = least_of(q) > error ? 1.0 : 0.0, before = end < start ? 1.0 : outside;

    return from > last ? 1.0 : before;
}

COMMON_INLINE void look_at(const torus *t, const space *to, const ray_lanes *restrict l, outcomes *restrict out, uint32_t i)
{
    part p = part_of(t, to, l, i);
    double a[5];
    const double rounded = coefficients(&p.s, a), sum = fabs(a[0]) + fabs(a[1]) + fabs(a[2]) + fabs(a[3]) + fabs(a[4]);
    const double error = rounded + 0x1p-48 * sum, slack = 0x1p-40 * (fabs(p.s.middle) + p.s.half), last = l->tmax[i] + slack;
    const double end0 = p.s.middle - p.s.half, end1 = p.s.middle - 0.5 * p.s.half, end2 = p.s.middle, end3 = p.s.middle + 0.5 * p.s.half;
    const double end4 = p.s.middle + p.s.half, own = -p.s.middle / p.s.half, known = p.off < 0x1p-16 ? 1.0 : 0.0;
    quartic left, right, q0, q1, q2, q3;
    double clear0, clear1, clear2, clear3, ahead, all, first, hit;

    halve(bernstein(a), &left, &right);
    halve(left, &q0, &q1);
    halve(right, &q2, &q3);
    clear0 = is_clear(q0, error, end0, end1, -slack, last);
    clear1 = clear0 * is_clear(q1, error, end1, end2, -slack, last);
    clear2 = clear1 * is_clear(q2, error, end2, end3, -slack, last);
    clear3 = clear2 * is_clear(q3, error, end3, end4, -slack, last);
    first = clear0 > 0.0 ? end1 : end0;
    first = clear1 > 0.0 ? end2 : first;
    first = clear2 > 0.0 ? end3 : first;
    hit = q3.b4 < -error ? end4 : HUGE_VAL;
    hit = q2.b4 < -error ? end3 : hit;
    hit = q1.b4 < -error ? end2 : hit;
    hit = q0.b4 < -error ? end1 : hit;
    ahead = least_ahead(a, own) > 64.0 * error ? 1.0 : 0.0;
    ahead = fabs(own) <= 1.0 ? ahead : 0.0;
    all = l->own[i] > 0.0 ? ahead : p.length < 0.0 ? 1.0 : clear3;
    out->passed[i] = known * all;
    hit = l->own[i] > 0.0 ? HUGE_VAL : hit + slack;
    out->hit[i] = end0 > slack ? (hit < l->tmax[i] ? known : 0.0) : 0.0;
    out->lo[i] = first - slack;
    out->hi[i] = hit;
}

COMMON_SEPARATE static void look_half(const torus *t, const space *to, const ray_lanes *restrict l, outcomes *restrict out)
{
    for (uint32_t i = 0; i < HALF; i++)
        look_at(t, to, l, out, i);
}

COMMON_SEPARATE static void look_all(const torus *t, const space *to, const ray_lanes *restrict l, outcomes *restrict out)
{
    COMMON_LOOP for (uint32_t i = 0; i < TOGETHER; i++)
        look_at(t, to, l, out, i);
}

static void put(ray_lanes *l, uint32_t i, const pov_rays *rays, uint32_t ray, uint32_t owner)
{
    for (int k = 0; k < 3; k++) {
        l->org[k][i] = rays->org[k][ray];
        l->dir[k][i] = rays->dir[k][ray];
    }
    l->size[i] = rays->size[ray];
    l->tmax[i] = rays->tmax[ray];
    l->own[i] = rays->rays[ray]->origin_surface == owner ? 1.0 : 0.0;
}

uint32_t common_torus_narrow(const void *self, const pov_own_map *map, uint32_t owner, const pov_rays *rays, pov_candidate *io, uint32_t n)
{
    const torus *t = self;
    uint32_t kept = 0;
    space to;

    find_space(map, t->scale, &to);
    for (uint32_t from = 0; from < n; from += TOGETHER) {
        const uint32_t some = n - from < TOGETHER ? n - from : TOGETHER;
        ray_lanes l;
        outcomes of;

        for (uint32_t i = 0; i < (some > HALF ? TOGETHER : HALF); i++)
            put(&l, i, rays, io[from + common_lane_of(i, some)].ray, owner);
        (some > HALF ? look_all : look_half)(t, &to, &l, &of);
        for (uint32_t i = 0; i < some; i++) {
            pov_candidate m = io[from + i];

            if (of.passed[i] > 0.0)
                continue;
            if (of.hit[i] > 0.0) {
                m.definite = true;
                m.lo = common_greater(m.lo, of.lo[i]);
                m.hi = of.hi[i];
            }
            io[kept++] = m;
        }
    }
    return kept;
}
