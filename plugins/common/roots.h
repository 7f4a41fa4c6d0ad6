/* roots.h - certified real roots of a polynomial of degree 3 or 4 on -1..1, and of any degree in double-double.
 *
 * The polynomial is written in the Bernstein basis of the interval, whose coefficients have no more sign changes than there
 * are roots, less an even number (Descartes' rule). No change is no root, one is one root; else the interval is halved
 * by de Casteljau's scheme. Each coefficient has an error bound, and counts as open where it does not exceed it. What double
 * leaves open is isolated again in double-double; what that leaves open touches zero and does not cross it. */
#ifndef COMMON_ROOTS_H
#define COMMON_ROOTS_H

#include <povtrace/exact.h>

enum { COMMON_DEGREE_MAX = 4, COMMON_DEGREE_TWO_MAX = 35, COMMON_ROOTS_MAX = 36 };

/* One root between lo and hi, where the polynomial is rising or falling; near `start`. */
typedef struct common_bracket { double lo, hi, start; bool rising; } common_bracket;
typedef struct common_brackets { uint32_t count; common_bracket at[COMMON_ROOTS_MAX]; } common_brackets;

/* Which roots are wanted: those between `from` and `to`; `first`: no more than the first that is certainly beyond `ahead`.
 * Others may be left out. */
typedef struct common_range { double from, ahead, to; bool first; } common_range;

/* Where there is certainly no root so near to the first place that is wanted, what lies before is left out: all roots that are found are then
 * farther from it than any error of it. */
#define COMMON_ASIDE 0x1p-14

/* The sum of a[k] x^k for k from 0 to degree (3 or 4), with coefficients that are off by `error` in sum. In growing
 * order. False: double leaves it open. */
bool common_isolate(const double *a, double error, int degree, common_range wanted, common_brackets *out);
/* The same in double-double. */
void common_isolate_two(const pov_two *a, double error, int degree, common_brackets *out);
/* Of Bernstein coefficients on 0..1, and what each is off by. */
void common_isolate_bernstein_two(const pov_two *b, const double *off, int degree, common_brackets *out);
/* The root by Newton's method kept in its bracket, to about 2^-44 of the interval. */
double common_polish(const double *a, int degree, const common_bracket *root);

/* ---- four quartics side by side ---- */

enum { COMMON_QUARTICS = 4 };
typedef double common_by_quartic[COMMON_QUARTICS];

/* The sums of a[k] x^k, and which roots are wanted: as common_range with `first`. */
typedef struct common_quartics { common_by_quartic a[5], error, from, ahead, to; } common_quartics;

/* The first root of each: its bracket, 1 or -1 for rising or falling, and about where it is. found: 1, or 0 if there is none;
 * open: 1 where common_isolate() is needed to tell. */
typedef struct common_first_roots { common_by_quartic lo, hi, rise, x, found, open; } common_first_roots;

/* As common_isolate() bit for bit, where that finds a single root. */
void common_isolate_four(const common_quartics *q, common_first_roots *out);
/* As common_polish() bit for bit, from x on. */
void common_polish_four(const common_quartics *q, common_first_roots *io);

#endif
