/* panel.h - text on a dark ground, drawn by cairo into an image. */
#ifndef VIEWER_PANEL_H
#define VIEWER_PANEL_H

#include <cairo.h>

#include <stdbool.h>
#include <stdint.h>

typedef struct panel {
    char *content;               /* content of the image */
    double scale;
    int most_width;
    cairo_surface_t *surface;
    const uint32_t *pixels;      /* premultiplied, as in cairo, rows without gaps; NULL: empty */
    int width, height;
} panel;

/* Show this text, as wide as needed but no wider than so many pixels. The first character of a line is its kind: '#' a
 * title, '!' a warning title, ' ' plain words that are wrapped, '|' two columns with a
 * tab between, '~' a bar whose kind bar.h names, with numbers that follow their positions, tabs between, '%' a square of
 * the colour of six hexadecimal digits and its meaning, '=' text as in a file, which the next line may mark: '^' and as many bytes as come before the caret. Invalid UTF-8 is shown as "?".
 * True: the image has changed. */
bool panel_set(panel *p, const char *content, double scale, int most_width);
/* The same for a drawing of this size in units of the scale, whose background is drawn already; `content` identifies
 * it, and is empty for none. */
bool panel_set_drawing(panel *p, const char *content, double scale, double width, double height,
                       void (*draw)(cairo_t *c, const void *user), const void *user);
/* The same in pixels, and transparent where nothing is drawn. */
bool panel_set_sheet(panel *p, const char *content, int width, int height, void (*draw)(cairo_t *c, const void *user),
                     const void *user);
void panel_free(panel *p);

#endif
