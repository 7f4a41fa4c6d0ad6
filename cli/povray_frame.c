#include "povray.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Within what an int holds. */
static int whole(double value)
{
    return !(value < 1e9) ? 1000000000 : value > -1e9 ? (int)value : -1000000000;
}

/* ---- frames ---- */

/* A frame by its number, or by the part of the animation that it ends, as POV-Ray counts it from 1. */
static int frame_of(const char *text, const frames *f, int otherwise)
{
    const double value = strtod(text, NULL);
    int frame;

    if (!text[0])
        return otherwise;
    frame = value > 0.0 && value < 1.0 ? f->first - 1 + (int)floor(value * (f->last - f->first + 1)) : whole(value);
    return frame < f->first ? f->first : frame;
}

/* Frames from 0 to 0 and from 1 to 1 are no animation, as in POV-Ray; what is not given counts as 0 here. */
static bool is_animation(const povray *p)
{
    const int first = p->first_frame == POVRAY_NO_FRAME ? 0 : p->first_frame;
    const int last = p->last_frame == POVRAY_NO_FRAME ? 0 : p->last_frame;

    return first != last || (first != 0 && first != 1);
}

frames povray_frames(const povray *p)
{
    const bool asked = is_animation(p);
    frames f = { .asked = asked, .first = 1, .last = 1, .cyclic = p->cyclic, .first_clock = p->first_clock,
                 .last_clock = p->last_clock };

    if (p->first_frame != POVRAY_NO_FRAME)
        f.first = p->first_frame < 0 ? 0 : p->first_frame;
    if (p->last_frame != POVRAY_NO_FRAME)
        f.last = p->last_frame;
    f.last = f.last < f.first ? f.first : f.last;
    f.from = frame_of(p->subset_start, &f, f.first);
    f.to = frame_of(p->subset_end, &f, f.last);
    f.step = p->frame_step < 1 ? 1 : p->frame_step;
    return f;
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

/* POV-Ray accepts a folder, a name with or without the ending, or nothing: then the picture goes beside the scene. */
bool povray_output(const povray *p, char *out, size_t size)
{
    const bool is_piped = strcmp(p->input, "-") == 0;
    const char *given = p->output[0] || is_piped ? p->output : p->input, *slash = strrchr(given, '/');
    const char *name = slash ? slash + 1 : given;
    char stem[POVRAY_TEXT];
    int n;

    if (strcmp(given, "-") == 0 || strcmp(given, "stdout") == 0)
        return snprintf(out, size, "-") < (int)size;
    if (!p->output[0] || name[0] == '\0')
        stem_of(is_piped ? "stdin" : p->input, stem, sizeof stem);
    else if (ends_in(name, povray_ending(p)))
        stem_of(name, stem, sizeof stem);
    else
        snprintf(stem, sizeof stem, "%s", name);
    n = snprintf(out, size, "%.*s%s.%s", (int)(name - given), given, stem, povray_ending(p));
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
    return end ? whole(at) : whole(at) - 1;
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
