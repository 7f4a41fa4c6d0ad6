/* transform.h - transformations as the text has them, and their composition.
 *
 * A list from the last written back to the first: prefixes are shared, and nothing is rounded before the whole list
 * is composed, in double-double arithmetic, into one map and its inverse. */
#ifndef MODEL_TRANSFORM_H
#define MODEL_TRANSFORM_H

#include "base/arena.h"

#include <povtrace/math.h>

typedef enum transform_kind {
    TRANSFORM_TRANSLATE, TRANSFORM_ROTATE, TRANSFORM_SCALE, TRANSFORM_MATRIX
} transform_kind;

typedef struct transform {
    const struct transform *before;   /* the transformation applied before this one; NULL: none */
    transform_kind kind;
    double v[];                       /* x, y, z; or the 12 numbers of matrix <...> in the text's order */
} transform;

/* Translate 0, scale 1, whole turns, the identity matrix. */
bool transform_changes_nothing(transform_kind kind, const double *numbers);
/* `before` followed by one more transformation; numbers has 3 elements, or 12 for a matrix. NULL: no memory. Scale
 * factors are not zero. A transformation that changes nothing returns `before` itself, which may be NULL too. */
const transform *transform_append(arena *memory, const transform *before, transform_kind kind, const double *numbers);

/* Compose. The entries of out->m are within 2^-100 of the exact ones relative to the largest partial products;
 * rotations by multiples of 90 degrees are exact. False: the matrix has no inverse. list may be NULL (identity). */
bool transform_compose(const transform *list, pov_affine *out);

/* Compose several lists of the same kinds of transformations at once, bit for bit as if alone: each step waits for the
 * one before, and several lists share that time. Bit i of the result: the i-th has an inverse. */
enum { TRANSFORM_MANY = 8 };
bool transform_are_alike(const transform *a, const transform *b);
unsigned transform_compose_many(const transform *const *lists, int n, pov_affine *out);

/* Packed lists, one behind the other, composed in that order: the bytes of one list, a multiple of 8; packing one; and
 * composing as many lists of the same kinds as stand before `end`, at most TRANSFORM_MANY. The last call returns the
 * start of the next list. All of them have inverses, as was checked before. */
size_t transform_packed_bytes(const transform *list);
void transform_pack(const transform *list, void *at);
const void *transform_compose_packed(const void *at, const void *end, pov_affine *out, int *count);

/* The point, mapped and rounded once into two parts. */
void transform_point(const pov_affine *map, pov_vec3 p, pov_vec3 *hi, pov_vec3 *lo);
/* Where it takes a direction. */
pov_vec3 transform_direction(const pov_affine *map, pov_vec3 d);

/* Sine and cosine of an angle in degrees, each in double-double: s[2], c[2], relative error below 2^-98. */
void transform_sincos(double degrees, double *s, double *c);

#endif
