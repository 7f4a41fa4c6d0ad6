#include "common/julia.h"

#include "common/simd.h"

/* ---- quaternions ---- */

/* Numbers a + u b, u from -1 to 1; a number is at most `off` from that, and its derivative at most `bent` from b. With `size` the
 * largest |a + u b|, q^2 is at most (2 size + off) off from a^2 + u (a b + b a) + u^2 b^2, and its derivative at most
 * 2 (size + off) bent + 2 (|b| + off) |b| from a b + b a; so for q^3, whose derivative is at most 3 (size + off)^2 bent +
 * 6 (size + off) (|b| + off) |b| off. */
typedef struct places { double a[4][COMMON_PROBES], b[4][COMMON_PROBES], off[COMMON_PROBES], bent[COMMON_PROBES]; } places;

/* part: the last component of the slice's normal. */
COMMON_INLINE void enter(const common_julia *restrict j, double part, const common_probes *restrict s, uint32_t lanes, places *restrict q)
{
    const double *n = j->slice.v;

    for (uint32_t l = 0; l < lanes; l++) {
        for (int k = 0; k < 3; k++) {
            q->a[k][l] = s->p[k][l];
            q->b[k][l] = s->d[k][l];
        }
        q->a[3][l] = (j->at - n[0] * s->p[0][l] - n[1] * s->p[1][l] - n[2] * s->p[2][l]) / part;
        q->b[3][l] = -(n[0] * s->d[0][l] + n[1] * s->d[1][l] + n[2] * s->d[2][l]) / part;
        q->off[l] = s->off[l];
        q->bent[l] = 0.0;
    }
}

/* What is known of them at a place, and the next: q^2 = (x^2 - |v|^2, 2 x v), q^3 = (x (x^2 - 3 |v|^2), (3 x^2 - |v|^2) v). The square of
 * u b, of which u^2 is from 0 to 1, counts half. Rounding is not covered: it is far below the radii that count. What has left stays as
 * it is. False: all have. */
COMMON_INLINE bool pass_place(const common_julia *restrict j, bool cube, bool points, uint32_t place, double reach, uint32_t lanes,
                              places *restrict q, common_probes *restrict s)
{
    int64_t any = 0;

    for (uint32_t l = 0; l < lanes; l++) {
        const double ax = q->a[0][l], ai = q->a[1][l], aj = q->a[2][l], ak = q->a[3][l], off = q->off[l], bent = q->bent[l];
        const double bx = q->b[0][l], bi = q->b[1][l], bj = q->b[2][l], bk = q->b[3][l];
        const int64_t wide = points ? 0 : s->wide[l], before = s->left[l], open = s->open[l];
        const double x2 = ax * ax, v2 = ai * ai + aj * aj + ak * ak, square = x2 + v2;
        const double bx2 = bx * bx, bv2 = bi * bi + bj * bj + bk * bk, b2 = bx2 + bv2;
        const double x = ax * bx, v = ai * bi + aj * bj + ak * bk, dot = x + v;
        const double by = wide ? fabs(dot) : 0.0, by2 = wide ? b2 : 0.0;
        const double most = square + by2 + 2.0 * by, least = by < by2 ? square - by : square + by2 - 2.0 * by;
        const double size = sqrt(most), speed = sqrt(b2), far = reach + off, near = reach > off ? reach - off : 0.0;
        const int64_t is_left = least > far * far ? 0 : before, is_within = square <= reach * reach ? before : 0;
        const int64_t left = wide ? is_left : is_within, opens = most <= near * near ? open : -1;
        const int64_t sure = fabs(dot) > by2 + off * speed + (size + off) * bent ? ~open : 0;

        s->square[l] = before ? square : s->square[l];
        s->place[l] = before ? place : s->place[l];
        s->slope[l] = before ? 2.0 * dot : s->slope[l];
        s->sure[l] = before ? sure : s->sure[l];
        s->left[l] = left;
        s->open[l] = wide ? opens : 0;
        any |= left;
        if (cube) {
            const double times = 3.0 * x2 - v2, all = size + off;

            q->off[l] = points ? 0.0 : (3.0 * size + speed) * b2 + ((3.0 * size + off) * off + 3.0 * size * size) * off;
            q->bent[l] = points ? 0.0 : 3.0 * all * (all * bent + 2.0 * (speed + off) * speed);
            q->a[0][l] = ax * (x2 - 3.0 * v2) + j->c.v[0];
            q->a[1][l] = ai * times + j->c.v[1];
            q->a[2][l] = aj * times + j->c.v[2];
            q->a[3][l] = ak * times + j->c.v[3];
            q->b[0][l] = 3.0 * (x2 - v2) * bx - 6.0 * ax * v;
            q->b[1][l] = (6.0 * x - 2.0 * v) * ai + times * bi;
            q->b[2][l] = (6.0 * x - 2.0 * v) * aj + times * bj;
            q->b[3][l] = (6.0 * x - 2.0 * v) * ak + times * bk;
        } else {
            const double half = 0.5 * (bx2 - bv2), a2 = 2.0 * ax, twice_b = 2.0 * bx;

            q->off[l] = points ? 0.0 : (2.0 * size + off) * off + 0.5 * b2;
            q->bent[l] = points ? 0.0 : 2.0 * ((size + off) * bent + (speed + off) * speed);
            q->a[0][l] = x2 - v2 + j->c.v[0] + (wide ? half : 0.0);
            q->a[1][l] = ai * a2 + j->c.v[1] + (wide ? bx * bi : 0.0);
            q->a[2][l] = aj * a2 + j->c.v[2] + (wide ? bx * bj : 0.0);
            q->a[3][l] = ak * a2 + j->c.v[3] + (wide ? bx * bk : 0.0);
            q->b[0][l] = 2.0 * (x - v);
            q->b[1][l] = a2 * bi + twice_b * ai;
            q->b[2][l] = a2 * bj + twice_b * aj;
            q->b[3][l] = a2 * bk + twice_b * ak;
        }
    }
    return any != 0;
}

