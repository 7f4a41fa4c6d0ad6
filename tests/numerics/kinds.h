/* kinds.h - kinds of shapes that are drawn by chance and asked beside an answer in 512 bits: each crossing that is there is found,
 * and no other, unless two lie nearer than KIND_TOUCH to each other. */
#ifndef NUMERICS_KINDS_H
#define NUMERICS_KINDS_H

#include "numerics/piecewise.h"

#include "plug/shape_class.h"

enum { KIND_CROSSINGS = 64, KIND_NUMBERS = 512 };

/* Of sizes of the shape: crossings nearer to each other, or to the rim of a cap, are open. */
#define KIND_TOUCH 0x1p-20

typedef struct shape { int count; double number[KIND_NUMBERS]; } shape;

/* Along a ray, with exact numbers. */
typedef struct along { poly_real x, y, z; real end; } along;

/* What is there: crossings, and whether a double cannot be expected to tell. */
typedef struct answer { int count; double at[KIND_CROSSINGS]; bool open; } answer;

typedef struct kind_row {
    const char *keyword;
    void (*make)(shape *s, pov_reader *in);
    void (*solve)(const shape *s, const along *a, answer *out);
} kind_row;

/* Asserts it of so many rays from near and far, aimed anywhere, and of rays that graze the surface by 1e-1 to 1e-9 of its size. */
void kinds_keep_crossings(const kind_row *k, long rays);
/* Where the sign of a polynomial changes. */
void kinds_collect(const poly_real *p, real from, real to, answer *out);

#endif
