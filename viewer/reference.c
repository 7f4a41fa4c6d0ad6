#include "reference.h"

#include <povtrace/scene.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { STRIP = 16 };

static double clock_seconds(void)
{
    struct timespec t;

    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

pov_status reference_fill_size(args *a, pov_error *err)
{
    pov_bitmap image = { sizeof image, 0, 0, 0, NULL };
    pov_context_desc c = POV_INIT(c);
    pov_context *context;
    pov_status status;

    if (!a->reference || a->width > 0)
        return POV_OK;
    c.plugin_path = a->plugin_path;
    status = pov_context_create(&context, &c, err);
    if (status < 0)
        return status;
    status = pov_image_read(context, a->reference, &image, err);
    if (status == POV_OK) {
        a->width = image.width;
        a->height = image.height;
        pov_image_free(context, &image);
    }
    pov_context_destroy(context);
    return status;
}

pov_status reference_read(reference *r, pov_context *context, const args *a, pov_error *err)
{
    pov_status status;

    if (!a->reference)
        return POV_OK;
    r->image = (pov_bitmap){ sizeof r->image, 0, 0, 0, NULL };
    status = pov_image_read(context, a->reference, &r->image, err);
    if (status < 0)
        return status;
    if (reference_fit(r, r->image.width, r->image.height)) {
        reference_expose(r, POV_TRANSFER_SRGB, 1.0);
        return POV_OK;
    }
    reference_free(r, context);
    err->status = POV_E_MEMORY;
    snprintf(err->message, sizeof err->message, "no memory for the reference");
    return err->status;
}

void reference_free(reference *r, pov_context *context)
{
    if (r->image.rgba)
        pov_image_free(context, &r->image);
    free(r->scaled);
    free(r->bytes);
    memset(r, 0, sizeof *r);
}

/* ---- another size ---- */

/* One row or column: the mean of `size` values, `step` floats apart, on the i-th of `parts` equal parts of them. */
static void mean_of(const float *from, size_t step, int size, int i, int parts, float *out)
{
    const double begin = (double)i * size / parts, end = (double)(i + 1) * size / parts;
    double sum[4] = { 0.0, 0.0, 0.0, 0.0 };

    for (int k = (int)begin; k < size && k < end; k++) {
        const double share = fmin(k + 1.0, end) - fmax((double)k, begin);

        for (int c = 0; c < 4; c++)
            sum[c] += share * (double)from[(size_t)k * step + (size_t)c];
    }
    for (int c = 0; c < 4; c++)
        out[c] = (float)(sum[c] / (end - begin));
}

/* Rows first, then columns. */
static bool scale(const pov_bitmap *from, float *to, int width, int height)
{
    const size_t wide = 4 * (size_t)width;
    float *rows = malloc((size_t)from->height * wide * sizeof *rows);

    if (!rows)
        return false;
    for (int y = 0; y < from->height; y++)
        for (int x = 0; x < width; x++)
            mean_of(from->rgba + 4 * (size_t)y * (size_t)from->width, 4, from->width, x, width, rows + (size_t)y * wide + 4 * (size_t)x);
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++)
            mean_of(rows + 4 * (size_t)x, wide, from->height, y, height, to + (size_t)y * wide + 4 * (size_t)x);
    free(rows);
    return true;
}

bool reference_fit(reference *r, int width, int height)
{
    const bool is_own = width == r->image.width && height == r->image.height;
    float *scaled = NULL;
    uint8_t *bytes;

    if (!r->image.rgba || reference_fits(r, width, height))
        return true;
    bytes = calloc((size_t)width * (size_t)height, 4);
    if (bytes && !is_own)
        scaled = malloc((size_t)width * (size_t)height * 4 * sizeof *scaled);
    if (!bytes || (!is_own && (!scaled || !scale(&r->image, scaled, width, height)))) {
        free(bytes);
        free(scaled);
        return false;
    }
    free(r->bytes);
    free(r->scaled);
    r->bytes = bytes;
    r->scaled = scaled;
    r->rgba = is_own ? r->image.rgba : scaled;
    r->width = width;
    r->height = height;
    r->encoded = 0;
    r->first = height;
    r->last = -1;
    return true;
}

bool reference_fits(const reference *r, int width, int height)
{
    return r->rgba && r->width == width && r->height == height;
}

void reference_expose(reference *r, pov_transfer transfer, double gain)
{
    r->transfer = transfer;
    r->exact = gain == 1.0;
    if (!r->exact)
        tone_init(&r->tone, transfer, gain);
    r->encoded = 0;
    r->first = r->height;
    r->last = -1;
}

/* What is transparent in the file is shown before black, and everything of it is there. */
static void encode_row(reference *r, int y)
{
    const float *from = reference_color(r, 0, y);
    uint8_t *to = r->bytes + 4 * (size_t)y * (size_t)r->width;

    for (int x = 0; x < r->width; x++, from += 4, to += 4) {
        const float solid[4] = { from[0], from[1], from[2], 1.0f };

        if (r->exact)
            tone_exact(r->transfer, solid, to);
        else
            tone_row(&r->tone, solid, to, 1);
    }
}

bool reference_update(reference *r, double seconds)
{
    const double end = clock_seconds() + seconds;

    if (!r->image.rgba)
        return false;
    while (r->encoded < r->height) {
        encode_row(r, r->encoded);
        r->first = r->encoded < r->first ? r->encoded : r->first;
        r->last = r->encoded++;
        if (r->encoded % STRIP == 0 && clock_seconds() >= end)
            break;
    }
    return r->encoded < r->height;
}

bool reference_take_rows(reference *r, int *first, int *last)
{
    if (!r->image.rgba || r->last < r->first)
        return false;
    *first = r->first;
    *last = r->last;
    r->first = r->height;
    r->last = -1;
    return true;
}

const float *reference_color(const reference *r, int x, int y)
{
    return r->rgba + 4 * ((size_t)y * (size_t)r->width + (size_t)x);
}

static float within(float v)
{
    return v > 0.0f ? v < 1.0f ? v : 1.0f : 0.0f;
}

void reference_difference(const reference *r, int x, int y, const float *color, float *out)
{
    const bool is_float = r->image.bits >= 32;
    const float *wanted = reference_color(r, x, y);

    for (int c = 0; c < 3; c++)
        out[c] = (is_float ? color[c] : within(color[c])) - wanted[c];
}

float reference_distance(const float *d)
{
    return fmaxf(fabsf(d[0]), fmaxf(fabsf(d[1]), fabsf(d[2])));
}
