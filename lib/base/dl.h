/* dl.h - shared objects. */
#ifndef BASE_DL_H
#define BASE_DL_H

#include <stdbool.h>
#include <stddef.h>

/* NULL with the reason in `why`. */
void *dl_open(const char *path, char *why, size_t why_size);
/* The address of a data symbol, or NULL. */
const void *dl_data(void *handle, const char *symbol);
void dl_close(void *handle);
/* The folder that this library was loaded from. A copy for wider processors is found by the system's loader in
 * glibc-hwcaps/<wide>/; the result is then the folder of the baseline. False: unknown. */
bool dl_own_folder(char *out, size_t size);
/* The processors that this copy of the library was compiled for, such as "x86-64-v3", or "" for the baseline. Plugins
 * compiled for the same processors can run wherever this copy runs. */
const char *dl_wide(void);

#endif
