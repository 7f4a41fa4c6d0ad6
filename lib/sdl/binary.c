#include "sdl/binary.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

static const binary_format formats[] = {
    { "uint8", 1, 0, 255, 0 },               { "sint8", 1, -128, 127, 0 },
    { "uint16be", 2, 0, 65535, 0 },          { "uint16le", 2, 0, 65535, 1 },
    { "sint16be", 2, -32768, 32767, 0 },     { "sint16le", 2, -32768, 32767, 1 },
    { "sint32be", 4, -2147483648.0, 2147483647.0, 0 },
    { "sint32le", 4, -2147483648.0, 2147483647.0, 1 },
};

const binary_format *binary_find(const char *word)
{
    for (size_t i = 0; i < sizeof formats / sizeof formats[0]; i++)
        if (strcmp(formats[i].word, word) == 0)
            return &formats[i];
    return NULL;
}

size_t binary_put(const binary_format *f, double number, char out[4])
{
    const double nearest = floor(number + 0.5);
    const double held = nearest > f->most ? f->most : nearest >= f->least ? nearest : f->least;
    const uint32_t bits = (uint32_t)(int64_t)held;

    for (int i = 0; i < f->bytes; i++)
        out[f->is_little ? i : f->bytes - 1 - i] = (char)(bits >> 8 * i & 0xFF);
    return (size_t)f->bytes;
}
