/* spline_real.h - splines in 512 bits, and what is swept between two planes: the outline of a prism or a text. */
#ifndef NUMERICS_SPLINE_REAL_H
#define NUMERICS_SPLINE_REAL_H

#include "numerics/kinds.h"

/* What a spline makes of its points, `by` times as large: rows by power of u, columns by point. The piece goes from the point
 * `first` to the next but for Beziers; the next piece's points begin `step` further. */
typedef struct spline_basis { const char *keyword; int degree, points, first, step; double by, row[4][4]; } spline_basis;

extern const spline_basis spline_linear, spline_quadratic, spline_cubic, spline_bezier, spline_b;

/* A coordinate over a piece; that of the next point stands `stride` numbers further. */
poly_real spline_piece(const spline_basis *b, const double *first, int stride);

enum { SWEPT_PIECES = 64 };

/* Closed curves in the plane across the sweep, and the heights that it goes between; conic: at the height h they are h times as
 * large. */
typedef struct swept_real { int count; poly_real x[SWEPT_PIECES], y[SWEPT_PIECES]; double low, high; bool conic; } swept_real;

/* Sides and both caps; inside is what the even-odd rule says. The ray goes through (x, y) at its height. */
void swept_solve(const swept_real *s, const poly_real *x, const poly_real *y, const poly_real *height, real end, answer *out);

#endif
