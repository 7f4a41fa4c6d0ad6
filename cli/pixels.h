/* pixels.h - memory for a picture. */
#ifndef CLI_PIXELS_H
#define CLI_PIXELS_H

#include <stddef.h>

/* Red, green, blue and alpha of so many pixels, not zeroed, in large pages where the system has them: a picture is filled
 * once, and small pages take as long to get as to fill. NULL: no memory. Free it with free(). */
float *pixels_make(size_t width, size_t height);

#endif
