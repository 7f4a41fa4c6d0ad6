/* sincos.h - sine and cosine in double-double, several angles side by side. */
#ifndef MODEL_SINCOS_H
#define MODEL_SINCOS_H

#include <povtrace/exact.h>

/* Lanes of numbers for plain loops over eight, which compilers turn into vectors: two groups of four. The last lane of
 * each group means little or nothing. */
enum { TWO_LANES = 8, TWO_HALF = TWO_LANES / 2 };
typedef struct two_lanes { double hi[TWO_LANES], lo[TWO_LANES]; } two_lanes;

static inline pov_two two_lane(const two_lanes *l, int k)
{
    return pov_two_of(l->hi[k], l->lo[k]);
}

static inline void two_set_lane(two_lanes *l, int k, pov_two to)
{
    l->hi[k] = to.hi;
    l->lo[k] = to.lo;
}

/* Three angles each: x is the remainder of a quarter turn, in radians. */
enum { SINCOS_ANGLES = 3, SINCOS_MANY = 8 };
typedef struct sincos_turns {
    pov_two x[SINCOS_ANGLES], sine[SINCOS_ANGLES], cosine[SINCOS_ANGLES];
    int quarter[SINCOS_ANGLES];
} sincos_turns;

/* n of SINCOS_MANY at most, by their angles in degrees; relative errors below 2^-98. */
void sincos_many(sincos_turns *t, const double *const *degrees, int n);

#endif
