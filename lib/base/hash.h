/* hash.h - detects changes of bytes as far as 64 bits can. It does not withstand forgers. */
#ifndef BASE_HASH_H
#define BASE_HASH_H

#include <stddef.h>
#include <stdint.h>

/* Continue an earlier hash, or begin with 0. */
uint64_t hash_bytes(uint64_t hash, const void *bytes, size_t count);

#endif
