#include "common/julia.h"

#include "common/simd.h"

/* ---- quaternions ---- */

/* The numbers of the points, one by one of their components, and how far others are from them. */
typedef struct places { double v[4][COMMON_SPHERES], off[COMMON_SPHERES]; } places;

COMMON_INLINE void enter(const common_julia *j, const common_spheres *s, uint32_t lanes, places *q)
{
    const double *n = j->slice.v;

    for (uint32_t l = 0; l < lanes; l++) {
        q->v[0][l] = s->x[l];
        q->v[1][l] = s->y[l];
        q->v[2][l] = s->z[l];
        q->v[3][l] = (j->at - n[0] * s->x[l] - n[1] * s->y[l] - n[2] * s->z[l]) / n[3];
        q->off[l] = s->off[l];
    }
}

/* What is known of the spheres at a place, and the next: q^2 = (a^2 - |v|^2, 2 a v), q^3 = (a (a^2 - 3 |v|^2), (3 a^2 - |v|^2) v).
 * What has left stays as it is. False: all have. */
COMMON_INLINE bool pass_place(const common_julia *restrict j, bool cube, uint32_t place, double most, uint32_t lanes, places *restrict q, common_spheres *restrict s)
{
    int64_t any = 0;

    for (uint32_t l = 0; l < lanes; l++) {
        const double a = q->v[0][l], x = q->v[1][l], y = q->v[2][l], z = q->v[3][l], off = q->off[l];
        const double a2 = a * a, v2 = x * x + y * y + z * z, times = cube ? 3.0 * a2 - v2 : 2.0 * a;
        const double square = a * a + x * x + y * y + z * z, size = sqrt(square);
        const double from = size > off ? (size - off) * (size - off) : 0.0, to = (size + off) * (size + off);
        const double lo = off > 0.0 ? from : square, hi = off > 0.0 ? to : square;
        const int64_t before = s->left[l], left = lo <= most ? before : 0;

        s->square[l] = before ? square : s->square[l];
        s->place[l] = before ? place : s->place[l];
        s->left[l] = left;
        s->open[l] = hi <= most ? s->open[l] : -1;
        any |= left;
        q->off[l] = cube ? ((3.0 * size + off) * off + 3.0 * size * size) * off : (2.0 * size + off) * off;
        q->v[0][l] = (cube ? a * (a2 - 3.0 * v2) : a2 - v2) + j->c.v[0];
        q->v[1][l] = x * times + j->c.v[1];
        q->v[2][l] = y * times + j->c.v[2];
        q->v[3][l] = z * times + j->c.v[3];
    }
    return any != 0;
}

COMMON_INLINE void follow_of(const common_julia *restrict j, bool cube, uint32_t places_wanted, double most, uint32_t lanes, common_spheres *restrict s)
{
    places q;

    enter(j, s, lanes, &q);
    for (uint32_t l = 0; l < lanes; l++) {
        s->square[l] = s->place[l] = 0.0;
        s->left[l] = -1;
        s->open[l] = 0;
    }
    for (uint32_t i = 0; i < places_wanted && pass_place(j, cube, i, most, lanes, &q, s);)
        i++;
}

/* Loops over a constant number of lanes are unrolled. */
#define FOLLOW(name, cube, lanes)                                                                                                  \
    COMMON_CLONES static void name(const common_julia *j, uint32_t places_wanted, double most, common_spheres *restrict s)         \
    {                                                                                                                              \
        follow_of(j, cube, places_wanted, most, lanes, s);                                                                         \
    }
FOLLOW(follow_square, false, 1)
FOLLOW(follow_four_squares, false, 4)
FOLLOW(follow_squares, false, COMMON_SPHERES)
FOLLOW(follow_cubes, true, COMMON_SPHERES)

