/* povtrace/math.h - vectors, boxes, affine maps. Header only, so that a plugin
 * needs no symbol of the library. */
#ifndef POVTRACE_MATH_H
#define POVTRACE_MATH_H

#include <math.h>
#include <stdbool.h>

typedef struct pov_vec3 { double x, y, z; } pov_vec3;
typedef struct pov_box { pov_vec3 lo, hi; } pov_box;

/* p' = m p with p = (x, y, z, 1), and the inverse map. Each entry is an unevaluated sum of two parts. */
typedef struct pov_affine { double m[3][4], m_lo[3][4], inv[3][4], inv_lo[3][4]; } pov_affine;

/* The lesser and the greater of two numbers, as fmin() and fmax() have it: a NaN is left out. Those of the C library are calls, and
 * of instructions from before AVX: an Intel Xeon waits a tenth of a microsecond for them while upper halves of vectors hold something. */
static inline double pov_min(double a, double b) { return a < b || b != b ? a : b; }
static inline double pov_max(double a, double b) { return a > b || b != b ? a : b; }
static inline float pov_minf(float a, float b) { return a < b || b != b ? a : b; }
static inline float pov_maxf(float a, float b) { return a > b || b != b ? a : b; }

static inline pov_vec3 pov_vec3_of(double x, double y, double z) { pov_vec3 v; v.x = x; v.y = y; v.z = z; return v; }
static inline pov_vec3 pov_add(pov_vec3 a, pov_vec3 b) { return pov_vec3_of(a.x + b.x, a.y + b.y, a.z + b.z); }
static inline pov_vec3 pov_sub(pov_vec3 a, pov_vec3 b) { return pov_vec3_of(a.x - b.x, a.y - b.y, a.z - b.z); }
static inline pov_vec3 pov_scale(pov_vec3 a, double s) { return pov_vec3_of(a.x * s, a.y * s, a.z * s); }
static inline double pov_dot(pov_vec3 a, pov_vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

static inline pov_vec3 pov_cross_product(pov_vec3 a, pov_vec3 b)
{
    return pov_vec3_of(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

/* The largest absolute component; what is not a number does not count. */
static inline double pov_largest(pov_vec3 a)
{
    double x = fabs(a.x), y = fabs(a.y), z = fabs(a.z), m = x > 0.0 ? x : 0.0;

    m = y > m ? y : m;
    return z > m ? z : m;
}

/* Unit vector along a, whatever its length from denormal to huge; zero for a zero vector. */
static inline pov_vec3 pov_unit(pov_vec3 a)
{
    double m = pov_largest(a), length;
    int e;

    if (!(m > 0.0) || m > 1.7976931348623157e308)
        return pov_vec3_of(0.0, 0.0, 0.0);
    if (m < 1e-120 || m > 1e120) {   /* out of the range of squares; within it the scaling would change no bit */
        frexp(m, &e);
        a = pov_vec3_of(ldexp(a.x, -e), ldexp(a.y, -e), ldexp(a.z, -e));
    }
    length = sqrt(pov_dot(a, a));
    return pov_vec3_of(a.x / length, a.y / length, a.z / length);
}

static inline pov_vec3 pov_affine_point(const pov_affine *f, pov_vec3 p)
{
    return pov_vec3_of(f->m[0][0] * p.x + f->m[0][1] * p.y + f->m[0][2] * p.z + f->m[0][3],
                       f->m[1][0] * p.x + f->m[1][1] * p.y + f->m[1][2] * p.z + f->m[1][3],
                       f->m[2][0] * p.x + f->m[2][1] * p.y + f->m[2][2] * p.z + f->m[2][3]);
}

#endif
