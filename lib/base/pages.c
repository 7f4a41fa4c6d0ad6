#define _DEFAULT_SOURCE   /* madvise */
#include "base/pages.h"

#include <stdint.h>
#include <sys/mman.h>

/* The next size of pages where there are any. Blocks take whole ones: the part of the last that they have no use for is
 * small beside them. */
#define LARGE ((size_t)2 << 20)
#define LEAST (2 * LARGE)

void *pages_reserve(const env *e, size_t bytes)
{
    const size_t whole = bytes < LEAST || bytes > SIZE_MAX - LARGE ? bytes : (bytes + LARGE - 1) & ~(LARGE - 1);
    void *block = env_reserve_aligned(e, whole, bytes < LEAST ? 64 : LARGE);

#ifdef MADV_HUGEPAGE
    if (block && bytes >= LEAST)
        madvise(block, whole, MADV_HUGEPAGE);
#endif
    return block;
}

void pages_expect(void *block, size_t bytes, size_t part, size_t parts)
{
#ifdef MADV_POPULATE_WRITE
    const size_t pages = (bytes + LARGE - 1) / LARGE, first = pages * part / parts, end = pages * (part + 1) / parts;

    if (bytes >= LEAST && end > first)
        madvise((char *)block + first * LARGE, (end - first) * LARGE, MADV_POPULATE_WRITE);
#else
    (void)block, (void)bytes, (void)part, (void)parts;
#endif
}

void pages_free(const env *e, void *block)
{
    env_free_aligned(e, block);
}
