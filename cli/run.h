/* run.h - one scene: loads it, and does with it what the command line asks. */
#ifndef CLI_RUN_H
#define CLI_RUN_H

#include "messages.h"

/* short_of: a limit ended it before the requested error or count was reached. */
pov_status run_scene(const args *a, messages *m, bool *short_of, pov_error *err);

#endif
