#include "picture.h"

#include "bar.h"
#include "ramp.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* Tile corners are multiples of this; rows are read again in blocks of as many. */
enum { CELL = 8, STRIP = 32, PART = 32 };

static double clock_seconds(void)
{
    struct timespec t;

    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static size_t cells(int length)
{
    return (size_t)((length + CELL - 1) / CELL);
}

static void stretch(const picture *from, uint8_t *to, int width, int height)
{
    for (int y = 0; y < height; y++) {
        const uint8_t *row = from->pixels + (size_t)((long long)y * from->height / height) * (size_t)from->width * 4;

        for (int x = 0; x < width; x++, to += 4)
            memcpy(to, row + (size_t)((long long)x * from->width / width) * 4, 4);
    }
}

bool picture_resize(picture *p, int width, int height)
{
    uint8_t *pixels = calloc((size_t)width * (size_t)height, 4);
    unsigned *seen = calloc(cells(width) * cells(height), sizeof *seen);
    uint8_t *outside = calloc((size_t)width * (size_t)height, 1);

    if (!pixels || !seen || !outside) {
        free(outside);
        free(pixels);
        free(seen);
        return false;
    }
    p->first = height;
    p->last = -1;
    if (p->pixels) {
        stretch(p, pixels, width, height);
        picture_touch(p, 0, height - 1);
    }
    free(p->pixels);
    free(p->seen);
    free(p->outside);
    p->outside = outside;
    memset(p->clipped, 0, sizeof p->clipped);
    p->pixels = pixels;
    p->seen = seen;
    p->width = width;
    p->height = p->reread = height;
    p->restart = 0;
    picture_restart(p);
    return true;
}

void picture_free(picture *p)
{
    free(p->pixels);
    free(p->seen);
    free(p->outside);
    memset(p, 0, sizeof *p);
}

void picture_restart(picture *p)
{
    p->restart++;
    p->covered = 0;
    p->reread = p->height;
}

void picture_expose(picture *p, pov_transfer transfer, double gain)
{
    p->toned = gain != 1.0;
    if (p->toned)
        tone_init(&p->tone, transfer, gain);
    picture_reread(p);
}

void picture_show(picture *p, picture_kind kind)
{
    p->kind = kind;
    picture_reread(p);
}

void picture_mark(picture *p, bool marked)
{
    if (p->outside)
        memset(p->outside, PICTURE_INSIDE, (size_t)p->width * (size_t)p->height);
    memset(p->clipped, 0, sizeof p->clipped);
    p->marked = marked;
    picture_reread(p);
}

void picture_reread(picture *p)
{
    p->reread = 0;
}

void picture_touch(picture *p, int first, int last)
{
    p->first = first < p->first ? first : p->first;
    p->last = last > p->last ? last : p->last;
}

bool picture_is_covered(const picture *p)
{
    return p->covered == (size_t)p->width * (size_t)p->height;
}

/* Tiles not traced yet read as empty, and the old pixels in their place stay. */
static void keep_what_is_there(uint8_t *to, const uint8_t *fresh, int count)
{
    for (int i = 0; i < count; i++)
        if (fresh[4 * i + 3])
            memcpy(to + 4 * i, fresh + 4 * i, 4);
}

/* Position of a value between dark and bright; unknown values are below. */
static double brightness(picture_kind kind, float value)
{
    double t;

    if (!(value > 0.0f))
        return value == 0.0f ? 0.0 : -1.0;
    switch (kind) {
    case PICTURE_ERROR: case PICTURE_DIFFERENCE: t = bar_share(&bar_error, (double)value); break;
    case PICTURE_TIME: t = bar_share(&bar_seconds, (double)value); break;
    default: t = bar_share(&bar_samples, (double)value); break;
    }
    return t > 0.0 ? t : 0.0;
}

static void read_map(picture *p, pov_job *job, pov_rect r, uint8_t *fresh)
{
    static const pov_pixels maps[] = { POV_PIXELS_DISPLAY8, POV_PIXELS_SAMPLES, POV_PIXELS_TIME, POV_PIXELS_ERROR };
    float values[PART * PART];

    pov_job_read(job, r, maps[p->kind], values, (size_t)r.width * sizeof *values);
    for (int i = 0; i < r.width * r.height; i++)
        ramp_color(brightness(p->kind, values[i]), fresh + 4 * i);
}

/* Differences of colours that are not there yet are none. */
static void read_difference(picture *p, pov_job *job, pov_rect r, uint8_t *fresh)
{
    float linear[4 * PART * PART], d[3];

    pov_job_read(job, r, POV_PIXELS_LINEAR_FLOAT, linear, 4 * (size_t)r.width * sizeof *linear);
    for (int i = 0; i < r.width * r.height; i++) {
        const float *color = linear + 4 * i;

        reference_difference(p->reference, r.x + i % r.width, r.y + i / r.width, color, d);
        ramp_color(brightness(PICTURE_DIFFERENCE, reference_distance(d)), fresh + 4 * i);
        fresh[4 * i + 3] = color[3] > 0.0f ? 255 : 0;
    }
}

static picture_clipped clipped_as(const float *color, float gain)
{
    if (color[0] * gain > 1.0f || color[1] * gain > 1.0f || color[2] * gain > 1.0f)
        return PICTURE_ABOVE;
    return color[0] < 0.0f || color[1] < 0.0f || color[2] < 0.0f ? PICTURE_BELOW : PICTURE_INSIDE;
}

/* Colour what the display cannot show, and keep count of it. */
static void mark_clipped(picture *p, pov_rect r, const float *linear, uint8_t *fresh)
{
    static const uint8_t marks[][4] = { { 0, 0, 0, 0 }, { 255, 0, 255, 255 }, { 0, 255, 255, 255 } };
    const float gain = p->toned ? p->tone.gain : 1.0f;

    for (int i = 0; i < r.width * r.height; i++) {
        const size_t at = (size_t)(r.y + i / r.width) * (size_t)p->width + (size_t)(r.x + i % r.width);
        const picture_clipped now = clipped_as(linear + 4 * i, gain);

        if (!(linear[4 * i + 3] > 0.0f))
            continue;
        p->clipped[p->outside[at]]--;
        p->clipped[now]++;
        p->outside[at] = (uint8_t)now;
        if (now != PICTURE_INSIDE)
            memcpy(fresh + 4 * i, marks[now], 4);
    }
}

/* A rectangle no wider or higher than PART. */
static void read_part(picture *p, pov_job *job, pov_rect r)
{
    float linear[4 * PART * PART];
    uint8_t fresh[4 * PART * PART];
    size_t width = (size_t)r.width;

    /* For a moment the picture may have another size than the reference. */
    if (p->kind == PICTURE_DIFFERENCE && reference_fits(p->reference, p->width, p->height)) {
        read_difference(p, job, r, fresh);
    } else if (p->kind == PICTURE_SAMPLES || p->kind == PICTURE_TIME || p->kind == PICTURE_ERROR) {
        read_map(p, job, r, fresh);
    } else if (p->toned) {
        pov_job_read(job, r, POV_PIXELS_LINEAR_FLOAT, linear, 4 * width * sizeof *linear);
        tone_row(&p->tone, linear, fresh, r.width * r.height);
    } else {
        pov_job_read(job, r, POV_PIXELS_DISPLAY8, fresh, 4 * width);
    }
    if (p->marked && p->kind == PICTURE_COLORS) {
        pov_job_read(job, r, POV_PIXELS_LINEAR_FLOAT, linear, 4 * width * sizeof *linear);
        mark_clipped(p, r, linear, fresh);
    }
    for (int y = 0; y < r.height; y++)
        keep_what_is_there(p->pixels + ((size_t)(r.y + y) * (size_t)p->width + (size_t)r.x) * 4,
                           fresh + 4 * width * (size_t)y, r.width);
}

static void read_rows(picture *p, pov_job *job, pov_rect r)
{
    for (int y = 0; y < r.height; y += PART)
        for (int x = 0; x < r.width; x += PART) {
            pov_rect part = { r.x + x, r.y + y, r.width - x, r.height - y };

            part.width = part.width < PART ? part.width : PART;
            part.height = part.height < PART ? part.height : PART;
            read_part(p, job, part);
        }
    picture_touch(p, r.y, r.y + r.height - 1);
}

static void note_seen(picture *p, pov_rect tile)
{
    unsigned *seen = &p->seen[(size_t)(tile.y / CELL) * cells(p->width) + (size_t)(tile.x / CELL)];

    if (*seen == p->restart)
        return;
    *seen = p->restart;
    p->covered += (size_t)tile.width * (size_t)tile.height;
}

bool picture_update(picture *p, pov_job *job, double seconds)
{
    double end = clock_seconds() + seconds;
    pov_rect tile;

    while (p->reread < p->height) {
        pov_rect strip = { 0, p->reread, p->width, STRIP };

        strip.height = p->height - strip.y < STRIP ? p->height - strip.y : STRIP;
        read_rows(p, job, strip);
        p->reread += strip.height;
        if (clock_seconds() >= end)
            return true;
    }
    while (pov_job_take(job, &tile)) {
        read_rows(p, job, tile);
        note_seen(p, tile);
        if (clock_seconds() >= end)
            return true;
    }
    return false;
}
