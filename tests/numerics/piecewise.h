/* piecewise.h - polynomials of one variable in 512 bits, and where they change their sign: the crossings of a ray with a surface
 * whose equation along the ray is one polynomial, or some one after the other. */
#ifndef NUMERICS_PIECEWISE_H
#define NUMERICS_PIECEWISE_H

#include "numerics/real.h"

enum { PIECE_DEGREE = 12, PIECES_MAX = 24 };

/* The sum of c[i] t^i. */
typedef struct poly_real { int degree; real c[PIECE_DEGREE + 1]; } poly_real;

poly_real poly_of(real constant);
poly_real poly_line(real at_zero, real slope);
poly_real poly_add(const poly_real *a, const poly_real *b);
poly_real poly_sub(const poly_real *a, const poly_real *b);
poly_real poly_mul(const poly_real *a, const poly_real *b);
poly_real poly_scale(const poly_real *a, real by);
poly_real poly_slope(const poly_real *p);
real poly_at(const poly_real *p, real t);

/* The equation from one distance to another. */
typedef struct poly_piece { poly_real p; real from, to; } poly_piece;

/* Distances where the sign changes, in growing order, each to 2^-80 of the interval. Returns how many. */
int poly_roots(const poly_piece *piece, double *out, int room);

#endif
