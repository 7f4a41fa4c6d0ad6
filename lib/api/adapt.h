/* adapt.h - structs of callers that were built with an older or newer header. */
#ifndef API_ADAPT_H
#define API_ADAPT_H

#include "base/err.h"

/* Copy a caller's desc into ours, which is zeroed and of `size` bytes; members that the caller's lacks stay zero. The
 * first member of both is size_t size. A NULL desc means all defaults. */
pov_status adapt_in(void *ours, size_t size, const void *theirs, const char *what, pov_error *err);
/* Copy ours into a struct that the caller receives, as much as fits; its size member stays. */
void adapt_out(void *theirs, const void *ours, size_t size);

#endif
