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

/* Where bytes go: put says false when it took no more. */
typedef struct pov_output { void *user; bool (*put)(void *user, const void *bytes, size_t count); } pov_output;

/* Linear float RGBA rows, top row first, stride in bytes; alpha is not stored. Written beside the target and renamed
 * over it, so a file of that name is whole or the old one. "-" is standard output. options may be NULL. */
POV_API pov_status pov_image_write(struct pov_context *context, const char *path, int width, int height,
                                   const float *rgba, size_t stride, const pov_image_options *options, pov_error *err);
/* The same to a program's own output; options->format is needed. */
POV_API pov_status pov_image_put(struct pov_context *context, const pov_output *output, int width, int height,
                                 const float *rgba, size_t stride, const pov_image_options *options, pov_error *err);

/* An image as it was read: linear light, four channels, top row first, no gaps; bits as in the file, 32: floats. */
typedef struct pov_bitmap { size_t size; int width, height, bits; float *rgba; } pov_bitmap;
/* What the file says of its encoding counts; pov_image_free() takes the pixels back. */
POV_API pov_status pov_image_read(struct pov_context *context, const char *path, pov_bitmap *out, pov_error *err);
POV_API void pov_image_free(struct pov_context *context, pov_bitmap *bitmap);

/* Is there a plugin for this path's ending? Loads it; so that a program may ask before it renders. */
POV_API pov_status pov_image_check(struct pov_context *context, const char *path, const pov_image_options *options,
                                   pov_error *err);

#endif
