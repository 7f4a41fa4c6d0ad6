/* estimate.h - from the cells to the error of the whole picture: a row of the report. */
#ifndef RENDER_ESTIMATE_H
#define RENDER_ESTIMATE_H

#include "render/cells.h"
#include "render/settings.h"

/* Fill the members that follow from the cells; the rest of the row stays. `scratch` holds a number for each cell. */
void estimate_row(const cells *c, const settings *s, double *scratch, pov_pass *row);

#endif
