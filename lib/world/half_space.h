/* half_space.h - bounds of what half-spaces have in common. */
#ifndef WORLD_HALF_SPACE_H
#define WORLD_HALF_SPACE_H

#include <povtrace/shape_fast.h>

/* More are left out: what fewer have in common holds what all have. */
enum { HALF_SPACES_MAX = 32 };
typedef struct half_spaces { uint32_t count, id[HALF_SPACES_MAX]; pov_half_space of[HALF_SPACES_MAX]; } half_spaces;

/* Add one, with a unit normal, or its complement; and the six that make a box. */
void half_spaces_add(half_spaces *all, const pov_half_space *one, bool complement, uint32_t id);
void half_spaces_add_box(half_spaces *all, const pov_box *box);
/* A box around what all have in common, rounded outward by far more than the half-spaces are rounded. False: it may be
 * infinite, or is empty as far as roundings tell. */
bool half_spaces_bound(const half_spaces *all, pov_box *out);

#endif
