/* merge.h - from the parts of a picture to the picture, or to the next round of the parts. */
#ifndef CLI_MERGE_H
#define CLI_MERGE_H

#include "run.h"

pov_status merge_run(const args *a, const messages *m, pov_context *context, run_end *end, pov_error *err);

#endif
