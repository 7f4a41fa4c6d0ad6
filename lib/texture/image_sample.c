#include "texture/image_sample.h"

#include "base/elementary.h"

#include <string.h>

/* ---- where ---- */

static const double pi = 3.14159265358979323846;

static double fraction(double v) { return v - floor(v); }

/* Around the y axis, from x towards z. */
static double turn(pov_vec3 p) { return fraction(elementary_atan2(p.z, p.x) / (2.0 * pi)); }

static double clamped_asin(double v)
{
    const double c = v < -1.0 ? -1.0 : v > 1.0 ? 1.0 : v;

    return 0.5 * pi - elementary_acos(c);
}

static double height_of(image_map_type type, pov_vec3 p)
{
    const double radius = sqrt(pov_dot(p, p));

    if (type == IMAGE_SPHERICAL)
        return radius > 0.0 ? 0.5 + clamped_asin(p.y / radius) / pi : 0.5;
    if (type == IMAGE_TOROIDAL)
        return 0.5 + elementary_atan2(p.y, sqrt(p.x * p.x + p.z * p.z) - 1.0) / (2.0 * pi);
    return p.y;
}

static bool is_finite_pair(double u, double v) { return fabs(u) <= 0x1p52 && fabs(v) <= 0x1p52; }

image_place image_place_at(const image_map *map, pov_vec3 point)
{
    image_place at = { map->type == IMAGE_PLANAR ? point.x : turn(point), height_of(map->type, point), false };

    if (!is_finite_pair(at.u, at.v))
        at.u = at.v = 0.0;
    at.is_outside = map->once && (at.u < 0.0 || at.u > 1.0 || at.v < 0.0 || at.v > 1.0);
    return at;
}

/* ---- pixels ---- */

static const unsigned char *pixel(const image *of, int64_t column, int64_t row)
{
    return of->samples + (size_t)row * of->stride + (size_t)column * (of->channels * of->bits / 8);
}

static inline float sample(const image_map *map, const unsigned char *at, uint32_t channel)
{
    uint16_t wide;
    float real;

    if (map->image->bits == 8)
        return map->decoded ? map->decoded[at[channel]] : (float)(at[channel] / 255.0);
    if (map->image->bits == 16) {
        memcpy(&wide, at + 2 * channel, sizeof wide);
        return map->decoded ? map->decoded[wide] : (float)(wide / 65535.0);
    }
    memcpy(&real, at + 4 * channel, sizeof real);
    return real;
}

/* Alpha is never encoded. */
static float alpha(const image *of, const unsigned char *at)
{
    const uint32_t channel = of->channels - 1;
    uint16_t wide;
    float real;

    if (of->bits == 8)
        return (float)(at[channel] / 255.0);
    if (of->bits == 16) {
        memcpy(&wide, at + 2 * channel, sizeof wide);
        return (float)(wide / 65535.0);
    }
    memcpy(&real, at + 4 * channel, sizeof real);
    return real;
}

/* Colours of premultiplied images are divided once they are decoded, as in POV-Ray. */
static void divide_by_alpha(colour *c, float by)
{
    if (by > 0.0f) {
        c->r /= by;
        c->g /= by;
        c->b /= by;
    }
}

static inline pigment colour_of_pixel(const image_map *map, int64_t column, int64_t row)
{
    const image *of = map->image;
    const unsigned char *at = pixel(of, column, row);
    pigment out;

    if (map->palette)
        return map->palette[at[0]];
    out.color.r = sample(map, at, 0);
    out.color.g = of->channels < 3 ? out.color.r : sample(map, at, 1);
    out.color.b = of->channels < 3 ? out.color.r : sample(map, at, 2);
    out.filter = map->filter;
    out.transmit = map->transmit;
    if (of->channels % 2 == 0) {
        const float opacity = alpha(of, at);

        out.transmit += 1.0f - opacity;
        if (map->premultiplied)
            divide_by_alpha(&out.color, opacity);
    }
    return out;
}

/* ---- between pixels ---- */

enum { PARTS = 5, TAPS = 4 };    /* red, green, blue, filter, transmit */
typedef struct parts { double of[PARTS]; } parts;

/* What is interpolated: a pixel's numbers, as many as are wanted. */
typedef struct kind {
    int count;
    void (*get)(const image_map *map, int64_t column, int64_t row, double *out);
} kind;

static inline void get_colour(const image_map *map, int64_t column, int64_t row, double *out)
{
    const pigment p = colour_of_pixel(map, column, row);

    out[0] = p.color.r;
    out[1] = p.color.g;
    out[2] = p.color.b;
    out[3] = p.filter;
    out[4] = p.transmit;
}

static inline void get_grey(const image_map *map, int64_t column, int64_t row, double *out)
{
    out[0] = image_grey_of(colour_of_pixel(map, column, row).color);
}

/* The number of a colour, or the red of what has none. */
static inline void get_index(const image_map *map, int64_t column, int64_t row, double *out)
{
    const unsigned char *at = pixel(map->image, column, row);

    out[0] = map->palette ? at[0] : sample(map, at, 0);
}

/* Within 0 to size - 1: a pixel that repeats, or the edge. */
static inline int64_t bound(int64_t i, int64_t size, bool once)
{
    if (i >= 0 && i < size)
        return i;
    if (once)
        return i < 0 ? 0 : size - 1;
    i %= size;
    return i < 0 ? i + size : i;
}

/* Pixels around a point, as many in each direction, from the upper left one on. */
typedef struct taps {
    int count;
    int64_t column, row;
    double weight[TAPS][TAPS];   /* row by row */
} taps;

