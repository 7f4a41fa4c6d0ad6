/* revolved.h - surfaces about the y axis, as rays at their boxes see them side by side (narrow.h): between two heights the square of the
 * radius is a cubic in the height, or the part is a flat ring. */
#ifndef COMMON_REVOLVED_H
#define COMMON_REVOLVED_H

#include "common/narrow.h"
#include "common/outline.h"

/* In the local space: square[0] + square[1] y + ..., and the sum of their sizes; of a ring, where low is high, the squares of its radii. */
typedef struct common_revolved_part {
    double low, high, square[4], size, inner, outer;
    double loose;                /* what the square of the radius is off by, where it is not quite a cubic; no ray starts on it then */
    uint32_t feature;
} common_revolved_part;

typedef struct common_revolved { uint32_t count; common_revolved_part *at; } common_revolved;

/* A part by the Bernstein coefficients of the squared radius from `low` to `high`. */
void common_revolved_curve(common_revolved_part *p, double low, double high, const double square[4], uint32_t feature);
void common_revolved_ring(common_revolved_part *p, double height, double inner, double outer, uint32_t feature);
/* The parts of an outline that is turned, if all its pieces are straight; else none. */
void common_revolved_outline(common_revolved *r, const common_outline *o, const pov_host *host, pov_reader *in);
common_look common_revolved_look;

/* Pieces by the Bernstein coefficients of the squared radius from `low` to `high`, and the square of the largest radius; each begins where
 * the one before ends. What lies within them is closed by two discs, of the features `cap` and the next one, unless `open`. */
typedef struct common_revolved_piece { double low, high, square[4], widest; } common_revolved_piece;
typedef struct common_revolved_pieces { uint32_t count; const common_revolved_piece *at; pov_two low, high; uint32_t cap; bool open; } common_revolved_pieces;
/* First crossings of rays at their box, as sor.c finds them one by one. */
void common_revolved_first(const common_revolved_pieces *s, const common_entries *restrict l, common_first_crossings *restrict out);

/* A piece of a curve that is turned: Bernstein coefficients of y, y^2 and r^2 in one order; its heights, and the square of its largest
 * radius. */
enum { COMMON_TURNED_ORDER = 6 };
typedef struct common_turned {
    common_piece curve;
    int order;
    double y[COMMON_TURNED_ORDER + 1], y_square[COMMON_TURNED_ORDER + 1], r_square[COMMON_TURNED_ORDER + 1];
    double low, high, widest;
} common_turned;
void common_turned_make(common_turned *p, const common_piece *curve);
/* The product of two polynomials of the order n, by Bernstein coefficients. */
void common_turned_multiply(int n, const double *a, const double *b, double *out);
/* First crossings of rays at their box with straight ones, as lathe.c finds them one by one. */
void common_turned_first(const common_turned *parts, uint32_t count, const common_entries *restrict l, common_first_crossings *restrict out);

/* Pieces of one order side by side; those past the end are never near. */
enum { COMMON_TURNED_LANES = 8 };
typedef double common_by_turned[COMMON_TURNED_LANES];
typedef struct common_turned_block {
    common_by_turned low, high, wide;
    common_by_turned y[COMMON_TURNED_ORDER + 1], y_square[COMMON_TURNED_ORDER + 1], r_square[COMMON_TURNED_ORDER + 1];
} common_turned_block;
void common_turned_pack(const common_turned *parts, uint32_t count, common_turned_block *out);

/* The line at oy + s dy from lo to hi, whose distance to the axis has the square a s^2 + 2 b s + c; per_height: 1 / dy; foot: where it is
 * nearest to the axis. What the equations take of it: a, linear, rest and square. */
typedef struct common_turned_line { double a, b, c, oy, per_height, foot, lo, hi, linear, rest, square; } common_turned_line;
/* The pieces of the block that it may cross, as bits; and their equations by lane. */
typedef struct common_turned_equations { common_by_turned b[COMMON_TURNED_ORDER + 1]; } common_turned_equations;
uint32_t common_turned_find(const common_turned_block *p, int order, const common_turned_line *n, common_turned_equations *out);

#endif
