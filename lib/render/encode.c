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

/* Number of the 255 thresholds that the value reaches. A cell of the table holds one or two of them. */
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

/* NaN counts as no light. */
static void store_floats(const float *rgba, size_t pixels, int channels, float *out)
{
    for (size_t i = 0; i < pixels; i++, rgba += 4, out += channels) {
        for (int c = 0; c < 3; c++)
            out[c] = rgba[c] == rgba[c] ? rgba[c] : 0.0f;
        if (channels == 4)
            out[3] = 1.0f;
    }
}

static void store_bytes(const encoder *e, const float *rgba, size_t pixels, int channels, unsigned char *out)
{
    for (size_t i = 0; i < pixels; i++, rgba += 4, out += channels) {
        for (int c = 0; c < 3; c++)
            out[c] = stored_8(e, rgba[c]);
        if (channels == 4)
            out[3] = 255;
    }
}

static void store_words(const encoder *e, const float *rgba, size_t pixels, int channels, uint16_t *out)
{
    for (size_t i = 0; i < pixels; i++, rgba += 4, out += channels) {
        for (int c = 0; c < 3; c++)
            out[c] = stored_16(e, rgba[c]);
        if (channels == 4)
            out[3] = 65535;
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
