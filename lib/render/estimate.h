/* estimate.h - what the cells say of the whole picture: a row of the report. */
#ifndef RENDER_ESTIMATE_H
#define RENDER_ESTIMATE_H

#include "render/cells.h"
#include "render/settings.h"

/* Fill what follows from the cells; all else in the row stays. `scratch` has room for a number a cell. */
void estimate_row(const cells *c, const settings *s, double *scratch, pov_pass *row);

#endif
