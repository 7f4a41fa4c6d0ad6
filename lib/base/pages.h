/* pages.h - large blocks of memory. */
#ifndef BASE_PAGES_H
#define BASE_PAGES_H

#include "base/env.h"

/* Size of a large page where the system has them, and alignment of large blocks. */
#define PAGES_LARGE ((size_t)2 << 20)

/* A block that will be filled and used as a whole; not zeroed. Systems with larger pages then use one large page in
 * place of many small ones, which need fewer page faults. Free it with pages_free() only. */
void *pages_reserve(const env *e, size_t bytes);
/* Ask the system now for the memory of part `slice` of `slices` of such a block, and not at the first write; its
 * contents stay. Several threads may ask for parts at the same time. */
void pages_prefetch(void *block, size_t bytes, size_t slice, size_t slices);
void pages_free(const env *e, void *block);

#endif
