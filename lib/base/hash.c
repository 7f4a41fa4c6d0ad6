#include "base/hash.h"

#include <string.h>

/* One step of FNV-1a on words of eight bytes. The high half is folded down, because a product only moves bits
 * upward. */
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
    if (count > 0)               /* of nothing there may be no address */
        memcpy(&word, at, count);
    return step(step(hash, word), 0);
}
