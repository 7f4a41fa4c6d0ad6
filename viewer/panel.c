#include "panel.h"

#include "bar.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LINE_SIZE = 640 };

/* In units of the scale. */
static const double FONT_SIZE = 13.0, LINE_HEIGHT = 18.0, MARGIN = 12.0, GAP = 18.0, RADIUS = 6.0, BAR_WIDTH = 220.0;

/* Drawing passes over the text twice with the same steps: first to measure, then with a surface to draw on. */
typedef struct pen {
    cairo_t *c;
    bool drawing;
    double scale, most;          /* the widest a line may be */
    double column;               /* where second columns begin */
    double y, widest;
    char above[LINE_SIZE];       /* the line of a file that a caret belongs to, from the first shown byte */
    size_t skipped;
} pen;

/* ---- text ---- */

/* Bytes of the UTF-8 character at this position, 0 if there is none. */
static size_t character(const unsigned char *s)
{
    size_t bytes = s[0] < 0x80 ? 1 : s[0] >= 0xc2 && s[0] < 0xe0 ? 2 : (s[0] & 0xf0) == 0xe0 ? 3
                 : s[0] >= 0xf0 && s[0] < 0xf5 ? 4 : 0;

    for (size_t i = 1; i < bytes; i++)
        if ((s[i] & 0xc0) != 0x80)
            return 0;
    if ((s[0] == 0xe0 && s[1] < 0xa0) || (s[0] == 0xed && s[1] >= 0xa0) || (s[0] == 0xf0 && s[1] < 0x90) ||
        (s[0] == 0xf4 && s[1] >= 0x90))
        return 0;
    return bytes;
}

/* The text in a form that cairo accepts, with the same number of bytes: invalid ones become "?" and invisible ones
 * blanks. */
static void clean(char *text)
{
    unsigned char *s = (unsigned char *)text;

    while (*s) {
        size_t bytes = character(s);

        if (bytes == 0)
            *s = '?';
        else if (*s < 0x20 || *s == 0x7f)
            *s = ' ';
        s += bytes > 0 ? bytes : 1;
    }
}

