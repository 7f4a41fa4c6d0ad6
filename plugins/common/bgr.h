/* bgr.h - rows as TGA and BMP store them: blue, green, red and perhaps alpha, a byte each; and numbers, the low byte first. */
#ifndef COMMON_BGR_H
#define COMMON_BGR_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

static inline void common_put2(unsigned char *to, unsigned value)
{
    to[0] = (unsigned char)(value & 255);
    to[1] = (unsigned char)(value >> 8 & 255);
}

static inline void common_put4(unsigned char *to, uint32_t value)
{
    common_put2(to, value & 0xffff);
    common_put2(to + 2, value >> 16);
}

/* A row of pixels of 3 or 4 channels through `put`. False: it accepts no more. */
static inline bool common_put_bgr(const void *row, int width, int channels, bool (*put)(void *user, const void *bytes, size_t count),
                                  void *user)
{
    enum { PIXELS = 1024 };
    const unsigned char *from = row;
    unsigned char bytes[4 * PIXELS];

    for (int x = 0; x < width; x += PIXELS) {
        const int n = width - x < PIXELS ? width - x : PIXELS;
        unsigned char *to = bytes;

        for (int i = 0; i < n; i++, from += channels, to += channels) {
            to[0] = from[2];
            to[1] = from[1];
            to[2] = from[0];
            if (channels == 4)
                to[3] = from[3];
        }
        if (!put(user, bytes, (size_t)(to - bytes)))
            return false;
    }
    return true;
}

#endif
