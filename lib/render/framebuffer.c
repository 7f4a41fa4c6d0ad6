#include "render/framebuffer.h"

#include "base/pages.h"
#include "base/simd.h"
#include "base/srgb.h"

#include <string.h>

bool framebuffer_make(framebuffer *f, const env *e, const tiles *t, int first_step)
{
    size_t width = (size_t)t->width, height = (size_t)t->height;

    memset(f, 0, sizeof *f);
    f->tiles = t;
    f->first_step = first_step;
    for (f->passes = 1; first_step > 1; first_step /= 2)
        f->passes++;
    if (height <= SIZE_MAX / 16 / width)
        f->pixels = pages_reserve(e, width * height * 4 * sizeof(float));
    if (f->pixels)
        f->done = env_alloc(e, t->count, 1);
    return f->done != NULL;
}

void framebuffer_free(framebuffer *f, const env *e)
{
    env_free(e, f->done);
    pages_free(e, f->pixels);
    f->done = NULL;
    f->pixels = NULL;
}

void framebuffer_clear(framebuffer *f)
{
    memset(f->done, 0, f->tiles->count);
}

lattice framebuffer_lattice(const framebuffer *f, int pass)
{
    lattice l = { f->first_step >> pass, pass > 0, f->again && pass + 1 == f->passes };

    return l;
}

static float *pixel(const framebuffer *f, int x, int y)
{
    return f->pixels + 4 * ((size_t)y * (size_t)f->tiles->width + (size_t)x);
}

/* Threads may end a coarse pass of a tile after its last one, which has drawn the same pixels. */
static bool is_outdone(const framebuffer *f, size_t tile, int pass)
{
    return f->again && pass + 1 < f->passes && (f->done[tile] >> (f->passes - 1) & 1);
}

void framebuffer_put(framebuffer *f, size_t tile, int pass, const float *pixels)
{
    pov_rect r = tiles_rect(f->tiles, tile);
    lattice l = framebuffer_lattice(f, pass);

    f->done[tile] |= (uint8_t)(1u << pass);
    if (is_outdone(f, tile, pass))
        return;
    if (l.step == 1 && (!l.finer || l.again))
        framebuffer_replace(f, tile, pixels);
    else
        for (int y = 0; y < r.height; y += l.step)
            for (int x = 0; x < r.width; x += l.step)
                if (lattice_has(l, x, y))
                    memcpy(pixel(f, r.x + x, r.y + y), pixels + 4 * (y * r.width + x), 4 * sizeof *pixels);
}

void framebuffer_touch(const framebuffer *f, size_t part, size_t parts)
{
    pages_prefetch(f->pixels, 4 * sizeof *f->pixels * (size_t)f->tiles->width * (size_t)f->tiles->height, part, parts);
}

void framebuffer_prefetch(const framebuffer *f, pov_rect part)
{
    for (int y = 0; y < part.height; y++) {
        const float *row = pixel(f, part.x, part.y + y);

        for (int i = 0; i < 4 * part.width; i += 16)
            SIMD_PREFETCH(row + i);
    }
}

void framebuffer_replace(framebuffer *f, size_t tile, const float *pixels)
{
    pov_rect r = tiles_rect(f->tiles, tile);

    for (int y = 0; y < r.height; y++)
        memcpy(pixel(f, r.x, r.y + y), pixels + 4 * y * r.width, 4 * sizeof *pixels * (size_t)r.width);
}

bool framebuffer_has(const framebuffer *f, size_t tile)
{
    return f->done[tile] == (1u << f->passes) - 1u;
}

const float *framebuffer_pixels(const framebuffer *f, int x, int y)
{
    return pixel(f, x, y);
}

/* The step of the finest lattice all of whose passes are in; 0: none. */
static int whole_step(const framebuffer *f, size_t tile)
{
    int step = 0;

    for (int pass = 0; pass < f->passes && (f->done[tile] >> pass & 1u); pass++)
        step = f->first_step >> pass;
    return step;
}

int framebuffer_row(const framebuffer *f, size_t tile, int x, int y, int width, float *out)
{
    pov_rect r = tiles_rect(f->tiles, tile);
    int step = whole_step(f, tile);

    if (step == 0) {
        memset(out, 0, 4 * sizeof *out);
        return f->tiles->edge;
    }
    if (step == 1) {
        memcpy(out, pixel(f, x, y), 4 * sizeof *out * (size_t)width);
        return step;
    }
    y -= (y - r.y) % step;
    for (int at = x - (x - r.x) % step; at < x + width; at += step, out += 4)
        memcpy(out, pixel(f, at, y), 4 * sizeof *out);
    return step;
}

void encoding_make(encoding *e, const gamma *g)
{
    e->decode = g->decode;
    e->decodes_srgb = g->decodes_srgb;
    encoder_init(&e->display, 8, g->transfer, 0.0);
}

enum { SOME_PIXELS = 16 };

/* Linear light is value ^ power; negative values keep their sign. */
SIMD_CLONES static void decode_powers(double power, double *values, int count)
{
    for (int i = 0; i < count; i++) {
        const double linear = elementary_pow(fabs(values[i]), power);

        values[i] = values[i] < 0.0 ? -linear : linear;
    }
}

static void decode_values(const encoding *e, double *values, int count)
{
    if (!e->decodes_srgb) {
        decode_powers(e->decode, values, count);
        return;
    }
    for (int i = 0; i < count; i++)
        values[i] = values[i] < 0.0 ? -srgb_decode(-values[i]) : srgb_decode(values[i]);
}

static float share_of(const float *pixel) { return pixel[3] > 0.0f ? pixel[3] : 1.0f; }

static bool are_alike(const float *rgba, int count)
{
    return count > 1 && memcmp(rgba, rgba + 4, 4 * sizeof *rgba * (size_t)(count - 1)) == 0;
}

/* Colours are multiplied by alpha. */
static void decode_some(const encoding *e, float *rgba, int count)
{
    double values[3 * SOME_PIXELS];

    for (int i = 0; i < count; i++) {
        const float *from = rgba + 4 * i, share = share_of(from);

        values[3 * i] = (double)(from[0] / share);
        values[3 * i + 1] = (double)(from[1] / share);
        values[3 * i + 2] = (double)(from[2] / share);
    }
    decode_values(e, values, 3 * count);
    for (int i = 0; i < count; i++) {
        float *to = rgba + 4 * i;
        const float share = share_of(to);

        to[0] = share * (float)values[3 * i];
        to[1] = share * (float)values[3 * i + 1];
        to[2] = share * (float)values[3 * i + 2];
    }
}

/* A plain background is decoded once. */
static void decode_alike(const encoding *e, float *rgba, int count)
{
    decode_some(e, rgba, 1);
    for (int i = 1; i < count; i++)
        memcpy(rgba + 4 * i, rgba, 4 * sizeof *rgba);
}

void encoding_linear(const encoding *e, float *rgba, int count)
{
    if (e->decode == 1.0)
        return;
    for (int i = 0; i < count; i += SOME_PIXELS) {
        const int some = count - i < SOME_PIXELS ? count - i : SOME_PIXELS;

        if (are_alike(rgba + 4 * i, some))
            decode_alike(e, rgba + 4 * i, some);
        else
            decode_some(e, rgba + 4 * i, some);
    }
}

void encoding_display(const encoding *e, float *rgba, unsigned char *out, int count)
{
    encoding_linear(e, rgba, count);
    encoder_row(&e->display, rgba, count, 4, out);
    for (int i = 3; i < 4 * count; i += 4)
        out[i] = rgba[i] > 0.0f ? 255 : 0;
}
