/* estimate.h - from the cells to the error of the whole picture: a row of the report. */
#ifndef RENDER_ESTIMATE_H
#define RENDER_ESTIMATE_H

#include "render/cells.h"
#include "render/settings.h"

/* Fill the members that follow from the cells; the rest of the row stays. `scratch` holds a number for each cell. */
void estimate_row(const cells *c, const settings *s, double *scratch, pov_pass *row);

/* The estimate at which a picture like this one has the error asked for: that error; or less, where so few pixels have the error that
 * the true one may be larger than the estimate by more than a fifth. */
double estimate_asked(const settings *s, const pov_pass *now);

#endif
