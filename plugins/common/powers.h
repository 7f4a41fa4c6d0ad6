/* powers.h - powers with the same bits on every machine. */
#ifndef COMMON_POWERS_H
#define COMMON_POWERS_H

#include "base/elementary.h"

/* x is not negative. */
static inline double common_power(double x, double y) { return elementary_pow(x, y); }

#endif
