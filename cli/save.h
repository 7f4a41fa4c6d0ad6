/* save.h - the files that a run writes: none twice, and none that it reads. */
#ifndef CLI_SAVE_H
#define CLI_SAVE_H

#include "args.h"

/* Are the files that the run writes different from each other, and from those that it reads? Called before any of them
 * is opened. */
pov_status save_check_names(const args *a, pov_error *err);
/* False: a named pipe without a reader; opening it would block. */
bool save_is_awaited(const char *path);

/* Fill err and return its status: cli's way to say what went wrong with a file ("" for none). */
pov_status save_fail(pov_error *err, pov_status status, const char *file, const char *message);

#endif
