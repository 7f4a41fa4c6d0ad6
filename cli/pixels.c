#define _DEFAULT_SOURCE   /* madvise */
#include "pixels.h"

#include <stdint.h>
#include <stdlib.h>
#include <sys/mman.h>

static const size_t large = (size_t)2 << 20, small = 4096;

/* In one call: one by one they take twice as long to get. */
static float *in_small_pages(size_t bytes)
{
    void *block;

    if (posix_memalign(&block, small, bytes) != 0)
        return NULL;
#ifdef MADV_POPULATE_WRITE
    madvise(block, bytes & ~(small - 1), MADV_POPULATE_WRITE);
#endif
    return block;
}

float *pixels_make(size_t width, size_t height)
{
    const size_t bytes = 4 * sizeof(float) * width * height, whole = (bytes + large - 1) & ~(large - 1);
    void *block;

    if (bytes < large / 2)
        return in_small_pages(bytes);
    if (bytes > SIZE_MAX - large || posix_memalign(&block, large, whole) != 0)
        return NULL;
#ifdef MADV_HUGEPAGE
    madvise(block, whole, MADV_HUGEPAGE);
#endif
    return block;
}
