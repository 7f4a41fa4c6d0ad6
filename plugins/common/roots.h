/* roots.h - certified real roots of a polynomial of degree 3 or 4 on -1..1.
 *
 * The polynomial is written in the Bernstein basis of the interval, whose coefficients have no more sign changes than there
 * are roots, less an even number (Descartes' rule). No change is no root, one is one root; else the interval is halved
 * by de Casteljau's scheme. Each coefficient has an error bound, and counts as open where it does not exceed it. What double
 * leaves open is isolated again in double-double; what that leaves open touches zero and does not cross it. */
#ifndef COMMON_ROOTS_H
#define COMMON_ROOTS_H

#include <povtrace/exact.h>

enum { COMMON_DEGREE_MAX = 4, COMMON_ROOTS_MAX = 8 };

/* One root between lo and hi, where the polynomial is rising or falling. */
typedef struct common_bracket { double lo, hi; bool rising; } common_bracket;
typedef struct common_brackets { uint32_t count; common_bracket at[COMMON_ROOTS_MAX]; } common_brackets;

/* The sum of a[k] x^k for k from 0 to degree (3 or 4), with coefficients that are off by `error` in sum. In growing
 * order. False: double leaves it open. */
bool common_isolate(const double *a, double error, int degree, common_brackets *out);
/* The same in double-double. */
void common_isolate_two(const pov_two *a, double error, int degree, common_brackets *out);
/* The root in double, by Newton's method kept in its bracket. */
double common_polish(const double *a, int degree, const common_bracket *root);

#endif
