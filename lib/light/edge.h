/* edge.h - how lights in cones and cylinders lose their light outwards. */
#ifndef LIGHT_EDGE_H
#define LIGHT_EDGE_H

#include "base/elementary.h"

/* 0 at lo, 1 at hi, smooth between them and constant beyond; a step at hi where they are no interval. */
static inline double light_edge(double lo, double hi, double v)
{
    const double u = hi > lo ? (v - lo) / (hi - lo) : v >= hi ? 1.0 : 0.0, kept = u < 0.0 ? 0.0 : u > 1.0 ? 1.0 : u;

    return kept * kept * (3.0 - 2.0 * kept);
}

static inline double light_tighten(double x, double tightness)
{
    return tightness == 0.0 ? 1.0 : elementary_pow(x, tightness);
}

#endif
