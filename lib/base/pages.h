/* pages.h - large blocks of memory. */
#ifndef BASE_PAGES_H
#define BASE_PAGES_H

#include "base/env.h"

/* A block that is about to be filled, and will be used all over; not zeroed. Systems that have larger pages then take
 * them for a large one, which are fewer to fetch. Free it with pages_free() only. */
void *pages_reserve(const env *e, size_t bytes);
void pages_free(const env *e, void *block);

#endif
