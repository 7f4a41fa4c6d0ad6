/* bytes.h - reads numbers from the bytes of a file, and never past their end. */
#ifndef COMMON_BYTES_H
#define COMMON_BYTES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Past the end every number is 0, and is_cut says so. */
typedef struct common_bytes {
    const unsigned char *at, *end;
    bool is_cut;
} common_bytes;

static inline common_bytes common_bytes_of(const void *bytes, size_t count)
{
    common_bytes b = { bytes, (const unsigned char *)bytes + count, false };
    return b;
}

static inline size_t common_bytes_left(const common_bytes *b) { return (size_t)(b->end - b->at); }

/* The next `count` bytes; NULL: there are fewer. */
static inline const unsigned char *common_bytes_take(common_bytes *b, size_t count)
{
    const unsigned char *at = b->at;

    if (common_bytes_left(b) < count) {
        b->is_cut = true;
        b->at = b->end;
        return NULL;
    }
    b->at += count;
    return at;
}

static inline unsigned common_byte(common_bytes *b)
{
    const unsigned char *at = common_bytes_take(b, 1);

    return at ? at[0] : 0;
}

/* 16 and 32 bits, the low byte first. */
static inline unsigned common_byte2(common_bytes *b)
{
    const unsigned char *at = common_bytes_take(b, 2);

    return at ? (unsigned)(at[0] | at[1] << 8) : 0;
}

static inline uint32_t common_byte4(common_bytes *b)
{
    const uint32_t low = common_byte2(b);

    return low | (uint32_t)common_byte2(b) << 16;
}

/* Is the machine's low byte first? */
static inline bool common_is_little_endian(void)
{
    const uint16_t one = 1;

    return *(const unsigned char *)&one == 1;
}

#endif
