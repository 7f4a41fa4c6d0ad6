#define _DEFAULT_SOURCE   /* madvise */
#include "base/pages.h"

#include <stdint.h>
#include <sys/mman.h>

/* Blocks are rounded up to whole large pages, which take a tenth of the time of small ones to get. */
#define LEAST (PAGES_LARGE / 2)
/* Of smaller ones the small pages are asked for in one call, in half of the time that they take one by one. */
#define SMALL ((size_t)4096)
#define SMALL_LEAST (16 * SMALL)

void *pages_reserve(const env *e, size_t bytes)
{
    const bool large = bytes >= LEAST && bytes <= SIZE_MAX - PAGES_LARGE;
    const size_t whole = large ? (bytes + PAGES_LARGE - 1) & ~(PAGES_LARGE - 1) : bytes;
    const bool small = bytes < SMALL_LEAST;
    void *block = env_reserve_aligned(e, whole, large ? PAGES_LARGE : small ? 64 : SMALL);

#ifdef MADV_HUGEPAGE
    if (block && large)
        madvise(block, whole, MADV_HUGEPAGE);
#endif
#ifdef MADV_POPULATE_WRITE
    if (block && !large && !small)
        madvise(block, bytes & ~(SMALL - 1), MADV_POPULATE_WRITE);
#endif
    return block;
}

void pages_prefetch(void *block, size_t bytes, size_t slice, size_t slices)
{
#ifdef MADV_POPULATE_WRITE
    const size_t pages = (bytes + PAGES_LARGE - 1) / PAGES_LARGE, first = pages * slice / slices,
        end = pages * (slice + 1) / slices;

    if (bytes >= LEAST && end > first)
        madvise((char *)block + first * PAGES_LARGE, (end - first) * PAGES_LARGE, MADV_POPULATE_WRITE);
#else
    (void)block, (void)bytes, (void)slice, (void)slices;
#endif
}

void pages_free(const env *e, void *block)
{
    env_free_aligned(e, block);
}