COMMON_INLINE void follow_of(const common_julia *restrict j, bool cube, bool points, uint32_t places_wanted, double reach, uint32_t lanes,
                             common_probes *restrict s)
{
    places q;

    /* A division by one costs as much as any other. */
    if (j->slice.v[3] == 1.0)
        enter(j, 1.0, s, lanes, &q);
    else
        enter(j, j->slice.v[3], s, lanes, &q);
    for (uint32_t l = 0; l < lanes; l++) {
        s->left[l] = -1;
        s->open[l] = s->sure[l] = 0;
    }
    for (uint32_t i = 0; i < places_wanted && pass_place(j, cube, points, i, reach, lanes, &q, s);)
        i++;
}

/* Loops over a constant number of lanes are unrolled. Points alone need no bounds, which cost roots. */
#define FOLLOW(name, cube, points, lanes)                                                                                          \
    COMMON_CLONES static void name(const common_julia *j, uint32_t places_wanted, double reach, common_probes *restrict s)         \
    {                                                                                                                              \
        follow_of(j, cube, points, places_wanted, reach, lanes, s);                                                                \
    }
FOLLOW(follow_square, false, false, 1)
FOLLOW(follow_four_squares, false, false, 4)
FOLLOW(follow_eight_squares, false, false, 8)
FOLLOW(follow_squares, false, false, COMMON_PROBES)
FOLLOW(follow_eight_cubes, true, false, 8)
FOLLOW(follow_cubes, true, false, COMMON_PROBES)
FOLLOW(follow_four_points_of_square, false, true, 4)
FOLLOW(follow_four_points_of_cube, true, true, 4)

/* Unused lanes are the first again. */
static void fill_lanes(common_probes *s, uint32_t n, uint32_t lanes)
{
    for (uint32_t l = n; l < lanes; l++)
        common_probe_put(s, l, pov_vec3_of(s->p[0][0], s->p[1][0], s->p[2][0]), pov_vec3_of(s->d[0][0], s->d[1][0], s->d[2][0]), s->off[0],
                         s->wide[0] != 0);
}

static void follow_quaternions(const common_julia *j, uint32_t places_wanted, double reach, common_probes *s, uint32_t n)
{
    const uint32_t lanes = n > 8 ? COMMON_PROBES : j->cube || n > 4 ? 8 : n > 1 ? 4 : 1;

    fill_lanes(s, n, lanes);
    if (j->cube && lanes == 8)
        follow_eight_cubes(j, places_wanted, reach, s);
    else if (j->cube)
        follow_cubes(j, places_wanted, reach, s);
    else if (lanes == 1)
        follow_square(j, places_wanted, reach, s);
    else if (lanes == 4)
        follow_four_squares(j, places_wanted, reach, s);
    else if (lanes == 8)
        follow_eight_squares(j, places_wanted, reach, s);
    else
        follow_squares(j, places_wanted, reach, s);
}

/* ---- hypercomplex numbers ---- */

/* The square of a sum's size, where each part may be off. */
static double square_at_least(disc u, disc v)
{
    const double a = pov_max(disc_size(u) - u.off, 0.0), b = pov_max(disc_size(v) - v.off, 0.0);

    return 0.5 * (a * a + b * b);
}

