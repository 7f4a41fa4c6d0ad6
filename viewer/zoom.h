/* zoom.h - which part of the picture the window shows, magnified. The camera does not move. A whole factor and a corner
 * on the window's grid of pixels: each pixel of the picture is a square of equal size. */
#ifndef VIEWER_ZOOM_H
#define VIEWER_ZOOM_H

#include <stdbool.h>

typedef struct zoom {
    int factor;              /* pixels of the window across one of the picture's; 1: the whole picture, 0 is the same */
    double left, top;        /* position in the picture of the window's upper left corner */
    double rest;             /* part of a wheel's step that has had no effect yet */
} zoom;

bool zoom_is_on(const zoom *z);
/* So many steps nearer, or further away if negative; what is at x, y of the window stays there as far as the picture's
 * edges let it. Sizes are the window's. True: something has changed. */
bool zoom_step(zoom *z, double steps, double x, double y, int width, int height);
/* Move what is shown by so many pixels of the window, as far as the picture's edges. */
void zoom_pan(zoom *z, double right, double down, int width, int height);
/* The window has another size. */
void zoom_fit(zoom *z, int width, int height);
/* From a position in the window to one in the picture, and back. */
void zoom_to_picture(const zoom *z, double x, double y, double *picture_x, double *picture_y);
void zoom_to_window(const zoom *z, double picture_x, double picture_y, double *x, double *y);

#endif
