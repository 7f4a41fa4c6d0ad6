#include "base/hash.h"

#include <string.h>

/* The step of FNV-1a, by words of eight bytes and with the high half brought down, as a product only moves up. */
static uint64_t step(uint64_t hash, uint64_t word)
{
    hash = (hash ^ word) * 0x9fb21c651e98df25u;
    return hash ^ hash >> 32;
}

uint64_t hash_bytes(uint64_t hash, const void *bytes, size_t count)
{
    const unsigned char *at = bytes;
    uint64_t word;

    hash = step(hash ^ 0xcbf29ce484222325u, count);
    for (; count >= sizeof word; count -= sizeof word, at += sizeof word) {
        memcpy(&word, at, sizeof word);
        hash = step(hash, word);
    }
    word = 0;
    memcpy(&word, at, count);
    return step(step(hash, word), 0);
}
