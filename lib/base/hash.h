/* hash.h - whether bytes are the same as before, as near as 64 bits can tell. Not against forgers. */
#ifndef BASE_HASH_H
#define BASE_HASH_H

#include <stddef.h>
#include <stdint.h>

/* Go on from an earlier hash, or from 0. */
uint64_t hash_bytes(uint64_t hash, const void *bytes, size_t count);

#endif
