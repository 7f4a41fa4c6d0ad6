#include "texture/image_sample.h"

#include "base/elementary.h"

#include <string.h>

/* Images between two pixels each way: points side by side, with the same bits as one by one. */

enum { TAPS = 4, CHANNELS = 3, VALUES = 5 };   /* red, green, blue; filter, transmit */

/* The upper left pixel at each point, the upper right one, and those below; weights, and what they store. */
typedef struct SIMD_ALIGNED tap_lanes {
    double weight[TAPS][LANES_MAX], within[2][LANES_MAX];
    int32_t column[2][LANES_MAX], row[2][LANES_MAX];
    int32_t whole[CHANNELS][TAPS][LANES_MAX];   /* what is stored as whole numbers */
    float stored[VALUES][TAPS][LANES_MAX];  /* filter and transmit of palettes alone */
    float value[VALUES][LANES_MAX];
} tap_lanes;

bool image_has_lanes(const image_map *map)
{
    return (map->interpolation == IMAGE_BILINEAR || map->interpolation == IMAGE_NORMALISED) &&
           (map->palette || map->image->channels % 2 == 1);
}

/* ---- where ---- */

typedef struct SIMD_ALIGNED place_lanes { double u[LANES_MAX], v[LANES_MAX]; } place_lanes;

static const double pi = 3.14159265358979323846;

SIMD_CLONES SIMD_NOINLINE static void find_turns(const vec_lanes *restrict at, uint32_t n, double *restrict u)
{
    for (uint32_t i = 0; i < n; i++) {
        const double turn = elementary_atan2(at->z[i], at->x[i]) / (2.0 * pi);

        u[i] = turn - floor(turn);
    }
}

/* Sines of the heights, within -1..1: in the loop of the angles they would keep compilers from making it vectors. */
SIMD_CLONES SIMD_NOINLINE static void find_sines(const vec_lanes *restrict at, uint32_t n, double *restrict sine)
{
    for (uint32_t i = 0; i < n; i++) {
        const double radius = sqrt(pov_dot(lanes_at(at, i), lanes_at(at, i))), v = at->y[i] / radius, c = v < -1.0 ? -1.0 : v;

        sine[i] = radius > 0.0 ? c > 1.0 ? 1.0 : c : 0.0;
    }
}

SIMD_CLONES SIMD_NOINLINE static void find_heights(const double *restrict sine, uint32_t n, double *restrict v)
{
    for (uint32_t i = 0; i < n; i++)
        v[i] = 0.5 + (0.5 * pi - elementary_acos(sine[i])) / pi;
}

SIMD_CLONES SIMD_NOINLINE static void find_tube_heights(const vec_lanes *restrict at, uint32_t n, double *restrict v)
{
    for (uint32_t i = 0; i < n; i++) {
        const double outward = sqrt(at->x[i] * at->x[i] + at->z[i] * at->z[i]) - 1.0;

        v[i] = 0.5 + elementary_atan2(at->y[i], outward) / (2.0 * pi);
    }
}

SIMD_CLONES SIMD_NOINLINE static void bound_places(uint32_t n, place_lanes *p)
{
    for (uint32_t i = 0; i < n; i++) {
        const bool is_near = (fabs(p->u[i]) <= 0x1p52) & (fabs(p->v[i]) <= 0x1p52);

        p->u[i] = is_near ? p->u[i] : 0.0;
        p->v[i] = is_near ? p->v[i] : 0.0;
    }
}

static void find_places(const image_map *map, const vec_lanes *at, uint32_t n, place_lanes *out)
{
    SIMD_ALIGNED double sine[LANES_MAX];

    if (map->type == IMAGE_PLANAR)
        memcpy(out->u, at->x, n * sizeof(double));
    else
        find_turns(at, n, out->u);
    if (map->type == IMAGE_SPHERICAL) {
        find_sines(at, n, sine);
        find_heights(sine, n, out->v);
    } else if (map->type == IMAGE_TOROIDAL) {
        find_tube_heights(at, n, out->v);
    } else {
        memcpy(out->v, at->y, n * sizeof(double));
    }
    bound_places(n, out);
}

