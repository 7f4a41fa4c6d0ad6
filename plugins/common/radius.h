/* radius.h - a radius as it is written: a negative one is taken as positive. */
#ifndef COMMON_RADIUS_H
#define COMMON_RADIUS_H

#include <povtrace/shape.h>

#include <math.h>

static inline double common_radius_of(const pov_host *host, pov_reader *in, double written)
{
    if (written < 0.0)
        host->warn(in, "a negative radius is taken as positive");
    return fabs(written);
}

static inline double common_radius(const pov_host *host, pov_reader *in)
{
    return common_radius_of(host, in, host->number(in));
}

#endif