/* Of the pixels before, at, behind and two behind the point. */
static void cubic_weights(double t, double w[TAPS])
{
    w[0] = 0.5 * t * (-1.0 + t * (2.0 - t));
    w[1] = 1.0 + 0.5 * t * t * (-5.0 + 3.0 * t);
    w[2] = 0.5 * t * (1.0 + t * (4.0 - 3.0 * t));
    w[3] = 0.5 * t * t * (-1.0 + t);
}

static void find_cubic(double tx, double ty, taps *out)
{
    double wx[TAPS], wy[TAPS];

    out->count = TAPS;
    out->column--;
    out->row--;
    cubic_weights(tx, wx);
    cubic_weights(ty, wy);
    for (int j = 0; j < TAPS; j++)
        for (int i = 0; i < TAPS; i++)
            out->weight[j][i] = wx[i] * wy[j];
}

static void find_linear(double tx, double ty, taps *out)
{
    out->count = 2;
    out->weight[0][0] = (1.0 - tx) * (1.0 - ty);
    out->weight[0][1] = tx * (1.0 - ty);
    out->weight[1][0] = (1.0 - tx) * ty;
    out->weight[1][1] = tx * ty;
}

/* By the inverse square of the distance; a point upon a pixel has its value. */
static double near_weight(double x, double y)
{
    const double square = x * x + y * y;

    return square > 1e-30 ? 1.0 / square : 1e30;
}

static void find_near(double tx, double ty, taps *out)
{
    double sum = 0.0;

    out->count = 2;
    for (int k = 0; k < 4; k++)
        sum += out->weight[k / 2][k % 2] = near_weight(tx - k % 2, ty - k / 2);
    for (int k = 0; k < 4; k++)
        out->weight[k / 2][k % 2] /= sum;
}

static void find_taps(image_interpolation how, double x, double y, taps *out)
{
    const double left = floor(x), top = floor(y);

    out->column = (int64_t)left;
    out->row = (int64_t)top;
    (how == IMAGE_BICUBIC ? find_cubic : how == IMAGE_BILINEAR ? find_linear : find_near)(x - left, y - top, out);
}

/* From 0 to below 1. */
static double repeated(double v)
{
    const double f = fraction(v);

    return f < 1.0 ? f : 0.0;
}

/* A whole v is the lower edge, and not the upper one of the next copy. Each kind has a copy of its own. */
SIMD_INLINE parts find(const image_map *map, const kind *k, image_place at)
{
    const int64_t width = map->image->width, height = map->image->height;
    const double x = repeated(at.u) * (double)width, y = (1.0 - repeated(at.v)) * (double)height;
    parts out = { { 0.0 } };
    double part[PARTS];
    taps t;

    if (map->interpolation == IMAGE_PIXELS) {
        k->get(map, bound((int64_t)x, width, true), bound((int64_t)y, height, true), out.of);
        return out;
    }
    find_taps(map->interpolation, x - 0.5, y - 0.5, &t);
    for (int j = 0; j < t.count; j++)
        for (int i = 0; i < t.count; i++) {
            k->get(map, bound(t.column + i, width, map->once), bound(t.row + j, height, map->once), part);
            for (int c = 0; c < k->count; c++)
                out.of[c] += t.weight[j][i] * part[c];
        }
    return out;
}

/* ---- values ---- */

pigment image_colour(const image_map *map, image_place at)
{
    static const kind colours = { PARTS, get_colour };
    static const pigment nothing = { { 1.0f, 1.0f, 1.0f }, 0.0f, 1.0f };
    pigment out;
    parts p;

    if (at.is_outside)
        return nothing;
    p = find(map, &colours, at);
    out.color = colour_of((float)p.of[0], (float)p.of[1], (float)p.of[2]);
    out.filter = (float)p.of[3];
    out.transmit = (float)p.of[4];
    return out;
}

double image_grey(const image_map *map, image_place at)
{
    static const kind greys = { 1, get_grey };

    return find(map, &greys, at).of[0];
}

/* Red in bytes, whatever the file's numbers are; it is interpolated first, as in POV-Ray. */
double image_index(const image_map *map, image_place at)
{
    static const kind indices = { 1, get_index };
    const double found = find(map, &indices, at).of[0];

    return map->palette ? found : floor(255.0f * (float)found);
}

static float largest_sample(const image_map *map)
{
    const image *of = map->image;
    float most = 1.0f;

    for (uint32_t y = 0; of->bits == 32 && y < of->height; y++)
        for (uint32_t i = 0; i < of->width * of->channels; i++) {
            const float v = sample(map, of->samples + y * of->stride, i);

            most = v > most ? v : most;
        }
    return most;
}

/* Bicubic interpolation may give an eighth more in each direction. */
pigment image_most(const image_map *map)
{
    const float over = map->interpolation == IMAGE_BICUBIC ? 1.5f : 1.0f, most_colour = largest_sample(map) * over;
    pigment most = { { most_colour, most_colour, most_colour }, map->filter, map->transmit };

    if (map->image->colours == 0 && map->image->has_alpha)
        most.transmit += 1.0f;
    for (uint32_t i = 0; map->palette && i < map->image->colours; i++) {
        most.filter = map->palette[i].filter > most.filter ? map->palette[i].filter : most.filter;
        most.transmit = map->palette[i].transmit > most.transmit ? map->palette[i].transmit : most.transmit;
    }
    most.filter *= over;
    most.transmit = map->once && !(most.transmit * over > 1.0f) ? 1.0f : most.transmit * over;
    return most;
}