static double square_at_most(disc u, disc v)
{
    const double a = disc_size(u) + u.off, b = disc_size(v) + v.off;

    return 0.5 * (a * a + b * b);
}

/* The square, which is the usual one, is put in place. */
COMMON_INLINE disc step_complex(const common_julia *j, bool square, disc z, double re, double im)
{
    z = square ? disc_squared(z) : j->f(z);
    if (!square && j->is_power)
        z = disc_exp(disc_times(z, j->power));
    return disc_of(z.re + re, z.im + im, z.off);
}

/* a + b i + c j + d k is the pair (a - d) + (b + c) i, (a + d) + (b - c) i. */
COMMON_INLINE void follow_pair(const common_julia *j, bool squares, uint32_t places_wanted, double reach, common_probes *s, uint32_t l)
{
    const double sqrt_two = 1.4142135623730951, *n = j->slice.v, *c = j->c.v, most = reach * reach;
    const pov_vec3 p = { s->p[0][l], s->p[1][l], s->p[2][l] }, d = { s->d[0][l], s->d[1][l], s->d[2][l] };
    const double last = (j->at - n[0] * p.x - n[1] * p.y - n[2] * p.z) / n[3], by = (n[0] * d.x + n[1] * d.y + n[2] * d.z) / n[3];
    const double off = s->wide[l] ? sqrt_two * (s->off[l] + sqrt(pov_dot(d, d) + by * by)) : 0.0;
    disc u = disc_of(p.x - last, p.y + p.z, off), v = disc_of(p.x + last, p.y - p.z, off);
    double square = 0.0;
    bool left = true, open = false;
    uint32_t i = 0;

    while (left && i < places_wanted) {
        if (i++ > 0) {
            u = step_complex(j, squares, u, c[0] - c[3], c[1] + c[2]);
            v = step_complex(j, squares, v, c[0] + c[3], c[1] - c[2]);
        }
        square = 0.5 * (disc_square(u) + disc_square(v));
        left = (off > 0.0 ? square_at_least(u, v) : square) <= most;
        open = open || (off > 0.0 && !(square_at_most(u, v) <= most));
    }
    s->square[l] = square;
    s->place[l] = i > 0 ? i - 1 : 0;
    s->slope[l] = 0.0;
    s->left[l] = -(int64_t)left;
    s->open[l] = -(int64_t)open;
    s->sure[l] = 0;
}

/* ---- their squares, side by side ---- */

/* wide: how far a stretch reaches from its middle. */
typedef struct pairs { double re[2][COMMON_PROBES], im[2][COMMON_PROBES], off[2][COMMON_PROBES], wide[COMMON_PROBES]; } pairs;

/* As follow_pair() begins. */
COMMON_INLINE void enter_pair(const common_julia *restrict j, const common_probes *restrict s, uint32_t l, pairs *restrict q)
{
    const double sqrt_two = 1.4142135623730951, *n = j->slice.v, px = s->p[0][l], py = s->p[1][l], pz = s->p[2][l];
    const double dx = s->d[0][l], dy = s->d[1][l], dz = s->d[2][l];
    const double last = (j->at - n[0] * px - n[1] * py - n[2] * pz) / n[3], by = (n[0] * dx + n[1] * dy + n[2] * dz) / n[3];
    const double off = sqrt_two * (s->off[l] + sqrt((dx * dx + dy * dy + dz * dz) + by * by)), wide = s->wide[l] ? off : 0.0;

    q->re[0][l] = px - last;
    q->im[0][l] = py + pz;
    q->re[1][l] = px + last;
    q->im[1][l] = py - pz;
    q->off[0][l] = q->off[1][l] = q->wide[l] = wide;
}

/* The square of one of a pair plus a number; size: its own. */
COMMON_INLINE void square_one(pairs *restrict q, uint32_t which, uint32_t l, double size, double re, double im)
{
    const double x = q->re[which][l], y = q->im[which][l], off = q->off[which][l];

    q->re[which][l] = (x * x - y * y) + re;
    q->im[which][l] = 2.0 * x * y + im;
    q->off[which][l] = off > 0.0 ? (2.0 * size + off) * off : 0.0;
}

