/* panel.h - text on a dark ground, drawn by cairo into an image. */
#ifndef VIEWER_PANEL_H
#define VIEWER_PANEL_H

#include <cairo.h>

#include <stdbool.h>
#include <stdint.h>

/* The largest size that text may take, in pixels. Of more lines, those from `from` pixels below the first on are shown,
 * and a bar at the right tells where they are. */
typedef struct panel_room {
    int width;
    int height;                  /* 0: no limit */
    int from;
} panel_room;

typedef struct panel {
    char *content;               /* content of the image */
    double scale;
    panel_room room;
    cairo_surface_t *surface;
    const uint32_t *pixels;      /* premultiplied, as in cairo, rows without gaps; NULL: empty */
    int width, height;
    int whole_height;            /* of all lines; `height` shows less where there is no room */
} panel;

/* Show this text, as large as needed but no larger than the room. The first character of a line is its kind: '#' a
 * title, '!' a warning title, ' ' plain words that are wrapped, '|' two columns with a
 * tab between, of which the second is wrapped, '~' a bar whose kind bar.h names, with numbers that follow their positions, tabs between, '%' a square of
 * the colour of six hexadecimal digits and its meaning, '=' text as in a file, which the next line may mark: '^' and as many bytes as come before the caret. Invalid UTF-8 is shown as "?".
 * True: the image has changed. */
bool panel_set(panel *p, const char *content, double scale, const panel_room *room);
/* The same for a drawing of this size in units of the scale, whose background is drawn already; `content` identifies
 * it, and is empty for none. */
bool panel_set_drawing(panel *p, const char *content, double scale, double width, double height,
                       void (*draw)(cairo_t *c, const void *user), const void *user);
/* The same in pixels, and transparent where nothing is drawn. */
bool panel_set_sheet(panel *p, const char *content, int width, int height, void (*draw)(cairo_t *c, const void *user),
                     const void *user);
void panel_free(panel *p);

#endif
