/* povtrace/image.h - pixels to a file. The format follows from the name's
 * ending; each format is a plugin in images/, loaded when first asked
 * for, so a program that writes no PNG never loads libpng. */
#ifndef POVTRACE_IMAGE_H
#define POVTRACE_IMAGE_H

#include <povtrace/base.h>

struct pov_context;

/* How linear values become integers: stored as they are, or with the sRGB curve. */
typedef enum pov_transfer { POV_TRANSFER_LINEAR, POV_TRANSFER_SRGB } pov_transfer;

typedef struct pov_image_options {
    size_t size;
    int bits;                /* a channel: 8 or 16; 0: what is usual for the format */
    pov_transfer transfer;   /* pov_scene_info names the scene's; formats of floats ignore it */
    const char *format;      /* the ending to go by when the path does not show it, as for "-"; NULL: by the path */
} pov_image_options;

/* Linear float RGBA rows, top row first, stride in bytes; alpha is not stored. Written beside the target and renamed
 * over it, so a file of that name is whole or the old one. "-" is standard output. options may be NULL. */
POV_API pov_status pov_image_write(struct pov_context *context, const char *path, int width, int height,
                                   const float *rgba, size_t stride, const pov_image_options *options, pov_error *err);
/* Is there a plugin for this path's ending? Loads it; so that a program may ask before it renders. */
POV_API pov_status pov_image_check(struct pov_context *context, const char *path, const pov_image_options *options,
                                   pov_error *err);

#endif
