/* vec3.h - what vectors are asked for besides povtrace/math.h. */
#ifndef BASE_VEC3_H
#define BASE_VEC3_H

#include <povtrace/math.h>

#include <math.h>
#include <stdbool.h>

static inline bool vec3_is_same(pov_vec3 a, pov_vec3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

/* The sum of the components' sizes: a bound of the length. */
static inline double vec3_sum(pov_vec3 v) { return fabs(v.x) + fabs(v.y) + fabs(v.z); }

#endif
