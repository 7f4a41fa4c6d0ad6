/* leaf_batch.h - one scene: read it, and do with it what the command line asks for. */
#ifndef CLI_RUN_H
#define CLI_RUN_H

#include "messages.h"

/* short_of: a limit ended it before what was asked for was reached. */
pov_status run_scene(const args *a, messages *m, bool *short_of, pov_error *err);

#endif
