/* bernstein.h - real roots of a polynomial of any degree on 0..1, decided in double.
 *
 * Of the Bernstein coefficients the first and the last one are taken for what they are; those between count as zero up to
 * `noise`. So pieces of a curve that share an end, computed alike, are crossed as often as a closed curve is, and what
 * only touches is not crossed. roots.h has the certified kernel of degree 3 and 4. */
#ifndef COMMON_BERNSTEIN_H
#define COMMON_BERNSTEIN_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

enum { COMMON_BERNSTEIN_MAX = 36 };

/* The coefficients of the sum of a[k] x^k. */
void common_bernstein(const double *a, int degree, double *b);
/* What rounding alone makes of such coefficients. */
double common_bernstein_noise(const double *b, int degree);
/* Widens a range by the values on 0..1, of a degree of 3 at most: to within a rounding of them, and not below their ends. */
void common_bernstein_widen(const double *b, int degree, double *lo, double *hi);
/* b(u) = (u - at) q(u) for a known root: q, of a degree less. */
void common_bernstein_divide(const double *b, int degree, double at, double *q);
/* Roots in growing order, at most `degree` of them. Returns how many. */
uint32_t common_bernstein_roots(const double *b, int degree, double noise, double *root);
/* The same up to the first root beyond a place; others may follow it. It need not be known if it is certainly before `within`. */
uint32_t common_bernstein_first(const double *b, int degree, double noise, double beyond, double within, double *root);

#endif
