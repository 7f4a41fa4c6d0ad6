/* panel.h - text on a dark ground, drawn by cairo into an image. */
#ifndef VIEWER_PANEL_H
#define VIEWER_PANEL_H

#include <cairo.h>

#include <stdbool.h>
#include <stdint.h>

typedef struct panel {
    char *content;               /* what the image shows */
    double scale;
    int most_width;
    cairo_surface_t *surface;
    const uint32_t *pixels;      /* premultiplied, as cairo has it, rows without gaps; NULL: nothing to show */
    int width, height;
} panel;

/* Show this text, as wide as it needs to be but no wider than so many pixels. A line begins with what it is: '#' a
 * title, '!' a title that warns, ' ' plain words that are broken where they do not fit, '|' two columns with a tab
 * between, '=' text as it stands in a file, which the next line may mark: '^' and as many bytes as come before the
 * caret. Other bytes than UTF-8 are shown as "?". True: the image is another than before. */
bool panel_set(panel *p, const char *content, double scale, int most_width);
/* The same for a drawing of this size in units of the scale, whose ground is there already; `content` tells it from
 * others, and is empty for none. */
bool panel_set_drawing(panel *p, const char *content, double scale, double width, double height,
                       void (*draw)(cairo_t *c, const void *user), const void *user);
void panel_free(panel *p);

#endif
