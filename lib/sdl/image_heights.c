#include "sdl/image_heights.h"

#include "sdl/image_decode.h"
#include "sdl/image_file.h"

#include <string.h>

static uint16_t wide_at(const unsigned char *at, uint32_t channel)
{
    uint16_t wide;

    memcpy(&wide, at + 2 * channel, sizeof wide);
    return wide;
}

/* Rounded as POV-Ray rounds it: of grey that decides the last digit of the sum. */
static float share_at(const unsigned char *at, uint32_t channel)
{
    return (float)(wide_at(at, channel) / 65535.0);
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
 * brightness, and grey as it is, of 8 bits as image_map sees it. */
static uint16_t height_at(const image *of, const unsigned char *at)
{
    const bool is_grey = of->channels < 3;

    if (of->bits == 8 && of->is_cut)
        return (uint16_t)(257 * image_cut_grey(at[0] / 255.0));
    if (of->bits == 8)
        return (uint16_t)(at[0] << 8 | (of->colours > 0 ? 0 : is_grey ? at[0] : at[1]));
    if (of->bits == 16)
        return is_grey ? wide_at(at, 0) : height_of(65535.0 * (0.297 * share_at(at, 0) + 0.589 * share_at(at, 1) + 0.114 * share_at(at, 2)));
    return height_of(65535.0 * (is_grey ? real_at(at, 0) : 0.297 * real_at(at, 0) + 0.589 * real_at(at, 1) + 0.114 * real_at(at, 2)));
}

static double level(const image *of, const image_gamma *given, const unsigned char *at, uint32_t channel)
{
    return image_decoded(given, of->bits == 8 ? at[channel] / 255.0 : of->bits == 16 ? wide_at(at, channel) / 65535.0
                                                                   : (double)real_at(at, channel));
}

/* The same where a gamma is given. */
static uint16_t decoded_height_at(const image *of, const image_gamma *given, const unsigned char *at)
{
    const double first = level(of, given, at, 0);

    if (of->colours > 0)
        return height_at(of, at);
    if (of->channels < 3)
        return of->is_cut ? (uint16_t)(257 * image_cut_grey(first)) : height_of(65535.0 * first);
    if (of->bits == 8)
        return height_of(255.0 * (256.0 * first + level(of, given, at, 1)));
    return height_of(65535.0 * (0.297 * first + 0.589 * level(of, given, at, 1) + 0.114 * level(of, given, at, 2)));
}

static const uint16_t *convert(pov_reader *in, const image *of, const image_gamma *given)
{
    uint16_t *const out = state_alloc(in, sizeof *out * of->width * of->height, 16);

    if (!out)
        return NULL;
    for (uint32_t y = 0; y < of->height; y++)
        for (uint32_t x = 0; x < of->width; x++) {
            const unsigned char *at = of->samples + y * of->stride + x * (of->channels * of->bits / 8);

            out[(size_t)y * of->width + x] = given->is_given ? decoded_height_at(of, given, at) : height_at(of, at);
        }
    return out;
}

/* Those of 16 bits of grey are heights as they stand, as a function makes them. */
const uint16_t *image_heights_read(pov_reader *in, uint32_t *width, uint32_t *height)
{
    image_gamma given;
    const image *of = image_file_parse(in, &given, true);

    *width = of ? of->width : 0;
    *height = of ? of->height : 0;
    if (of && of->bits == 16 && of->channels == 1 && of->stride == sizeof(uint16_t) * of->width && !given.is_given)
        return (const uint16_t *)(const void *)of->samples;
    return of ? convert(in, of, &given) : NULL;
}
