/* slope.h - values of a function and their derivatives in one direction, at several points side by side. */
#ifndef FUNCTION_SLOPE_H
#define FUNCTION_SLOPE_H

#include "function/tape.h"

#include <povtrace/plugin.h>

/* As form_run(). */
void slope_run(const tape *t, pov_slope *registers);

#endif
