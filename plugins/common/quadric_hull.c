/* Half-spaces around infinite quadrics with ellipses across an axis: cylinders, cones, paraboloids, hyperboloids.
 *
 * With the form's principal directions e1, e2 across the axis and e3 along it, the equation is l1 u1^2 + l2 u2^2 <= -rest(s), where
 * l1 and l2 are positive, u1 and u2 are counted from the centre, and rest(s) = l3 s^2 + g3 s + j. So u1 and u2 are bounded by the
 * largest value of -rest between the ends that other half-spaces give s, or everywhere if rest is a constant. */
#include "common/quadric.h"

/* Coefficients below this fraction of the largest count as zero if they are bounded by what surrounds them; directions
 * this near to the axis count as along it. */
static const double nearly = 0x1p-30;
/* What radii and ends are widened by, in parts: more than what `nearly` can move them. */
static const double widen = 0x1p-16;

typedef struct frame { pov_vec3 e[3]; double l[3]; } frame;

/* Turn rows p and q of a symmetric matrix, and the directions with them, so that their common element vanishes. */
static void turn(double m[3][3], pov_vec3 e[3], int p, int q)
{
    const double theta = 0.5 * (m[q][q] - m[p][p]) / m[p][q];
    const double t = copysign(1.0, theta) / (fabs(theta) + sqrt(theta * theta + 1.0)), c = 1.0 / sqrt(t * t + 1.0), s = t * c;
    const pov_vec3 old = e[p];

    for (int i = 0; i < 3; i++) {
        const double a = m[i][p], b = m[i][q];
        m[i][p] = c * a - s * b;
        m[i][q] = s * a + c * b;
    }
    for (int i = 0; i < 3; i++) {
        const double a = m[p][i], b = m[q][i];
        m[p][i] = c * a - s * b;
        m[q][i] = s * a + c * b;
    }
    e[p] = pov_sub(pov_scale(old, c), pov_scale(e[q], s));
    e[q] = pov_add(pov_scale(old, s), pov_scale(e[q], c));
}

/* Principal directions by Jacobi's method; the axis is the one with the least coefficient. Where the form has no mixed terms
 * they are the coordinates'. */
static void find_frame(const double *q, frame *out)
{
    double m[3][3] = { { q[A], 0.5 * q[D], 0.5 * q[E] }, { 0.5 * q[D], q[B], 0.5 * q[F] }, { 0.5 * q[E], 0.5 * q[F], q[C] } };
    pov_vec3 e[3] = { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } };
    int axis = 0;

    for (int sweep = 0; sweep < 12; sweep++)
        for (int i = 0; i < 3; i++)
            if (fabs(m[i][(i + 1) % 3]) > 0x1p-80)
                turn(m, e, i, (i + 1) % 3);
    for (int i = 1; i < 3; i++)
        if (m[i][i] < m[axis][axis])
            axis = i;
    for (int i = 0; i < 3; i++) {
        const int from = (axis + 1 + i) % 3;
        out->e[i] = e[from];
        out->l[i] = m[from][from];
    }
}

/* Ends along the axis that the half-spaces give, about the anchor; infinite ones stay. */
static void find_ends(const common_quadric *s, pov_vec3 axis, const pov_half_space *within, uint32_t n, double end[2])
{
    end[0] = -HUGE_VAL;
    end[1] = HUGE_VAL;
    for (uint32_t i = 0; i < n; i++) {
        const pov_half_space *h = &within[i];
        const double along = pov_dot(h->normal, axis), across = pov_largest(pov_cross_product(h->normal, axis));
        const double at = (h->distance - pov_dot(h->normal, pov_two3_hi(s->anchor))) * s->scale;

        if (across > nearly)
            continue;
        if (along > 0.0)
            end[1] = pov_min(end[1], at);
        else
            end[0] = pov_max(end[0], -at);
    }
}

typedef struct rest { double l, g, j; } rest;

static double less(const rest *r, double s) { return -((r->l * s + r->g) * s + r->j); }

/* The largest value of -rest; with r->l <= 0 or nearly so it is at an end. */
static double largest_between(const rest *r, const double end[2])
{
    const double slack = nearly * (end[0] * end[0] + end[1] * end[1]);

    if (r->l == 0.0 && r->g == 0.0)
        return -r->j;
    return isfinite(end[0]) && isfinite(end[1]) ? pov_max(less(r, end[0]), less(r, end[1])) + slack : HUGE_VAL;
}

static void put(const common_quadric *s, pov_vec3 normal, double distance, pov_half_space *out)
{
    out->normal = normal;
    out->distance = pov_dot(normal, pov_two3_hi(s->anchor)) + distance / s->scale;
}

/* A paraboloid ends at its vertex. */
static void close_end(const rest *r, double end[2])
{
    if (r->l == 0.0 && r->g > 0.0)
        end[1] = pov_min(end[1], -r->j / r->g);
    if (r->l == 0.0 && r->g < 0.0)
        end[0] = pov_max(end[0], -r->j / r->g);
}

/* The equation in its frame: about the centre across the axis. */
static void complete_squares(const common_quadric *s, const frame *f, double centre[2], rest *r)
{
    const pov_vec3 linear = { s->approx[G], s->approx[H], s->approx[I] };

    r->l = f->l[2];
    r->g = pov_dot(linear, f->e[2]);
    r->j = s->approx[J];
    for (int i = 0; i < 2; i++) {
        const double g = pov_dot(linear, f->e[i]);

        centre[i] = -0.5 * g / f->l[i];
        r->j -= 0.25 * g * g / f->l[i];
    }
}

static double finite_part(double x) { return isfinite(x) ? fabs(x) : 0.0; }

uint32_t common_quadric_hull(const void *self, const pov_half_space *within, uint32_t n, pov_half_space *out)
{
    const common_quadric *s = self;
    double end[2], centre[2], slack, most;
    uint32_t count = 0;
    frame f;
    rest r;

    find_frame(s->approx, &f);
    if (s->planar || !(f.l[0] > 0x1p-12 && f.l[1] > 0x1p-12 && f.l[2] < nearly))
        return 0;
    complete_squares(s, &f, centre, &r);
    find_ends(s, f.e[2], within, n, end);
    close_end(&r, end);
    slack = nearly + widen * (finite_part(end[0]) + finite_part(end[1]) + fabs(centre[0]) + fabs(centre[1]));
    end[0] -= slack;
    end[1] += slack;
    most = largest_between(&r, end);
    for (int i = 0; i < 2 && most < HUGE_VAL; i++) {
        const double radius = sqrt(pov_max(most, 0.0) / f.l[i]) * (1.0 + widen) + slack;

        put(s, f.e[i], centre[i] + radius, &out[count++]);
        put(s, pov_scale(f.e[i], -1.0), radius - centre[i], &out[count++]);
    }
    if (isfinite(end[0]))
        put(s, pov_scale(f.e[2], -1.0), -end[0], &out[count++]);
    if (isfinite(end[1]))
        put(s, f.e[2], end[1], &out[count++]);
    return count;
}
