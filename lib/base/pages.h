/* pages.h - what the system is told of large blocks of memory. */
#ifndef BASE_PAGES_H
#define BASE_PAGES_H

#include <stddef.h>

/* A block that is about to be filled, and will be used all over. Systems that have larger pages may then take them,
 * which are fewer to fetch. What the block holds does not change. */
void pages_expect(void *block, size_t bytes);

#endif
