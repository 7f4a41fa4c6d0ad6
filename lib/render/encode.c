#include "render/encode.h"

#include "base/srgb.h"

#include <math.h>
#include <string.h>

static double encoded(const encoder *e, double linear)
{
    if (e->gamma > 0.0)
        return pow(linear, 1.0 / e->gamma);
    return e->transfer == POV_TRANSFER_SRGB ? srgb_encode(linear) : linear;
}

static double encoded_inverse(const encoder *e, double stored)
{
    if (e->gamma > 0.0)
        return pow(stored, e->gamma);
    return e->transfer == POV_TRANSFER_SRGB ? srgb_decode(stored) : stored;
}

static void fill_tables(encoder *e)
{
    int code = 0;

    for (int i = 0; i < 255; i++) {
        e->above[i] = (float)encoded_inverse(e, (i + 0.5) / 255.0);
    }
    e->above[255] = HUGE_VALF;
    for (int i = 0; i < ENCODER_CELLS; code++) {   /* cells below the next threshold; the product is exact */
        const int end = code < 255 ? (int)ceilf(pov_minf(e->above[code], 1.0f) * ENCODER_CELLS) : ENCODER_CELLS;

        if (end > i)
            memset(e->least + i, code, (size_t)(end - i));
        i = end > i ? end : i;
    }
}

void encoder_init(encoder *e, int bits, pov_transfer transfer, double gamma)
{
    e->gamma = gamma;
    e->bits = bits;
    e->transfer = transfer;
    if (bits == 8)
        fill_tables(e);
}

/* Number of the 255 thresholds that the value reaches. Most cells of the table hold one at most, which nobody can guess: it is counted without a
 * branch. */
static unsigned char stored_8(const encoder *e, float v)
{
    const float within = v > 0.0f ? (v < 1.0f ? v : 0x1.fffffep-1f) : 0.0f;
    unsigned code = e->least[(int)(within * ENCODER_CELLS)];

    code += within >= e->above[code];
    while (within >= e->above[code])
        code++;
    return (unsigned char)(v >= 1.0f ? 255 : code);
}

static uint16_t stored_16(const encoder *e, float v)
{
    const double x = v > 0.0f ? (v < 1.0f ? v : 1.0) : 0.0;

    return (uint16_t)(65535.0 * encoded(e, x) + 0.5);
}

static float part_of(float v) { return v > 0.0f ? (v < 1.0f ? v : 1.0f) : 0.0f; }

/* NaN counts as no light. */
static inline void store_lights(const float *rgba, size_t count, float *out)
{
    float some[4];

    for (int c = 0; c < 4; c++)
        some[c] = rgba[c] == rgba[c] ? rgba[c] : 0.0f;
    memcpy(out, some, count * sizeof *out);
}

/* Three channels: what is written behind a pixel is overwritten by the next one. */
static void store_colours(const float *rgba, size_t pixels, float *out)
{
    size_t i;

    for (i = 0; i + 1 < pixels; i++)
        store_lights(rgba + 4 * i, 4, out + 3 * i);
    if (i < pixels)
        store_lights(rgba + 4 * i, 3, out + 3 * i);
}

static void store_floats(const float *rgba, size_t pixels, int channels, float *out)
{
    if (channels == 3) {
        store_colours(rgba, pixels, out);
        return;
    }
    for (size_t i = 0; i < pixels; i++, rgba += 4, out += 4) {
        store_lights(rgba, 3, out);
        out[3] = part_of(rgba[3]);
    }
}

static void store_bytes(const encoder *e, const float *rgba, size_t pixels, int channels, unsigned char *out)
{
    for (size_t i = 0; i < pixels; i++, rgba += 4, out += channels) {
        for (int c = 0; c < 3; c++)
            out[c] = stored_8(e, rgba[c]);
        if (channels == 4)
            out[3] = (unsigned char)(255.0f * part_of(rgba[3]) + 0.5f);
    }
}

static void store_words(const encoder *e, const float *rgba, size_t pixels, int channels, uint16_t *out)
{
    for (size_t i = 0; i < pixels; i++, rgba += 4, out += channels) {
        for (int c = 0; c < 3; c++)
            out[c] = stored_16(e, rgba[c]);
        if (channels == 4)
            out[3] = (uint16_t)(65535.0 * (double)part_of(rgba[3]) + 0.5);
    }
}

void encoder_row(const encoder *e, const float *rgba, int width, int channels, void *out)
{
    if (e->bits == 8)
        store_bytes(e, rgba, (size_t)width, channels, out);
    else if (e->bits == 16)
        store_words(e, rgba, (size_t)width, channels, out);
    else
        store_floats(rgba, (size_t)width, channels, out);
}
