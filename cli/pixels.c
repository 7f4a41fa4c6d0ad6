#define _DEFAULT_SOURCE   /* madvise */
#include "pixels.h"

#include <stdint.h>
#include <stdlib.h>
#include <sys/mman.h>

static const size_t large = (size_t)2 << 20;

float *pixels_make(size_t width, size_t height)
{
    const size_t bytes = 4 * sizeof(float) * width * height, whole = (bytes + large - 1) & ~(large - 1);
    void *block;

    if (bytes < large / 2)
        return malloc(bytes);
    if (bytes > SIZE_MAX - large || posix_memalign(&block, large, whole) != 0)
        return NULL;
#ifdef MADV_HUGEPAGE
    madvise(block, whole, MADV_HUGEPAGE);
#endif
    return block;
}