/* What is known of them at a place, and the next. What has left stays as it is. */
COMMON_INLINE int64_t pass_pair(const double *restrict c, uint32_t l, uint32_t place, double most, pairs *restrict q,
                                common_probes *restrict s)
{
    const double ux = q->re[0][l], uy = q->im[0][l], vx = q->re[1][l], vy = q->im[1][l], u_off = q->off[0][l], v_off = q->off[1][l];
    const double u2 = ux * ux + uy * uy, v2 = vx * vx + vy * vy, square = 0.5 * (u2 + v2), u = sqrt(u2), v = sqrt(v2);
    const double near_u = u - u_off > 0.0 ? u - u_off : 0.0, near_v = v - v_off > 0.0 ? v - v_off : 0.0, far_u = u + u_off, far_v = v + v_off;
    const double least = q->wide[l] > 0.0 ? 0.5 * (near_u * near_u + near_v * near_v) : square;
    const double farthest = q->wide[l] > 0.0 ? 0.5 * (far_u * far_u + far_v * far_v) : 0.0;
    const int64_t before = s->left[l], left = least <= most ? before : 0, open = farthest <= most ? s->open[l] : -1;

    s->square[l] = before ? square : s->square[l];
    s->place[l] = before ? place : s->place[l];
    s->open[l] = before ? open : s->open[l];
    s->left[l] = left;
    square_one(q, 0, l, u, c[0] - c[3], c[1] + c[2]);
    square_one(q, 1, l, v, c[0] + c[3], c[1] - c[2]);
    return left;
}

COMMON_INLINE void follow_pairs(const common_julia *restrict j, uint32_t places_wanted, double reach, uint32_t lanes, common_probes *restrict s)
{
    const double most = reach * reach;
    int64_t any = -1;
    pairs q;

    for (uint32_t l = 0; l < lanes; l++) {
        enter_pair(j, s, l, &q);
        s->left[l] = -1;
        s->open[l] = s->sure[l] = 0;
        s->square[l] = s->place[l] = s->slope[l] = 0.0;
    }
    for (uint32_t place = 0; any && place < places_wanted; place++) {
        any = 0;
        for (uint32_t l = 0; l < lanes; l++)
            any |= pass_pair(j->c.v, l, place, most, &q, s);
    }
}

#define FOLLOW_PAIRS(name, lanes)                                                                                                  \
    COMMON_CLONES static void name(const common_julia *j, uint32_t places_wanted, double reach, common_probes *restrict s)         \
    {                                                                                                                              \
        follow_pairs(j, places_wanted, reach, lanes, s);                                                                           \
    }
FOLLOW_PAIRS(follow_four_pairs, 4)
FOLLOW_PAIRS(follow_eight_pairs, 8)
FOLLOW_PAIRS(follow_many_pairs, COMMON_PROBES)

void common_julia_follow(const common_julia *j, uint32_t places_wanted, double reach, common_probes *s, uint32_t n)
{
    const uint32_t lanes = n > 8 ? COMMON_PROBES : n > 4 ? 8 : 4;

    if (!j->f) {
        follow_quaternions(j, places_wanted, reach, s, n);
    } else if (j->squares && n > 1) {
        fill_lanes(s, n, lanes);
        (lanes == 4 ? follow_four_pairs : lanes == 8 ? follow_eight_pairs : follow_many_pairs)(j, places_wanted, reach, s);
    } else {
        for (uint32_t l = 0; l < n; l++)
            if (j->squares)
                follow_pair(j, true, places_wanted, reach, s, l);
            else
                follow_pair(j, false, places_wanted, reach, s, l);
    }
}

/* By small steps to both sides. */
static pov_vec3 slope_of_pair(const common_julia *j, pov_vec3 p, uint32_t place)
{
    static const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    const double h = 0x1p-24;
    common_probes s;

    for (uint32_t i = 0; i < 3; i++) {
        const pov_vec3 by = pov_vec3_of(i == 0 ? h : 0.0, i == 1 ? h : 0.0, i == 2 ? h : 0.0);

        common_probe_put(&s, 2 * i, pov_add(p, by), zero, 0.0, false);
        common_probe_put(&s, 2 * i + 1, pov_sub(p, by), zero, 0.0, false);
    }
    common_julia_follow(j, place + 1, HUGE_VAL, &s, 6);
    return pov_vec3_of(s.square[0] - s.square[1], s.square[2] - s.square[3], s.square[4] - s.square[5]);
}

pov_vec3 common_julia_slope(const common_julia *j, pov_vec3 p, uint32_t place)
{
    common_probes s;

    if (j->f)
        return slope_of_pair(j, p, place);
    for (uint32_t i = 0; i < 3; i++)
        common_probe_put(&s, i, p, pov_vec3_of(i == 0, i == 1, i == 2), 0.0, false);
    fill_lanes(&s, 3, 4);
    if (j->cube)
        follow_four_points_of_cube(j, place + 1, HUGE_VAL, &s);
    else
        follow_four_points_of_square(j, place + 1, HUGE_VAL, &s);
    return pov_vec3_of(s.slope[0], s.slope[1], s.slope[2]);
}