static void choose(pen *p, bool plain, bool bold)
{
    cairo_select_font_face(p->c, plain ? "sans-serif" : "monospace", CAIRO_FONT_SLANT_NORMAL,
                           bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(p->c, FONT_SIZE * p->scale);
}

static double width_of(const pen *p, const char *text)
{
    cairo_text_extents_t e;

    cairo_text_extents(p->c, text, &e);
    return e.x_advance;
}

static void put(pen *p, double x, const char *text, double red, double green, double blue)
{
    double end = x + width_of(p, text);

    p->widest = end > p->widest ? end : p->widest;
    if (!p->drawing)
        return;
    cairo_set_source_rgb(p->c, red, green, blue);
    cairo_move_to(p->c, MARGIN * p->scale + x, MARGIN * p->scale + p->y + FONT_SIZE * p->scale);
    cairo_show_text(p->c, text);
}

static void next_line(pen *p)
{
    p->y += LINE_HEIGHT * p->scale;
}

/* ---- kinds of lines ---- */

static void title(pen *p, const char *text, bool warns)
{
    choose(p, true, true);
    if (warns)
        put(p, 0.0, text, 1.0, 0.62, 0.36);
    else
        put(p, 0.0, text, 1.0, 1.0, 1.0);
    next_line(p);
}

/* As many words as fit on each line, from this column on; a single word that is too long is not broken. */
static void words(pen *p, double x, const char *text)
{
    char line[LINE_SIZE];
    size_t used = 0;

    choose(p, true, false);
    while (*text) {
        size_t blank = strspn(text, " "), length = blank + strcspn(text + blank, " ");

        if (used + length >= sizeof line)
            length = sizeof line - 1 - used;
        memcpy(line + used, text, length);
        line[used + length] = '\0';
        if (used > 0 && (x + width_of(p, line) > p->most || length == 0)) {
            line[used] = '\0';
            put(p, x, line, 0.88, 0.88, 0.88);
            next_line(p);
            text += blank < length ? blank : length;
            used = 0;
            continue;
        }
        used += length;
        text += length;
    }
    line[used] = '\0';
    put(p, x, line, 0.88, 0.88, 0.88);
    next_line(p);
}

static void columns(pen *p, char *text)
{
    char *second = strchr(text, '\t');

    if (second)
        *second++ = '\0';
    clean(text);
    choose(p, true, true);
    if (!p->drawing) {
        double end = width_of(p, text) + GAP * p->scale;

        p->column = end > p->column ? end : p->column;
    }
    put(p, 0.0, text, 0.62, 0.80, 1.0);
    if (!second) {
        next_line(p);
        return;
    }
    clean(second);
    words(p, p->column, second);
}

/* One number below the bar, as close to its place as the bar's ends allow; a mark shows the place itself. */
static void tick(pen *p, double share, const char *text)
{
    const double width = BAR_WIDTH * p->scale, half = 0.5 * width_of(p, text), centre = share * width;
    const double left = fmin(fmax(centre - half, 0.0), width - 2.0 * half);

    if (p->drawing) {
        cairo_set_source_rgb(p->c, 0.88, 0.88, 0.88);
        cairo_rectangle(p->c, MARGIN * p->scale + fmin(centre, width - p->scale),
                        MARGIN * p->scale + p->y - 3.0 * p->scale, p->scale, 4.0 * p->scale);
        cairo_fill(p->c);
    }
    put(p, fmax(left, 0.0), text, 0.88, 0.88, 0.88);
}

/* A bar of the kind that its first character names; each number follows its position, tabs between. Without numbers it
 * has those of the bar below it. */
static void bar(pen *p, char *text)
{
    const int kind = text[0], steps = (int)BAR_WIDTH;

    for (int i = 0; p->drawing && i < steps; i++) {
        uint8_t c[4];

        bar_color(kind, i / (BAR_WIDTH - 1.0), c);
        cairo_set_source_rgb(p->c, c[0] / 255.0, c[1] / 255.0, c[2] / 255.0);
        cairo_rectangle(p->c, MARGIN * p->scale + i * p->scale, MARGIN * p->scale + p->y + 4.0 * p->scale,
                        (i + 1 < steps ? 1.5 : 1.0) * p->scale, 10.0 * p->scale);
        cairo_fill(p->c);
    }
    p->widest = fmax(p->widest, BAR_WIDTH * p->scale);
    if (!text[1]) {
        p->y += 12.0 * p->scale;
        return;
    }
    next_line(p);
    choose(p, true, false);
    for (char *at = text + 1; at;) {
        char *end = strchr(at, '\t'), *number;
        double share = strtod(at, &number);

        if (end)
            *end++ = '\0';
        tick(p, share, number + strspn(number, " "));
        at = end;
    }
    next_line(p);
}

/* A square of a colour, six hexadecimal digits, and what it means. */
static void swatch(pen *p, const char *text)
{
    const unsigned long rgb = strtoul(text, NULL, 16);

    if (p->drawing) {
        cairo_set_source_rgb(p->c, (double)(rgb >> 16 & 255) / 255.0, (double)(rgb >> 8 & 255) / 255.0,
                             (double)(rgb & 255) / 255.0);
        cairo_rectangle(p->c, MARGIN * p->scale, MARGIN * p->scale + p->y + 4.0 * p->scale, 11.0 * p->scale, 11.0 * p->scale);
        cairo_fill(p->c);
    }
    choose(p, true, false);
    put(p, GAP * p->scale, text + strcspn(text, " ") + (strchr(text, ' ') != NULL), 0.88, 0.88, 0.88);
    next_line(p);
}

/* A line of a file; if it is too wide, the part around the caret, whose position the next line gives. */
static void excerpt(pen *p, const char *text, const char *below)
{
    size_t caret = below[0] == '^' ? (size_t)atoi(below + 1) : 0, length = strlen(text);

    choose(p, false, false);
    p->skipped = 0;
    snprintf(p->above, sizeof p->above, "%s", text);
    caret = caret < length ? caret : length;
    while (width_of(p, p->above) > p->most && p->skipped + 24 < caret) {
        size_t bytes = character((const unsigned char *)text + p->skipped);

        p->skipped += bytes > 0 ? bytes : 1;
        snprintf(p->above, sizeof p->above, "%s", text + p->skipped);
    }
    while (width_of(p, p->above) > p->most && p->above[0]) {
        size_t end = strlen(p->above) - 1;

        while (end > 0 && ((unsigned char)p->above[end] & 0xc0) == 0x80)
            end--;
        p->above[end] = '\0';
    }
    put(p, 0.0, p->above, 0.95, 0.95, 0.80);
    next_line(p);
}

static void caret(pen *p, const char *number)
{
    size_t bytes = (size_t)atoi(number);
    char before[LINE_SIZE];

    bytes = bytes > p->skipped ? bytes - p->skipped : 0;
    snprintf(before, sizeof before, "%.*s", (int)bytes, p->above);
    choose(p, false, true);
    /* Directly below its line. */
    p->y -= 3.0 * p->scale;
    put(p, width_of(p, before), "^", 0.55, 0.95, 0.55);
    next_line(p);
}

/* Pass over all lines once. */
static void write_all(pen *p, const char *content)
{
    char line[LINE_SIZE];

    p->y = 0.0;
    while (*content) {
        size_t length = strcspn(content, "\n");
        const char *next = content + length + (content[length] == '\n');

        snprintf(line, sizeof line, "%.*s", (int)length, content);
        if (line[0] != '|' && line[0] != '~')
            clean(line);
        switch (line[0]) {
        case '#': title(p, line + 1, false); break;
        case '!': title(p, line + 1, true); break;
        case '|': columns(p, line + 1); break;
        case '~': bar(p, line + 1); break;
        case '%': swatch(p, line + 1); break;
        case '=': excerpt(p, line + 1, next); break;
        case '^': caret(p, line + 1); break;
        default: words(p, 0.0, line + (line[0] == ' ')); break;
        }
        content = next;
    }
}

/* ---- the panel ---- */

static void ground(cairo_t *c, double scale, double width, double height)
{
    const double r = RADIUS * scale, right = 1.5707963267948966;

    cairo_new_sub_path(c);
    cairo_arc(c, width - r, r, r, -right, 0.0);
    cairo_arc(c, width - r, height - r, r, 0.0, right);
    cairo_arc(c, r, height - r, r, right, 2.0 * right);
    cairo_arc(c, r, r, r, 2.0 * right, 3.0 * right);
    cairo_close_path(c);
    cairo_set_source_rgba(c, 0.05, 0.06, 0.08, 0.92);
    cairo_fill(c);
}

static void measure(pen *p, const char *content)
{
    cairo_surface_t *none = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, 1, 1);

    p->c = cairo_create(none);
    /* Once for the position of the second column, once with it. */
    for (int i = 0; i < 2; i++) {
        p->widest = 0.0;
        write_all(p, content);
    }
    cairo_destroy(p->c);
    cairo_surface_destroy(none);
}

