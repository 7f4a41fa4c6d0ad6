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
/* The folder that the code of this library was loaded from; of a copy for wider processors, which the system's loader
 * found in glibc-hwcaps/<wide>/, the folder that has the baseline. False: unknown. */
bool dl_own_folder(char *out, size_t size);
/* The processors that this copy of the library was compiled for, such as "x86-64-v3", or "" for the baseline. Where it
 * runs, plugins compiled for the same may run too. */
const char *dl_wide(void);

#endif