static inline bool is_outside(const image_map *map, double u, double v)
{
    return map->once && (u < 0.0 || u > 1.0 || v < 0.0 || v > 1.0);
}

void image_places(const image_map *map, const vec_lanes *at, uint32_t n, image_place *out)
{
    place_lanes p;

    find_places(map, at, lanes_whole(n), &p);
    for (uint32_t i = 0; i < n; i++)
        out[i] = (image_place){ p.u[i], p.v[i], is_outside(map, p.u[i], p.v[i]) };
}

/* ---- pixels about a point ---- */

/* From 0 to below 1. */
SIMD_INLINE double repeated(double v)
{
    const double f = v - floor(v);

    return f < 1.0 ? f : 0.0;
}

/* The pixel at -1 or at `size` is one that repeats, or the edge. */
SIMD_INLINE int32_t bound(double i, double size, bool once)
{
    const double before = once ? 0.0 : size - 1.0, behind = once ? size - 1.0 : 0.0;

    return (int32_t)(i < 0.0 ? before : i < size ? i : behind);
}

/* The pixel above and before each point, and how far behind it the point is. */
SIMD_CLONES SIMD_NOINLINE static void find_pixels(const place_lanes *restrict p, double width, double height, bool once, uint32_t n,
                                                  tap_lanes *restrict out)
{
    for (uint32_t i = 0; i < n; i++) {
        const double x = repeated(p->u[i]) * width - 0.5, y = (1.0 - repeated(p->v[i])) * height - 0.5;
        const double left = floor(x), top = floor(y);

        out->column[0][i] = bound(left, width, once);
        out->column[1][i] = bound(left + 1.0, width, once);
        out->row[0][i] = bound(top, height, once);
        out->row[1][i] = bound(top + 1.0, height, once);
        out->within[0][i] = x - left;
        out->within[1][i] = y - top;
    }
}

SIMD_CLONES SIMD_NOINLINE static void weigh_linear(uint32_t n, tap_lanes *out)
{
    for (uint32_t i = 0; i < n; i++) {
        const double tx = out->within[0][i], ty = out->within[1][i];

        out->weight[0][i] = (1.0 - tx) * (1.0 - ty);
        out->weight[1][i] = tx * (1.0 - ty);
        out->weight[2][i] = (1.0 - tx) * ty;
        out->weight[3][i] = tx * ty;
    }
}

/* By the inverse square of the distance; a point upon a pixel has its value. */
SIMD_INLINE double near_weight(double x, double y)
{
    const double square = x * x + y * y, weight = 1.0 / square;

    return square > 1e-30 ? weight : 1e30;
}

SIMD_CLONES SIMD_NOINLINE static void weigh_near(uint32_t n, tap_lanes *out)
{
    for (uint32_t i = 0; i < n; i++) {
        const double tx = out->within[0][i], ty = out->within[1][i];
        const double a = near_weight(tx, ty), b = near_weight(tx - 1.0, ty), c = near_weight(tx, ty - 1.0);
        const double d = near_weight(tx - 1.0, ty - 1.0), sum = ((a + b) + c) + d;

        out->weight[0][i] = a / sum;
        out->weight[1][i] = b / sum;
        out->weight[2][i] = c / sum;
        out->weight[3][i] = d / sum;
    }
}

/* ---- what pixels store ---- */

/* bits, channels and decoded or not: constants of each copy. */
SIMD_INLINE void fetch(const image_map *map, uint32_t bits, uint32_t channels, bool decodes, uint32_t n, tap_lanes *t)
{
    const image *of = map->image;
    const size_t sample = bits / 8, pixel = channels * sample;

    for (uint32_t i = 0; i < n; i++)
        for (int k = 0; k < TAPS; k++) {
            const unsigned char *from = of->samples + (size_t)t->row[k >> 1][i] * of->stride + (size_t)t->column[k & 1][i] * pixel;

            for (uint32_t c = 0; c < channels; c++, from += sample) {
                uint16_t wide = *from;

                if (bits == 16)
                    memcpy(&wide, from, sizeof wide);
                if (bits == 32)
                    memcpy(&t->stored[c][k][i], from, sizeof(float));
                else if (decodes)
                    t->stored[c][k][i] = map->decoded[wide];
                else
                    t->whole[c][k][i] = wide;
            }
        }
}

