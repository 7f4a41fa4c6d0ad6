/* turns.h - angles as fractions of a full turn, with the same bits on every machine: for surface coordinates. */
#ifndef COMMON_TURNS_H
#define COMMON_TURNS_H

#include "base/elementary.h"

/* The angle of (x, y) to the x axis, from -1/2 to 1/2. */
static inline double common_turn(double y, double x) { return elementary_atan2(y, x) * 0x1.45f306dc9c883p-3; }

/* The same from 0 to 1. */
static inline double common_whole_turn(double y, double x)
{
    const double turn = common_turn(y, x);

    return turn < 0.0 ? turn + 1.0 : turn;
}

#endif
