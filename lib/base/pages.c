#define _DEFAULT_SOURCE   /* madvise */
#include "base/pages.h"

#include <stdint.h>
#include <sys/mman.h>
#include <unistd.h>

/* Less could not hold a page of the next size for certain. */
#define LEAST ((size_t)4 << 20)

void pages_expect(void *block, size_t bytes)
{
#ifdef MADV_HUGEPAGE
    const size_t page = (size_t)sysconf(_SC_PAGESIZE), before = (page - ((uintptr_t)block & (page - 1))) & (page - 1);

    if (bytes >= LEAST)
        madvise((char *)block + before, (bytes - before) & ~(page - 1), MADV_HUGEPAGE);
#else
    (void)block;
    (void)bytes;
#endif
}