SIMD_INLINE void fetch_channels(const image_map *map, uint32_t bits, bool decodes, uint32_t n, tap_lanes *t)
{
    if (map->image->channels == 1)
        fetch(map, bits, 1, decodes, n, t);
    else
        fetch(map, bits, CHANNELS, decodes, n, t);
}

/* Whole numbers, of which 1 is this. */
SIMD_CLONES static void decode(double one, uint32_t n, const int32_t *restrict whole, float *restrict stored)
{
    for (uint32_t i = 0; i < n; i++)
        stored[i] = (float)((double)whole[i] / one);
}

static void fetch_palette(const image_map *map, uint32_t n, tap_lanes *t)
{
    const image *of = map->image;
    const size_t size = of->channels * of->bits / 8;

    for (uint32_t i = 0; i < n; i++)
        for (int k = 0; k < TAPS; k++) {
            const pigment *p = &map->palette[of->samples[(size_t)t->row[k >> 1][i] * of->stride + (size_t)t->column[k & 1][i] * size]];

            t->stored[0][k][i] = p->color.r;
            t->stored[1][k][i] = p->color.g;
            t->stored[2][k][i] = p->color.b;
            t->stored[3][k][i] = p->filter;
            t->stored[4][k][i] = p->transmit;
        }
}

static void fetch_all(const image_map *map, uint32_t n, tap_lanes *t)
{
    const uint32_t bits = map->image->bits;
    const bool decodes = map->decoded != NULL;

    if (map->palette) {
        fetch_palette(map, n, t);
        return;
    }
    if (bits == 32)
        fetch_channels(map, 32, false, n, t);
    else if (bits == 16 && decodes)
        fetch_channels(map, 16, true, n, t);
    else if (bits == 16)
        fetch_channels(map, 16, false, n, t);
    else if (decodes)
        fetch_channels(map, 8, true, n, t);
    else
        fetch_channels(map, 8, false, n, t);
    for (uint32_t c = 0; bits != 32 && !decodes && c < map->image->channels; c++)
        for (int k = 0; k < TAPS; k++)
            decode(bits == 8 ? 255.0 : 65535.0, n, t->whole[c][k], t->stored[c][k]);
}

/* ---- between pixels ---- */

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

static void find_values(const image_map *map, uint32_t n, tap_lanes *t)
{
    const uint32_t count = map->palette ? VALUES : map->image->channels;

    for (uint32_t c = 0; c < count; c++)
        mix(t, c, n, t->value[c]);
    if (map->palette)
        return;
    if (map->filter == 0.0 && map->transmit == 0.0) {
        memset(t->value[CHANNELS], 0, 2 * sizeof t->value[0]);
        return;
    }
    mix_one(t, map->filter, n, t->value[CHANNELS]);
    mix_one(t, map->transmit, n, t->value[CHANNELS + 1]);
}

void image_colours(const image_map *map, const vec_lanes *at, uint32_t n, pigment *out)
{
    static const pigment nothing = { { 1.0f, 1.0f, 1.0f }, 0.0f, 1.0f };
    const uint32_t whole = lanes_whole(n), green = map->palette || map->image->channels >= 3 ? 1 : 0, blue = 2 * green;
    place_lanes places;
    tap_lanes t;

    find_places(map, at, whole, &places);
    find_pixels(&places, map->image->width, map->image->height, map->once, whole, &t);
    (map->interpolation == IMAGE_BILINEAR ? weigh_linear : weigh_near)(whole, &t);
    fetch_all(map, whole, &t);
    find_values(map, whole, &t);
    for (uint32_t i = 0; i < n; i++) {
        const pigment p = { { t.value[0][i], t.value[green][i], t.value[blue][i] }, t.value[CHANNELS][i], t.value[CHANNELS + 1][i] };

        out[i] = is_outside(map, places.u[i], places.v[i]) ? nothing : p;
    }
}
