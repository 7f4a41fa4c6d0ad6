/* working.h - linear light as the numbers that a scene calculates in, which assumed_gamma decodes. */
#ifndef SDL_WORKING_H
#define SDL_WORKING_H

#include "base/srgb.h"
#include "sdl/state.h"

static inline bool working_is_linear(const settings_parsed *s) { return !(s->assumed_gamma > 0.0) || s->assumed_gamma == 1.0; }

/* A power has no numbers below zero. */
static inline double working_of(const settings_parsed *s, double linear)
{
    if (s->assumed_srgb)
        return srgb_encode(linear);
    if (working_is_linear(s))
        return linear;
    return linear > 0.0 ? elementary_pow(linear, 1.0 / s->assumed_gamma) : 0.0;
}

#endif
