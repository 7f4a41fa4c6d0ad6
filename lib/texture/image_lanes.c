#include "texture/image_sample.h"

#include <string.h>

/* Flat images, between two pixels each way: points side by side, with the same bits as one by one. */

enum { TAPS = 4, CHANNELS = 3 };

/* The upper left pixel at each point, the upper right one, and those below; weights, and what they store. */
typedef struct SIMD_ALIGNED tap_lanes {
    double weight[TAPS][LANES_MAX];
    double column[2][LANES_MAX], row[2][LANES_MAX];
    float stored[CHANNELS][TAPS][LANES_MAX];
    float value[CHANNELS + 2][LANES_MAX];   /* and filter and transmit */
    int64_t outside[LANES_MAX];
} tap_lanes;

bool image_has_lanes(const image_map *map)
{
    return map->type == IMAGE_PLANAR && map->interpolation == IMAGE_BILINEAR && !map->palette && map->image->channels % 2 == 1;
}

/* From 0 to below 1. */
SIMD_INLINE double repeated(double v)
{
    const double f = v - floor(v);

    return f < 1.0 ? f : 0.0;
}

/* The pixel at -1 or at `size` is one that repeats, or the edge. */
SIMD_INLINE double bound(double i, double size, bool once)
{
    const double before = once ? 0.0 : size - 1.0, behind = once ? size - 1.0 : 0.0;

    return i < 0.0 ? before : i < size ? i : behind;
}

SIMD_CLONES static void find_taps(const vec_lanes *restrict at, double width, double height, bool once, uint32_t n,
                                  tap_lanes *restrict out)
{
    for (uint32_t i = 0; i < n; i++) {
        const bool is_near = (fabs(at->x[i]) <= 0x1p52) & (fabs(at->y[i]) <= 0x1p52);
        const double u = is_near ? at->x[i] : 0.0, v = is_near ? at->y[i] : 0.0;
        const double x = repeated(u) * width - 0.5, y = (1.0 - repeated(v)) * height - 0.5;
        const double left = floor(x), top = floor(y), tx = x - left, ty = y - top;

        out->column[0][i] = bound(left, width, once);
        out->column[1][i] = bound(left + 1.0, width, once);
        out->row[0][i] = bound(top, height, once);
        out->row[1][i] = bound(top + 1.0, height, once);
        out->weight[0][i] = (1.0 - tx) * (1.0 - ty);
        out->weight[1][i] = tx * (1.0 - ty);
        out->weight[2][i] = (1.0 - tx) * ty;
        out->weight[3][i] = tx * ty;
        out->outside[i] = (once & ((u < 0.0) | (u > 1.0) | (v < 0.0) | (v > 1.0))) ? 1 : 0;
    }
}

/* ---- what pixels store ---- */

SIMD_INLINE float stored_at(const float *decoded, const unsigned char *samples, size_t number, uint32_t bits)
{
    uint16_t wide;
    float real;

    if (bits == 8)
        return decoded ? decoded[samples[number]] : (float)samples[number];
    if (bits == 16) {
        memcpy(&wide, samples + 2 * number, sizeof wide);
        return decoded ? decoded[wide] : (float)wide;
    }
    memcpy(&real, samples + 4 * number, sizeof real);
    return real;
}

/* bits: of the image, a constant of each copy. */
SIMD_INLINE void fetch(const image_map *map, uint32_t bits, uint32_t n, tap_lanes *t)
{
    const image *of = map->image;
    const uint32_t channels = of->channels;

    for (uint32_t i = 0; i < n; i++)
        for (int k = 0; k < TAPS; k++) {
            const unsigned char *row = of->samples + (size_t)t->row[k >> 1][i] * of->stride;
            const size_t first = (size_t)t->column[k & 1][i] * channels;

            for (uint32_t c = 0; c < channels; c++)
                t->stored[c][k][i] = stored_at(map->decoded, row, first + c, bits);
        }
}

/* Returns what 1 is stored as. */
static double fetch_all(const image_map *map, uint32_t n, tap_lanes *t)
{
    const uint32_t bits = map->image->bits;

    if (bits == 8)
        fetch(map, 8, n, t);
    else if (bits == 16)
        fetch(map, 16, n, t);
    else
        fetch(map, 32, n, t);
    return map->decoded || bits == 32 ? 1.0 : bits == 8 ? 255.0 : 65535.0;
}

/* ---- between pixels ---- */

SIMD_CLONES static void decode(double one, uint32_t n, float *restrict stored)
{
    for (uint32_t i = 0; i < n; i++)
        stored[i] = (float)((double)stored[i] / one);
}

SIMD_CLONES static void mix(const tap_lanes *restrict t, uint32_t c, uint32_t n, float *restrict value)
{
    for (uint32_t i = 0; i < n; i++)
        value[i] = (float)((((0.0 + t->weight[0][i] * (double)t->stored[c][0][i]) + t->weight[1][i] * (double)t->stored[c][1][i]) +
                            t->weight[2][i] * (double)t->stored[c][2][i]) + t->weight[3][i] * (double)t->stored[c][3][i]);
}

/* The same where all pixels have the same. */
SIMD_CLONES static void mix_one(const tap_lanes *restrict t, double of, uint32_t n, float *restrict value)
{
    for (uint32_t i = 0; i < n; i++)
        value[i] = (float)((((0.0 + t->weight[0][i] * of) + t->weight[1][i] * of) + t->weight[2][i] * of) + t->weight[3][i] * of);
}

static void find_values(const image_map *map, double one, uint32_t n, tap_lanes *t)
{
    for (uint32_t c = 0; c < map->image->channels; c++) {
        for (int k = 0; one != 1.0 && k < TAPS; k++)
            decode(one, n, t->stored[c][k]);
        mix(t, c, n, t->value[c]);
    }
    mix_one(t, map->filter, n, t->value[CHANNELS]);
    mix_one(t, map->transmit, n, t->value[CHANNELS + 1]);
}

void image_colours(const image_map *map, const vec_lanes *at, uint32_t n, pigment *out)
{
    static const pigment nothing = { { 1.0f, 1.0f, 1.0f }, 0.0f, 1.0f };
    const uint32_t whole = lanes_whole(n), green = map->image->channels < 3 ? 0 : 1, blue = 2 * green;
    tap_lanes t;

    find_taps(at, map->image->width, map->image->height, map->once, whole, &t);
    find_values(map, fetch_all(map, whole, &t), whole, &t);
    for (uint32_t i = 0; i < n; i++) {
        const pigment p = { { t.value[0][i], t.value[green][i], t.value[blue][i] }, t.value[CHANNELS][i], t.value[CHANNELS + 1][i] };

        out[i] = t.outside[i] ? nothing : p;
    }
}
