#include "povray.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool povray_is_animation(const povray *p) { return p->last_frame > p->first_frame; }

/* ---- frames ---- */

/* A frame by its number, or by the fraction of the animation before it. */
static int frame_of(const povray *p, const char *text, int otherwise)
{
    const double value = strtod(text, NULL);

    if (!text[0])
        return otherwise;
    if (strchr(text, '.') && value <= 1.0)
        return p->first_frame + (int)floor(value * (p->last_frame - p->first_frame) + 0.5);
    return (int)value;
}

void povray_frames(const povray *p, int *first, int *last)
{
    *first = *last = 0;
    if (!povray_is_animation(p))
        return;
    *first = frame_of(p, p->subset_start, p->first_frame);
    *last = frame_of(p, p->subset_end, p->last_frame);
    *first = *first < p->first_frame ? p->first_frame : *first;
    *last = *last > p->last_frame ? p->last_frame : *last;
}

double povray_clock(const povray *p, int frame)
{
    const int steps = p->last_frame - p->first_frame + (p->cyclic ? 1 : 0);

    if (!povray_is_animation(p))
        return p->has_clock ? p->clock : 0.0;
    return p->first_clock + (p->last_clock - p->first_clock) * (frame - p->first_frame) / steps;
}

/* ---- the output ---- */

const char *povray_ending(const povray *p)
{
    static const struct { char type; const char *ending; } types[] = {
        { 'P', "ppm" }, { 'E', "exr" }, { 'J', "jpg" }, { 'T', "tga" }, { 'C', "tga" }, { 'H', "hdr" }, { 'B', "bmp" },
    };

    for (size_t i = 0; i < sizeof types / sizeof types[0]; i++)
        if (types[i].type == p->type)
            return types[i].ending;
    return "png";
}

static int digits_of(int n)
{
    int digits = 1;

    while (n >= 10) {
        n /= 10;
        digits++;
    }
    return digits;
}

/* The input's name without folder and ending. */
static void stem_of(const char *path, char *out, size_t size)
{
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path, *dot = strrchr(name, '.');

    snprintf(out, size, "%.*s", dot && dot != name ? (int)(dot - name) : (int)strlen(name), name);
}

static bool ends_in(const char *name, const char *ending)
{
    const size_t n = strlen(name), m = strlen(ending);

    return n > m + 1 && name[n - m - 1] == '.' && strcmp(name + n - m, ending) == 0;
}

/* POV-Ray accepts a folder, a name with or without the ending, or nothing; frame numbers come before the ending. */
bool povray_output(const povray *p, int frame, char *out, size_t size)
{
    const char *given = p->output, *slash = strrchr(given, '/'), *name = slash ? slash + 1 : given;
    char stem[POVRAY_TEXT], number[16] = "";
    const int folder = (int)(name - given);
    int n;

    if (strcmp(given, "-") == 0 || strcmp(given, "stdout") == 0)
        return snprintf(out, size, "-") < (int)size;
    if (name[0] == '\0')
        stem_of(strcmp(p->input, "-") == 0 ? "stdin" : p->input, stem, sizeof stem);
    else if (ends_in(name, povray_ending(p)))
        stem_of(name, stem, sizeof stem);
    else
        snprintf(stem, sizeof stem, "%s", name);
    if (povray_is_animation(p))
        snprintf(number, sizeof number, "%0*d", digits_of(p->last_frame), frame);
    n = snprintf(out, size, "%.*s%s%s.%s", folder, given, stem, number, povray_ending(p));
    return n >= 0 && (size_t)n < size;
}

/* ---- a part of the picture ---- */

/* The first pixel of a part, counted from 0, or the one behind it. An end at 1 is that of the picture, not of pixel 1. */
static int edge_of(double at, int size, bool end)
{
    if (end && at == 1.0)
        return size;
    if (at > 0.0 && at < 1.0)
        return (int)floor(at * size + (end ? 0.5 : 0.0));
    return end ? (int)at : (int)at - 1;
}

bool povray_crop(const povray *p, pov_rect *out)
{
    const bool columns = p->start_column > 0.0 || p->end_column > 0.0, rows = p->start_row > 0.0 || p->end_row > 0.0;
    const int left = p->start_column > 0.0 ? edge_of(p->start_column, p->width, false) : 0;
    const int right = p->end_column > 0.0 ? edge_of(p->end_column, p->width, true) : p->width;
    const int top = p->start_row > 0.0 ? edge_of(p->start_row, p->height, false) : 0;
    const int bottom = p->end_row > 0.0 ? edge_of(p->end_row, p->height, true) : p->height;
    const pov_rect part = { left, top, right - left, bottom - top };

    memset(out, 0, sizeof *out);
    if (!columns && !rows)
        return true;
    *out = part;
    return left >= 0 && top >= 0 && right <= p->width && bottom <= p->height && part.width > 0 && part.height > 0;
}
