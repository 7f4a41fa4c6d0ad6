/* save.h - a file of a program's own, written whole or not at all. */
#ifndef CLI_SAVE_H
#define CLI_SAVE_H

#include <povtrace/base.h>

/* Beside the path and renamed over it; "-" is standard output. */
pov_status save_bytes(const char *path, const void *bytes, size_t count, pov_error *err);
/* Can a file be made there, as far as that can be told? */
pov_status save_check(const char *path, pov_error *err);

/* Fill err and return its status: cli's way to say what went wrong with a file ("" for none). */
pov_status save_fail(pov_error *err, pov_status status, const char *file, const char *message);

#endif