/* Finish the drawing; a failed one is empty. */
static void keep(panel *p, cairo_t *c, cairo_surface_t *surface)
{
    bool failed = cairo_status(c) != CAIRO_STATUS_SUCCESS;

    cairo_destroy(c);
    cairo_surface_flush(surface);
    if (failed || cairo_surface_status(surface) != CAIRO_STATUS_SUCCESS) {
        cairo_surface_destroy(surface);
        return;
    }
    p->surface = surface;
    p->pixels = (const uint32_t *)(const void *)cairo_image_surface_get_data(surface);
    p->width = cairo_image_surface_get_width(surface);
    p->height = cairo_image_surface_get_height(surface);
}

/* From here on the lines are drawn further up and only between the margins; the bar shows which part they are. */
static void scroll(pen *p, int from, int width, int shown, int height)
{
    const double margin = MARGIN * p->scale, track = shown - 2.0 * margin, bar = 4.0 * p->scale;

    cairo_set_source_rgb(p->c, 0.62, 0.80, 1.0);
    cairo_rectangle(p->c, width - 0.5 * margin - 0.5 * bar, margin + track * from / height, bar, track * shown / height);
    cairo_fill(p->c);
    cairo_rectangle(p->c, 0.0, 0.5 * margin, width, shown - margin);
    cairo_clip(p->c);
    cairo_translate(p->c, 0.0, -from);
}

