/* sides.h - on which side of a plane curve, filled by the even-odd rule, its outside lies. Where it crosses itself, that changes. */
#ifndef COMMON_SIDES_H
#define COMMON_SIDES_H

#include "common/outline.h"

/* Up to a parameter of a piece: 1 where the outside is to the right of the way, else -1. */
typedef struct common_side { double until, sign; } common_side;

/* By piece the first of its sides; of each, the last one is until 1. NULL: all are `sign`. */
typedef struct common_sides { double sign; common_side *at; uint32_t *first; } common_sides;

/* Of an outline whose size is about one. */
void common_sides_find(common_sides *out, const common_outline *o, const pov_host *host, pov_reader *in);
double common_sides_at(const common_sides *s, uint32_t piece, double u);

#endif
