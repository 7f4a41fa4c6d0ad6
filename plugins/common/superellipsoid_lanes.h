/* superellipsoid_lanes.h - lines of several rays side by side, each with its own superellipsoid. */
#ifndef COMMON_SUPERELLIPSOID_LANES_H
#define COMMON_SUPERELLIPSOID_LANES_H

#include "common/superellipsoid.h"

/* As many as a vector holds. */
#if defined(__AVX512F__)
enum { TOGETHER = 8 };
#else
enum { TOGETHER = 4 };
#endif
typedef double lane[TOGETHER];

/* By lane: a line, and its shape's exponents. */
typedef struct line_lanes { lane o[3], d[3], e, n; } line_lanes;

COMMON_INLINE line get_line(const line_lanes *l, superellipsoid *s, uint32_t i)
{
    line n;

    s->e = l->e[i];
    s->n = l->n[i];
    n.s = s;
    n.o = pov_vec3_of(l->o[0][i], l->o[1][i], l->o[2][i]);
    n.d = pov_vec3_of(l->d[0][i], l->d[1][i], l->d[2][i]);
    return n;
}

static inline void put_line(line_lanes *l, const line *n, uint32_t i)
{
    l->o[0][i] = n->o.x;
    l->o[1][i] = n->o.y;
    l->o[2][i] = n->o.z;
    l->d[0][i] = n->d.x;
    l->d[1][i] = n->d.y;
    l->d[2][i] = n->d.z;
    l->e[i] = n->s->e;
    l->n[i] = n->s->n;
}

/* value_along() of all lanes. */
COMMON_INLINE void values_along(const line_lanes *restrict l, const double *restrict t, bool approx, double *restrict value,
                                double *restrict slope)
{
    for (uint32_t i = 0; i < TOGETHER; i++) {
        superellipsoid s;
        const line n = get_line(l, &s, i);
        double by;

        value[i] = value_along(&n, t[i], approx, &by);
        slope[i] = by;
    }
}

/* size_along() of all lanes, and approx_along(). */
COMMON_SEPARATE static void sizes_along(const line_lanes *restrict l, const double *restrict t, double *restrict value, double *restrict slope)
{
    values_along(l, t, false, value, slope);
}

COMMON_SEPARATE static void approxes_along(const line_lanes *restrict l, const double *restrict t, double *restrict value, double *restrict slope)
{
    values_along(l, t, true, value, slope);
}

#endif