static void draw_text(panel *p, pen *with, const char *content)
{
    double margins = 2.0 * MARGIN * with->scale;
    int width = (int)ceil(with->widest + margins), height = (int)ceil(with->y + margins);
    const int shown = p->room.height > 0 && p->room.height < height ? p->room.height : height;
    cairo_surface_t *surface;

    width = width < p->room.width ? width : p->room.width;
    surface = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width > 1 ? width : 1, shown);
    with->c = cairo_create(surface);
    ground(with->c, with->scale, width, shown);
    if (shown < height)
        scroll(with, p->room.from, width, shown, height);
    with->drawing = true;
    write_all(with, content);
    keep(p, with->c, surface);
    p->whole_height = height;
}

/* Does the content differ from the shown one? Then the latter is dropped, and the new name stored. */
static bool begin(panel *p, const char *content, double scale, const panel_room *room)
{
    if (content[0] == '\0' && !p->content)
        return false;
    if (p->content && strcmp(p->content, content) == 0 && p->scale == scale &&
        p->room.width == room->width && p->room.height == room->height && p->room.from == room->from)
        return false;
    panel_free(p);
    p->scale = scale;
    p->room = *room;
    if (content[0])
        p->content = malloc(strlen(content) + 1);
    if (p->content)
        strcpy(p->content, content);
    return true;
}

bool panel_set(panel *p, const char *content, double scale, const panel_room *room)
{
    pen with = { .scale = scale, .most = room->width - 2.0 * MARGIN * scale };

    if (!begin(p, content, scale, room))
        return false;
    if (p->content) {
        measure(&with, content);
        draw_text(p, &with, content);
    }
    return true;
}

/* The scale is 0 for a sheet, which has no ground and is drawn in pixels. */
static bool set_drawing(panel *p, const char *content, double scale, int across, int down,
                        void (*draw)(cairo_t *c, const void *user), const void *user)
{
    cairo_surface_t *surface;
    cairo_t *c;

    if (!begin(p, content, scale, &(panel_room){ across, 0, 0 }))
        return false;
    if (!p->content)
        return true;
    surface = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, across, down);
    c = cairo_create(surface);
    if (scale > 0.0) {
        ground(c, scale, across, down);
        cairo_scale(c, scale, scale);
    }
    draw(c, user);
    keep(p, c, surface);
    return true;
}

bool panel_set_drawing(panel *p, const char *content, double scale, double width, double height,
                       void (*draw)(cairo_t *c, const void *user), const void *user)
{
    return set_drawing(p, content, scale, (int)ceil(width * scale), (int)ceil(height * scale), draw, user);
}

bool panel_set_sheet(panel *p, const char *content, int width, int height, void (*draw)(cairo_t *c, const void *user),
                     const void *user)
{
    return set_drawing(p, content, 0.0, width, height, draw, user);
}

void panel_free(panel *p)
{
    free(p->content);
    if (p->surface)
        cairo_surface_destroy(p->surface);
    memset(p, 0, sizeof *p);
}
