/* expansion.h - exact sums of products, to decide a sign when all else fails.
 *
 * An expansion is a sum of doubles that do not overlap, in order of growing size (Priest 1991; Shewchuk, "Adaptive
 * Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates", 1997, whose Grow-Expansion this is). */
#ifndef COMMON_EXPANSION_H
#define COMMON_EXPANSION_H

#include <povtrace/exact.h>

#define COMMON_EXPANSION_MAX 1024

typedef struct common_expansion {
    int count;
    double term[COMMON_EXPANSION_MAX];   /* none of them zero */
} common_expansion;

static inline void common_expansion_clear(common_expansion *e) { e->count = 0; }

void common_expansion_add(common_expansion *e, double a);
/* Add sign a b, or sign a b c, exactly, as long as the parts of the products are normal numbers. */
void common_expansion_add_product(common_expansion *e, double a, double b);
void common_expansion_add_product3(common_expansion *e, double a, double b, double c);

/* The sum, rounded once to double-double. */
pov_two common_expansion_two(const common_expansion *e);

/* -1, 0 or 1. */
int common_expansion_sign(const common_expansion *e);

#endif
