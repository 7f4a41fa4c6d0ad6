#include "cells.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_VALUES = 3 };

/* Six characters and a margin fit across a pixel at this part of its width; less than so many units cannot be read. */
static const double FONT_PART = 0.25, LEAST_FONT = 9.0, LINE_PART = 0.29;

typedef struct sheet {
    const app *app;
    pov_rect seen;
    int count;                   /* values of a pixel */
    const float *values;
    session *session;
} sheet;

void cells_write(double value, char *out, size_t size)
{
    const double v = fabs(value);
    const int room = value >= 0.0;
    int digits = v < 0.01 ? 3 + room : v < 9.9995 ? 3 : v < 99.995 ? 2 : v < 999.95 ? 1 : 0, exponent = 0;

    if (!(v < HUGE_VAL)) {
        snprintf(out, size, isnan(value) ? "nan" : value < 0.0 ? "-inf" : "inf");
    } else if (v == floor(v) && v < 99999.5) {
        snprintf(out, size, "%.0f", value == 0.0 ? 0.0 : value);
    } else if (v >= 0.0005 && v < 9999.5) {
        snprintf(out, size, "%.*f", digits, value);
    } else {
        exponent = (int)floor(log10(v));
        /* The mantissa must not be rounded to ten. */
        exponent += v / pow(10.0, exponent) >= (room ? 9.95 : 9.5);
        snprintf(out, size, "%.*fe%d", room, value / pow(10.0, exponent), exponent);
    }
}

bool cells_seen(const app *a, pov_rect *out)
{
    double right, bottom;

    if (!zoom_is_on(&a->zoom) || FONT_PART * a->zoom.factor < LEAST_FONT * a->scale)
        return false;
    zoom_to_picture(&a->zoom, a->width, a->height, &right, &bottom);
    out->x = (int)a->zoom.left;
    out->y = (int)a->zoom.top;
    out->width = (int)ceil(right) - out->x;
    out->height = (int)ceil(bottom) - out->y;
    return true;
}

/* Black on what is light, white on what is dark. */
static double ink_on(const uint8_t *pixel)
{
    return 0.30 * pixel[0] + 0.59 * pixel[1] + 0.11 * pixel[2] > 128.0 ? 0.0 : 1.0;
}

static const uint8_t *pixel_of(const sheet *s, int i)
{
    return session_seen_pixel(s->session, s->seen.x + i % s->seen.width, s->seen.y + i / s->seen.width);
}

static void draw_cell(cairo_t *c, const sheet *s, int i)
{
    const double size = s->app->zoom.factor, line = LINE_PART * size, ink = ink_on(pixel_of(s, i));
    double x, y;
    char text[16];

    zoom_to_window(&s->app->zoom, s->seen.x + i % s->seen.width, (double)s->seen.y + i / s->seen.width, &x, &y);
    y += 0.5 * (size - s->count * line) + 0.78 * line;
    cairo_set_source_rgb(c, ink, ink, ink);
    for (int k = 0; k < s->count; k++) {
        cairo_text_extents_t e;

        cells_write((double)s->values[MOST_VALUES * i + k], text, sizeof text);
        cairo_text_extents(c, text, &e);
        cairo_move_to(c, x + 0.5 * (size - e.x_advance), y + k * line);
        cairo_show_text(c, text);
    }
}

static void draw(cairo_t *c, const void *user)
{
    const sheet *s = user;

    cairo_select_font_face(c, "monospace", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(c, FONT_PART * s->app->zoom.factor);
    for (int i = 0; i < s->seen.width * s->seen.height; i++)
        if (!isnan(s->values[MOST_VALUES * i]))
            draw_cell(c, s, i);
}

/* FNV-1a. */
static uint64_t hash(uint64_t so_far, const void *bytes, size_t count)
{
    const uint8_t *b = bytes;

    for (size_t i = 0; i < count; i++)
        so_far = (so_far ^ b[i]) * 0x100000001b3u;
    return so_far;
}

/* Everything that is seen of the sheet, as one number. */
static uint64_t digest(const sheet *s)
{
    const size_t cells = (size_t)s->seen.width * (size_t)s->seen.height;
    uint64_t sum = hash(0xcbf29ce484222325u, s->values, MOST_VALUES * cells * sizeof *s->values);

    for (size_t i = 0; i < cells; i++) {
        const uint8_t dark = ink_on(pixel_of(s, (int)i)) > 0.5;

        sum = hash(sum, &dark, 1);
    }
    return sum;
}

static bool draw_sheet(panel *p, sheet *s)
{
    const app *a = s->app;
    char name[120];

    snprintf(name, sizeof name, "%016llx %d %.17g %.17g %d", (unsigned long long)digest(s), a->zoom.factor, a->zoom.left,
             a->zoom.top, a->height);
    return panel_set_sheet(p, name, a->width, a->height, draw, s);
}

bool cells_set(panel *p, const app *a, session *from)
{
    sheet s = { a, { 0, 0, 0, 0 }, 0, NULL, from };
    float *values;
    int width, height;
    bool changed;
    /* A picture of the old size is stretched to the new one for a moment, and has no numbers. */
    if (!cells_seen(a, &s.seen) || !session_pixels(from, &width, &height) || width != a->width || height != a->height)
        return panel_set_sheet(p, "", 1, 1, draw, NULL);
    values = malloc(MOST_VALUES * sizeof *values * (size_t)s.seen.width * (size_t)s.seen.height);
    if (!values)
        return panel_set_sheet(p, "", 1, 1, draw, NULL);
    s.values = values;
    s.count = session_values(from, s.seen, values);
    changed = draw_sheet(p, &s);
    free(values);
    return changed;
}
