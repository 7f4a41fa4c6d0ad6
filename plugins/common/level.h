/* level.h - where a function of the scene passes a threshold along a line, by bounds of the function and of its derivative
 * over stretches of the line.
 *
 * A stretch whose bounds keep off the threshold holds no crossing. One whose derivative keeps off zero holds one crossing if
 * its ends are on different sides, else none. Any other is cut into eight, down to 2^-46 of the container. */
#ifndef COMMON_LEVEL_H
#define COMMON_LEVEL_H

#include "common/local.h"

/* Points at o + t d. */
typedef struct common_level {
    const pov_function_bounds *f;
    double threshold;
    pov_vec3 o, d;
    void *memory;                /* f->registers of pov_form */
    double shortest;             /* stretches are cut no further */
    double start;                /* where the line starts on the surface: below 0 if it goes below the threshold, else 0 or more */
    bool from_surface;
    double approx_from, approx_to; /* crossings that lie in between need not be exact */
    uint32_t work;               /* stretches that were bounded */
    bool (*found)(void *user, double t);     /* false: nothing more is wanted */
    void *user;
} common_level;

/* Stretches one behind the other, at most POV_FORMS. False: found() returned false. */
bool common_level_search(common_level *n, const double *lo, const double *hi, int count);
/* Value of the function less the threshold, at a point; `memory` for f->registers of pov_slope. */
double common_level_value(const pov_function_bounds *f, double threshold, pov_vec3 at, pov_slope *memory);
/* Its gradient, and the function's value there. */
pov_vec3 common_level_gradient(const pov_function_bounds *f, pov_vec3 at, pov_slope *memory, double *value);
/* Below the threshold at a point of the line? */
bool common_level_is_below(const common_level *n, double t);

#endif
