/* run.h - what the command line asks for: render a scene, check it, join parts, compare reports. */
#ifndef CLI_RUN_H
#define CLI_RUN_H

#include "messages.h"

/* SHORT: a limit ended it before the requested error or count was reached. ROUND: the parts are to be traced again. */
typedef enum run_end { RUN_COMPLETE, RUN_SHORT, RUN_ROUND } run_end;

pov_status run_args(const args *a, messages *m, run_end *end, pov_error *err);

#endif
