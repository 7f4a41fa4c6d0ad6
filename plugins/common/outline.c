#include "common/outline.h"

#include "common/bernstein.h"

#include <string.h>

/* ---- made ---- */

bool common_outline_add(common_outline *o, const pov_host *host, pov_reader *in, const common_piece *piece)
{
    if (o->count == o->capacity) {
        const uint32_t capacity = o->capacity ? 2 * o->capacity : 16;
        common_piece *bigger = host->alloc(in, capacity * sizeof *bigger);

        if (!bigger)
            return false;
        if (o->count > 0)
            memcpy(bigger, o->at, o->count * sizeof *bigger);
        o->at = bigger;
        o->capacity = capacity;
    }
    o->at[o->count++] = *piece;
    return true;
}

void common_outline_bound(common_outline *o)
{
    o->lo[0] = o->lo[1] = HUGE_VAL;
    o->hi[0] = o->hi[1] = -HUGE_VAL;
    for (uint32_t i = 0; i < o->count; i++)
        for (uint32_t k = 0; k <= o->at[i].degree; k++) {
            o->lo[0] = fmin(o->lo[0], o->at[i].x[k]);
            o->hi[0] = fmax(o->hi[0], o->at[i].x[k]);
            o->lo[1] = fmin(o->lo[1], o->at[i].y[k]);
            o->hi[1] = fmax(o->hi[1], o->at[i].y[k]);
        }
}

void common_outline_place(common_outline *o, const double middle[2], double scale)
{
    for (uint32_t i = 0; i < o->count; i++)
        for (uint32_t k = 0; k <= o->at[i].degree; k++) {
            o->at[i].x[k] = (o->at[i].x[k] - middle[0]) * scale;
            o->at[i].y[k] = (o->at[i].y[k] - middle[1]) * scale;
        }
    common_outline_bound(o);
}

/* ---- pieces ---- */

static double blend(const double *b, uint32_t degree, double u, double *slope)
{
    const double v = 1.0 - u;

    if (degree == 1) {
        *slope = b[1] - b[0];
        return b[0] * v + b[1] * u;
    }
    if (degree == 2) {
        *slope = 2.0 * ((b[1] - b[0]) * v + (b[2] - b[1]) * u);
        return (b[0] * v + 2.0 * b[1] * u) * v + b[2] * u * u;
    }
    *slope = 3.0 * (((b[1] - b[0]) * v + 2.0 * (b[2] - b[1]) * u) * v + (b[3] - b[2]) * u * u);
    return ((b[0] * v + 3.0 * b[1] * u) * v + 3.0 * b[2] * u * u) * v + b[3] * u * u * u;
}

void common_piece_at(const common_piece *piece, double u, double point[2], double tangent[2])
{
    point[0] = blend(piece->x, piece->degree, u, &tangent[0]);
    point[1] = blend(piece->y, piece->degree, u, &tangent[1]);
}

/* Roots of a piece's Bernstein coefficients: none, where all lie on one side. */
static uint32_t roots_of(const double *b, uint32_t degree, double *root)
{
    bool above = b[0] >= 0.0, same = true;

    for (uint32_t i = 1; i <= degree; i++)
        same &= (b[i] >= 0.0) == above;
    return same ? 0 : common_bernstein_roots(b, (int)degree, common_bernstein_noise(b, (int)degree), root);
}

/* ---- along a line ---- */

static void sort_in(common_cross *out, uint32_t count, common_cross c)
{
    while (count > 0 && out[count - 1].s > c.s) {
        out[count] = out[count - 1];
        count--;
    }
    out[count] = c;
}

uint32_t common_outline_cross(const common_outline *o, const double p[2], const double d[2], common_cross *out)
{
    const double square = d[0] * d[0] + d[1] * d[1];
    uint32_t count = 0;

    for (uint32_t i = 0; i < o->count; i++) {
        const common_piece *c = &o->at[i];
        double b[4], root[3], point[2], tangent[2];
        uint32_t n;

        for (uint32_t k = 0; k <= c->degree; k++)
            b[k] = (c->x[k] - p[0]) * d[1] - (c->y[k] - p[1]) * d[0];
        n = roots_of(b, c->degree, root);
        for (uint32_t k = 0; k < n; k++) {
            common_cross at = { 0.0, root[k], i };

            common_piece_at(c, root[k], point, tangent);
            at.s = ((point[0] - p[0]) * d[0] + (point[1] - p[1]) * d[1]) / square;
            sort_in(out, count++, at);
        }
    }
    return count;
}

/* The line and the apex span a plane; where the outline crosses it, the line crosses the ray from the apex through there. */
uint32_t common_outline_cross_cone(const common_outline *o, pov_vec3 w, pov_vec3 d, common_cross *out)
{
    const pov_vec3 m = pov_cross_product(w, d);
    uint32_t count = 0;

    for (uint32_t i = 0; i < o->count; i++) {
        const common_piece *c = &o->at[i];
        double b[4], root[3], point[2], tangent[2];
        uint32_t n;

        for (uint32_t k = 0; k <= c->degree; k++)
            b[k] = m.x * c->x[k] + m.y + m.z * c->y[k];
        n = roots_of(b, c->degree, root);
        for (uint32_t k = 0; k < n; k++) {
            common_cross at = { 0.0, root[k], i };
            pov_vec3 toward, across;

            common_piece_at(c, root[k], point, tangent);
            toward = pov_vec3_of(point[0], 1.0, point[1]);
            across = pov_cross_product(d, toward);
            at.s = -pov_dot(pov_cross_product(w, toward), across) / pov_dot(across, across);
            sort_in(out, count++, at);
        }
    }
    return count;
}

/* ---- inside ---- */

/* Crossings of the piece with the half-line from p along x, counted by the sign of the distance above it. */
static uint32_t count_right(const common_piece *c, const double p[2])
{
    double b[4], root[3], point[2], tangent[2];
    bool left = true, right = true;
    uint32_t n, sum = 0;

    for (uint32_t k = 0; k <= c->degree; k++) {
        b[k] = c->y[k] - p[1];
        left &= c->x[k] <= p[0];
        right &= c->x[k] > p[0];
    }
    if (left)
        return 0;
    if (right)
        return (b[0] >= 0.0) != (b[c->degree] >= 0.0);
    n = roots_of(b, c->degree, root);
    for (uint32_t k = 0; k < n; k++) {
        common_piece_at(c, root[k], point, tangent);
        sum += point[0] > p[0];
    }
    return sum;
}

bool common_outline_inside(const common_outline *o, const double p[2])
{
    uint32_t sum = 0;

    if (!(p[0] >= o->lo[0] && p[0] <= o->hi[0] && p[1] >= o->lo[1] && p[1] <= o->hi[1]))
        return false;
    for (uint32_t i = 0; i < o->count; i++)
        sum += count_right(&o->at[i], p);
    return sum % 2 == 1;
}
