/* present.h - draws the picture and the panels over it to the surface, by OpenGL. */
#ifndef VIEWER_PRESENT_H
#define VIEWER_PRESENT_H

#include "surface.h"

enum { PRESENT_PANELS = 8 };

/* An image of the panel: premultiplied, 0xAARRGGBB in the machine's order of bytes, as cairo has it. */
typedef struct present_panel { const uint32_t *pixels; int width, height, x, y; } present_panel;

/* How the picture is seen: magnified, and left of this column of the window the reference in its place. */
typedef struct present_look { const zoom *zoom; double reference_right; } present_look;

typedef struct present present;

pov_status present_create(present **out, surface *s, pov_error *err);
void present_destroy(present *p);
/* Allocate an empty picture of this size in advance. False: no memory. */
bool present_nothing(present *p, int width, int height);
/* Upload rows `first` to `last` of the picture: bytes red, green, blue and alpha. A picture of another size is uploaded
 * completely. */
void present_picture(present *p, const uint8_t *pixels, int width, int height, int first, int last);
/* The same for the reference. */
void present_reference(present *p, const uint8_t *pixels, int width, int height, int first, int last);
/* Set the image of the index-th panel; NULL pixels: none. */
void present_set_panel(present *p, int index, const present_panel *panel);
/* Draw everything into a surface of this size: the magnified part of the picture, or the whole one stretched to it. */
void present_draw(present *p, const present_look *look, int width, int height);
/* Red, green, blue and alpha of the drawn surface, upper row first. */
void present_read(present *p, int width, int height, uint8_t *out);

#endif
