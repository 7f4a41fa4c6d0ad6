/* budget.h - the number of samples of each group after the next pass. */
#ifndef RENDER_BUDGET_H
#define RENDER_BUDGET_H

#include "render/cells.h"
#include "render/settings.h"

/* Samples of every pixel before an estimate steers the distribution, and on average before it ends a job: the first
 * samples may miss a feature. */
enum { BUDGET_PILOT = 4, BUDGET_LEAST = 8 };
/* The same where each pixel has a count of its own: fewer samples go where there is nothing. */
enum { BUDGET_PILOT_SINGLES = 2, BUDGET_LEAST_SINGLES = 4 };
static inline int budget_pilot(const cells *c) { return c->singles ? BUDGET_PILOT_SINGLES : BUDGET_PILOT; }
static inline int budget_least(const cells *c) { return c->singles ? BUDGET_LEAST_SINGLES : BUDGET_LEAST; }

/* Set the targets from the measurements of the cells alone. `scratch` holds two numbers for each group. False: no group
 * may get more. */
bool budget_next(cells *c, const settings *s, const pov_pass *now, double *scratch);

/* The same while all pixels get the same number whatever they show, so that a part of the picture suffices; `now` holds
 * that number alone. False: to go on takes the whole picture, or all samples are in. */
bool budget_blind(cells *c, const settings *s, const pov_pass *now);
/* Samples of every pixel when that ends. */
int budget_blind_end(const cells *c, const settings *s);

#endif
