/* pages.h - large blocks of memory. */
#ifndef BASE_PAGES_H
#define BASE_PAGES_H

#include "base/env.h"

/* What large pages hold where there are any, and what large blocks begin at a multiple of. */
#define PAGES_LARGE ((size_t)2 << 20)

/* A block that is about to be filled, and will be used all over; not zeroed. Systems that have larger pages then take
 * them for a large one, which are fewer to fetch. Free it with pages_free() only. */
void *pages_reserve(const env *e, size_t bytes);
/* Part `part` of `parts` of such a block is asked for from the system now and not when it is first written to; what is
 * in it stays. Parts may be asked for at the same time. */
void pages_expect(void *block, size_t bytes, size_t part, size_t parts);
void pages_free(const env *e, void *block);

#endif
