#include "sdl/image_heights.h"

#include "sdl/image_file.h"

#include <string.h>

static uint16_t wide_at(const unsigned char *at, uint32_t channel)
{
    uint16_t wide;

    memcpy(&wide, at + 2 * channel, sizeof wide);
    return wide;
}

static float real_at(const unsigned char *at, uint32_t channel)
{
    float real;

    memcpy(&real, at + 4 * channel, sizeof real);
    return real;
}

static uint16_t height_of(double grey)
{
    return (uint16_t)(grey <= 0.0 ? 0.0 : grey >= 65535.0 ? 65535.0 : grey);
}

/* An index is the high byte; so are 8 bits of red, to which green is the low one. Other colours count by their
 * brightness, and grey as it is. */
static uint16_t height_at(const image *of, const unsigned char *at)
{
    const bool is_grey = of->channels < 3;

    if (of->bits == 8)
        return (uint16_t)(at[0] << 8 | (of->colours > 0 ? 0 : is_grey ? at[0] : at[1]));
    if (of->bits == 16)
        return is_grey ? wide_at(at, 0) : height_of(0.297 * wide_at(at, 0) + 0.589 * wide_at(at, 1) + 0.114 * wide_at(at, 2));
    return height_of(65535.0 * (is_grey ? real_at(at, 0) : 0.297 * real_at(at, 0) + 0.589 * real_at(at, 1) + 0.114 * real_at(at, 2)));
}

const uint16_t *image_heights_read(pov_reader *in, uint32_t *width, uint32_t *height)
{
    image_gamma unused;
    const image *of = image_file_parse(in, &unused, false);
    uint16_t *out = of ? state_alloc(in, sizeof *out * of->width * of->height, 16) : NULL;

    *width = *height = 0;
    if (!out)
        return NULL;
    for (uint32_t y = 0; y < of->height; y++)
        for (uint32_t x = 0; x < of->width; x++)
            out[(size_t)y * of->width + x] = height_at(of, of->samples + y * of->stride + x * (of->channels * of->bits / 8));
    *width = of->width;
    *height = of->height;
    return out;
}
