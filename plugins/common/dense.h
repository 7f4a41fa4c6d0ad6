/* dense.h - polynomials of a small order with all terms: nothing is looked up, and loops are unrolled where the order is known. */
#ifndef COMMON_DENSE_H
#define COMMON_DENSE_H

#include "common/local.h"

enum { COMMON_DENSE_MAX = 4 };

/* s = s (o + d t), of a degree that becomes n. */
COMMON_INLINE void common_dense_lift(double *s, int n, double o, double d)
{
    s[n] = s[n - 1] * d;
    COMMON_UNROLLED for (int i = n - 1; i > 0; i--)
        s[i] = s[i] * o + s[i - 1] * d;
    s[0] *= o;
}

/* Along the line o + d t: n + 1 coefficients. What is zero by its degree is left out. */
COMMON_INLINE void common_dense_along(const double *c, int n, pov_vec3 o, pov_vec3 d, double *out)
{
    double power[COMMON_DENSE_MAX + 1][COMMON_DENSE_MAX + 1], y[COMMON_DENSE_MAX + 1];

    power[0][0] = 1.0;
    COMMON_UNROLLED for (int k = 1; k <= n; k++) {
        COMMON_UNROLLED for (int i = 0; i < k; i++)
            power[k][i] = power[k - 1][i];
        common_dense_lift(power[k], k, o.z, d.z);
    }
    COMMON_UNROLLED for (int i = n; i >= 0; i--) {
        COMMON_UNROLLED for (int j = n - i; j >= 0; j--) {
            if (j < n - i)
                common_dense_lift(y, n - i - j, o.y, d.y);
            else
                y[0] = 0.0;
            COMMON_UNROLLED for (int k = n - i - j; k >= 0; k--, c++)
                COMMON_UNROLLED for (int l = 0; l <= k; l++)
                    y[l] += power[k][l] * *c;
        }
        if (i < n)
            common_dense_lift(out, n - i, o.x, d.x);
        else
            out[0] = 0.0;
        COMMON_UNROLLED for (int l = 0; l <= n - i; l++)
            out[l] += y[l];
    }
}

/* A number, and its slope. */
typedef struct common_sloped { double value, x, y, z; } common_sloped;

/* Horner's step in y, and in x. */
COMMON_INLINE void common_take_row(common_sloped *y, common_sloped z, double at)
{
    y->y = y->y * at + y->value;
    y->value = y->value * at + z.value;
    y->z = y->z * at + z.z;
}

COMMON_INLINE void common_take_plane(common_sloped *s, common_sloped y, double at)
{
    s->x = s->x * at + s->value;
    s->value = s->value * at + y.value;
    s->y = s->y * at + y.y;
    s->z = s->z * at + y.z;
}

/* The value at a point, and the slope there. */
COMMON_INLINE common_sloped common_dense_at(const double *c, int n, pov_vec3 at)
{
    common_sloped s = { 0.0, 0.0, 0.0, 0.0 };

    COMMON_UNROLLED for (int i = n; i >= 0; i--) {
        common_sloped y = { 0.0, 0.0, 0.0, 0.0 };

        COMMON_UNROLLED for (int j = n - i; j >= 0; j--) {
            common_sloped z = { 0.0, 0.0, 0.0, 0.0 };

            COMMON_UNROLLED for (int k = n - i - j; k >= 0; k--) {
                z.z = z.z * at.z + z.value;
                z.value = z.value * at.z + *c++;
            }
            common_take_row(&y, z, at.y);
        }
        common_take_plane(&s, y, at.x);
    }
    return s;
}

/* The sum of the sizes of all terms at a point. */
COMMON_INLINE double common_dense_size(const double *c, int n, pov_vec3 at)
{
    const double x = fabs(at.x), y = fabs(at.y), z = fabs(at.z);
    double sum = 0.0;

    COMMON_UNROLLED for (int i = n; i >= 0; i--) {
        double plane = 0.0;

        COMMON_UNROLLED for (int j = n - i; j >= 0; j--) {
            double row = 0.0;

            COMMON_UNROLLED for (int k = n - i - j; k >= 0; k--)
                row = row * z + fabs(*c++);
            plane = plane * y + row;
        }
        sum = sum * x + plane;
    }
    return sum;
}

#endif
