/* batch.h - which paths are followed next. */
#ifndef SHADE_BATCH_H
#define SHADE_BATCH_H

#include "shade/shade.h"

/* t->now, t->mirrored and t->passed, empty. False: no memory. */
bool batch_make(pov_tracer *t);
/* Nothing waits any more, and no path has media or spots. */
void batch_forget(pov_tracer *t);
/* All there are. */
void batch_free(pov_tracer *t);
/* Of t->mirrored, t->passed and those that wait, the next batch into t->now. False: none, or t->failed. */
bool batch_next(pov_tracer *t);

#endif
