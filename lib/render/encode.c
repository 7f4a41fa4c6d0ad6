#include "render/encode.h"

#include <math.h>
#include <string.h>

double encode_srgb(double linear)
{
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * pow(linear, 1.0 / 2.4) - 0.055;
}

double encode_srgb_inverse(double stored)
{
    return stored <= 0.04045 ? stored / 12.92 : pow((stored + 0.055) / 1.055, 2.4);
}

static void fill_tables(encoder *e)
{
    int code = 0;

    for (int i = 0; i < 255; i++) {
        double stored = (i + 0.5) / 255.0;
        e->above[i] = (float)(e->transfer == POV_TRANSFER_SRGB ? encode_srgb_inverse(stored) : stored);
    }
    for (int i = 0; i < ENCODER_CELLS; i++) {
        while (code < 255 && (float)i / ENCODER_CELLS >= e->above[code])
            code++;
        e->least[i] = (unsigned char)code;
    }
}

void encoder_init(encoder *e, int bits, pov_transfer transfer)
{
    e->bits = bits;
    e->transfer = transfer;
    if (bits == 8)
        fill_tables(e);
}

/* How many of the 255 thresholds the value reaches. A cell holds one of them or two. */
static unsigned char stored_8(const encoder *e, float v)
{
    int code;

    if (!(v > 0.0f))
        return 0;
    if (v >= 1.0f)
        return 255;
    code = e->least[(int)(v * ENCODER_CELLS)];
    while (code < 255 && v >= e->above[code])
        code++;
    return (unsigned char)code;
}

static uint16_t stored_16(const encoder *e, float v)
{
    double x = v > 0.0f ? (v < 1.0f ? v : 1.0) : 0.0;

    if (e->transfer == POV_TRANSFER_SRGB)
        x = encode_srgb(x);
    return (uint16_t)(65535.0 * x + 0.5);
}

static void store(const encoder *e, float v, size_t index, void *out)
{
    if (e->bits == 8)
        ((unsigned char *)out)[index] = stored_8(e, v);
    else if (e->bits == 16)
        ((uint16_t *)out)[index] = stored_16(e, v);
    else
        ((float *)out)[index] = v == v ? v : 0.0f;
}

void encoder_row(const encoder *e, const float *rgba, int width, int channels, void *out)
{
    size_t i, n = (size_t)width;
    int c;

    for (i = 0; i < n; i++)
        for (c = 0; c < channels; c++)
            store(e, c < 3 ? rgba[4 * i + (size_t)c] : 1.0f, i * (size_t)channels + (size_t)c, out);
}
