/* form.h - bounds of a function and of its derivative over stretches of lines, for several stretches side by side.
 *
 * Let u go from -1 to 1 along a stretch. A form says that a value is middle + slope u, off by at most `off`, and that its
 * derivative by u is slope, off by at most `slope_off`. Both bounds hold for what the operations mean, and cover the
 * roundings of the form itself; `off` falls with the square of the stretch. What is not known is infinite or NaN. See
 * docs/numerics.md. */
#ifndef FUNCTION_FORM_H
#define FUNCTION_FORM_H

#include "function/tape.h"

#include <povtrace/plugin.h>

/* `registers`: tape->registers of them; the first hold the arguments. The result is registers[tape->result]. */
void form_run(const tape *t, pov_form *registers);

#endif