/* Those of unused lanes are the first again. */
static void follow_quaternions(const common_julia *j, uint32_t places_wanted, double most, common_spheres *s, uint32_t n)
{
    for (uint32_t l = n; l < COMMON_SPHERES && l % 4 != 0; l++)
        common_spheres_put(s, l, pov_vec3_of(s->x[0], s->y[0], s->z[0]), s->off[0]);
    for (uint32_t l = j->cube && n <= 4 ? 4 : COMMON_SPHERES; l < COMMON_SPHERES; l++)
        common_spheres_put(s, l, pov_vec3_of(s->x[0], s->y[0], s->z[0]), s->off[0]);
    if (j->cube)
        follow_cubes(j, places_wanted, most, s);
    else if (n > 4)
        follow_squares(j, places_wanted, most, s);
    else if (n > 1)
        follow_four_squares(j, places_wanted, most, s);
    else
        follow_square(j, places_wanted, most, s);
}

/* ---- hypercomplex numbers ---- */

/* The square of a sum's size, where each part may be off. */
static double square_at_least(disc u, disc v)
{
    const double a = fmax(disc_size(u) - u.off, 0.0), b = fmax(disc_size(v) - v.off, 0.0);

    return 0.5 * (a * a + b * b);
}

static double square_at_most(disc u, disc v)
{
    const double a = disc_size(u) + u.off, b = disc_size(v) + v.off;

    return 0.5 * (a * a + b * b);
}

static disc step_complex(const common_julia *j, disc z, double re, double im)
{
    z = j->f(z);
    if (j->is_power)
        z = disc_exp(disc_times(z, j->power));
    return disc_of(z.re + re, z.im + im, z.off);
}

/* a + b i + c j + d k is the pair (a - d) + (b + c) i, (a + d) + (b - c) i. */
static void follow_pair(const common_julia *j, uint32_t places_wanted, double most, common_spheres *s, uint32_t l)
{
    const double sqrt_two = 1.4142135623730951, off = sqrt_two * s->off[l], *n = j->slice.v, *c = j->c.v;
    const double last = (j->at - n[0] * s->x[l] - n[1] * s->y[l] - n[2] * s->z[l]) / n[3];
    disc u = disc_of(s->x[l] - last, s->y[l] + s->z[l], off), v = disc_of(s->x[l] + last, s->y[l] - s->z[l], off);
    const bool is_point = !(u.off + v.off > 0.0);

    s->square[l] = s->place[l] = 0.0;
    s->left[l] = -1;
    s->open[l] = 0;
    for (uint32_t i = 0; i < places_wanted && s->left[l]; i++) {
        if (i > 0) {
            u = step_complex(j, u, c[0] - c[3], c[1] + c[2]);
            v = step_complex(j, v, c[0] + c[3], c[1] - c[2]);
        }
        s->square[l] = 0.5 * (disc_square(u) + disc_square(v));
        s->place[l] = i;
        s->left[l] = (is_point ? s->square[l] : square_at_least(u, v)) <= most ? -1 : 0;
        s->open[l] = (is_point ? s->square[l] : square_at_most(u, v)) <= most ? s->open[l] : -1;
    }
}

void common_julia_follow(const common_julia *j, uint32_t places_wanted, double most, common_spheres *s, uint32_t n)
{
    if (!j->f) {
        follow_quaternions(j, places_wanted, most, s, n);
        return;
    }
    for (uint32_t l = 0; l < n; l++)
        follow_pair(j, places_wanted, most, s, l);
}

pov_vec3 common_julia_slope(const common_julia *j, pov_vec3 p, uint32_t place)
{
    const double h = 0x1p-24;
    common_spheres s;

    for (uint32_t i = 0; i < 3; i++) {
        const pov_vec3 by = pov_vec3_of(i == 0 ? h : 0.0, i == 1 ? h : 0.0, i == 2 ? h : 0.0);

        common_spheres_put(&s, 2 * i, pov_add(p, by), 0.0);
        common_spheres_put(&s, 2 * i + 1, pov_sub(p, by), 0.0);
    }
    common_julia_follow(j, place + 1, HUGE_VAL, &s, 6);
    return pov_vec3_of(s.square[0] - s.square[1], s.square[2] - s.square[3], s.square[4] - s.square[5]);
}
