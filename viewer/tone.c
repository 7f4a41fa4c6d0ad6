#include "tone.h"

#include <math.h>

static double encode(pov_transfer transfer, double v)
{
    if (transfer == POV_TRANSFER_LINEAR)
        return v;
    return v <= 0.0031308 ? 12.92 * v : 1.055 * pow(v, 1.0 / 2.4) - 0.055;
}

void tone_init(tone *t, pov_transfer transfer, double gain)
{
    t->gain = (float)gain;
    for (int i = 0; i <= TONE_STEPS; i++)
        t->codes[i] = (uint8_t)(255.0 * encode(transfer, (double)i / TONE_STEPS) + 0.5);
}

void tone_exact(pov_transfer transfer, const float *rgba, uint8_t *out)
{
    for (int c = 0; c < 3; c++) {
        double v = (double)rgba[c];

        out[c] = (uint8_t)(255.0 * encode(transfer, v > 0.0 ? v < 1.0 ? v : 1.0 : 0.0) + 0.5);
    }
    out[3] = rgba[3] > 0.0f ? 255 : 0;
}

static uint8_t code(const tone *t, float v)
{
    v *= t->gain;
    return t->codes[v >= 1.0f ? TONE_STEPS : v > 0.0f ? (int)(v * TONE_STEPS + 0.5f) : 0];
}

void tone_row(const tone *t, const float *rgba, uint8_t *out, int count)
{
    for (int i = 0; i < count; i++, rgba += 4, out += 4) {
        bool there = rgba[3] > 0.0f;

        for (int c = 0; c < 3; c++)
            out[c] = there ? code(t, rgba[c]) : 0;
        out[3] = there ? 255 : 0;
    }
}
