/* expansion.h - exact sums of products, to decide a sign when all else fails.
 *
 * An expansion is a sum of doubles that do not overlap, in order of growing size (Priest 1991; Shewchuk, "Adaptive
 * Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates", 1997, whose Grow-Expansion this is). */
#ifndef KIT_EXPANSION_H
#define KIT_EXPANSION_H

#include <povtrace/exact.h>

#define KIT_EXPANSION_MAX 1024

typedef struct kit_expansion {
    int count;
    double part[KIT_EXPANSION_MAX];   /* none of them zero */
} kit_expansion;

static inline void kit_expansion_clear(kit_expansion *e) { e->count = 0; }

void kit_expansion_add(kit_expansion *e, double a);
/* Add sign a b, or sign a b c, exactly, as long as the parts of the products are normal numbers. */
void kit_expansion_add_product(kit_expansion *e, double a, double b);
void kit_expansion_add_product3(kit_expansion *e, double a, double b, double c);

/* The sum, rounded once to double-double. */
pov_two kit_expansion_two(const kit_expansion *e);

/* -1, 0 or 1. */
int kit_expansion_sign(const kit_expansion *e);

#endif
