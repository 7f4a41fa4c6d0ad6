/* bernstein.h - real roots of a polynomial of any degree on 0..1, decided in double.
 *
 * Of the Bernstein coefficients the first and the last one are taken for what they are; those between count as zero up to
 * `noise`. So pieces of a curve that share an end, computed alike, are crossed as often as a closed curve is, and what
 * only touches is not crossed.
 *
 * common_bernstein_certain() takes no sign of a coefficient within its error, and says so where it would have to. roots.h has the
 * certified kernel of degree 3 and 4, and in double-double that of any degree. */
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

/* One root between lo and hi, where the polynomial is rising or falling. `known`: x is where it is, to what double makes of it. */
typedef struct common_root { double x, lo, hi; bool rising, known; } common_root;
typedef struct common_roots { uint32_t count; common_root at[COMMON_BERNSTEIN_MAX]; } common_roots;

/* As common_bernstein_first(), of coefficients that are off by `noise` each, up to the first root that is certainly beyond. False: double
 * leaves it open. */
bool common_bernstein_certain(const double *b, int degree, double noise, double beyond, double within, common_roots *out);
/* The slope at u. */
double common_bernstein_slope(const double *b, int degree, double u);

/* The same of eight side by side, of the degree 3, 4 or 6: coefficients by number and lane. */
enum { COMMON_BERNSTEINS = 8, COMMON_BERNSTEINS_DEGREE = 6 };
typedef double common_by_bernstein[COMMON_BERNSTEINS];
typedef struct common_bernsteins { common_by_bernstein b[COMMON_BERNSTEINS_DEGREE + 1], noise, beyond, within; } common_bernsteins;

/* By lane: above 0 where the first root is beyond that place, and that root; where others may follow. Where neither found nor open is above
 * 0 there is none; an open one is to be asked alone, unless the only root is known to lie before. */
typedef struct common_first_of_bernsteins { common_by_bernstein found, more, open, before, root; } common_first_of_bernsteins;
void common_bernstein_first_many(const common_bernsteins *of, int degree, common_first_of_bernsteins *out);
/* Of the degree 3 or 4; open is above 0 too where common_bernstein_certain() may leave it so. */
void common_bernstein_certain_many(const common_bernsteins *of, int degree, common_first_of_bernsteins *out);

#endif
