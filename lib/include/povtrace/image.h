/* povtrace/image.h - writing and reading image files. The format follows from the name's ending. Each format is a
 * plugin in images/, loaded at first use, so a program that writes no PNG never loads libpng. */
#ifndef POVTRACE_IMAGE_H
#define POVTRACE_IMAGE_H

#include <povtrace/base.h>

struct pov_context;

/* One more channel of a file that has layers: "depth.Z" is the channel Z of the layer depth. Names have 1 to 31 characters. */
typedef struct pov_layer {
    const char *name;
    const float *values;     /* of the top left pixel; rows follow without gaps */
    int step;                /* floats from pixel to pixel */
} pov_layer;

typedef struct pov_image_options {
    size_t size;
    int bits;                /* bits a channel: 8 or 16; 0: the format's usual depth */
    pov_transfer transfer;   /* pov_scene_info names the scene's; formats of floats ignore it */
    const char *format;      /* ending that names the format if the path does not, as for "-"; NULL: by the path */
    int alpha;               /* not 0: store alpha, and colours divided by it; some formats cannot */
    double gamma;            /* above 0: integers store value ^ (1 / gamma), whatever the transfer */
    const pov_layer *layers; /* channels besides red, green and blue, of the picture's size; some formats have none */
    int layer_count;         /* at most 60 */
} pov_image_options;

/* Receives bytes: put returns false when it accepts no more. */
typedef struct pov_output { void *user; bool (*put)(void *user, const void *bytes, size_t count); } pov_output;

/* Linear float RGBA rows, top row first, stride in bytes. Written beside the target and renamed
 * over it, so a file of that name is whole or the old one. "-" is standard output. options may be NULL. */
POV_API pov_status pov_image_write(struct pov_context *context, const char *path, int width, int height,
                                   const float *rgba, size_t stride, const pov_image_options *options, pov_error *err);
/* The same to a program's own output; options->format is needed. */
POV_API pov_status pov_image_put(struct pov_context *context, const pov_output *output, int width, int height,
                                 const float *rgba, size_t stride, const pov_image_options *options, pov_error *err);

/* An image read from a file: linear light, four channels, top row first, no gaps; bits as in the file, 32: floats. */
typedef struct pov_bitmap { size_t size; int width, height, bits; float *rgba; } pov_bitmap;
/* The encoding that the file states is undone; pov_image_free() frees the pixels. Where out->width and out->height are
 * above 0, an image of another size is refused before its pixels are decoded. */
POV_API pov_status pov_image_read(struct pov_context *context, const char *path, pov_bitmap *out, pov_error *err);
POV_API void pov_image_free(struct pov_context *context, pov_bitmap *bitmap);

/* Is there a plugin for this path's ending, and can a file of that name be written? A program may ask before it
 * renders. Loads the plugin, and leaves no file. */
POV_API pov_status pov_image_check(struct pov_context *context, const char *path, const pov_image_options *options,
                                   pov_error *err);

/* Write bytes to a file like an image: all or nothing, links are followed, "-", devices and pipes are written to
 * directly. And: could they be written? That leaves no file behind. */
POV_API pov_status pov_file_write(struct pov_context *context, const char *path, const void *bytes, size_t count,
                                  pov_error *err);
POV_API pov_status pov_file_check(struct pov_context *context, const char *path, pov_error *err);

/* ---- a format, for plugins: see plugin.h --------------------------------- */

typedef struct pov_image {
    size_t size;
    int width, height, bits;       /* red, green, blue of 8 or 16 bits (native order), or of 32: float */
    pov_transfer transfer;         /* how the integers were encoded */
    size_t stride;                 /* bytes from row to row, top row first */
    const void *pixels;
    int alpha;                     /* not 0: a fourth channel, alpha, for formats of POV_IMAGE_ALPHA */
    double gamma;                  /* above 0: integers hold value ^ (1 / gamma), whatever the transfer */
    const pov_layer *layers;       /* for formats of POV_IMAGE_LAYERS */
    int layer_count;
} pov_image;

/* The reader describes the image, and receives memory for height rows of stride bytes; NULL: no memory. */
typedef struct pov_image_target { void *user; void *(*begin)(void *user, const pov_image *about); } pov_image_target;

/* How samples became numbers of 0 to 1 in a file. STORED: it does not say, and nothing is undone. */
typedef enum pov_encoding { POV_ENCODING_SRGB, POV_ENCODING_POWER, POV_ENCODING_LINEAR, POV_ENCODING_STORED } pov_encoding;

/* An image as its file stores it, for textures: samples are not decoded, and indices stay indices. */
typedef struct pov_raster {
    size_t size;
    int width, height, bits;       /* of a sample: 8 or 16 (native order), 32: float */
    int channels;                  /* 1: grey, or the index where there is a palette; 2: with alpha; 3, 4: red, green, blue */
    pov_encoding encoding;
    double power;                  /* POV_ENCODING_POWER: decoded = stored to this power */
    int colours;                   /* of the palette, red, green, blue, alpha each; 0: there is none */
    const unsigned char *palette;
    bool has_alpha;                /* the palette's alpha counts */
    size_t stride;
} pov_raster;

/* Receives the description before any pixel is decoded, and gives memory for height rows; NULL: it is not wanted. */
typedef struct pov_raster_target { void *user; void *(*begin)(void *user, const pov_raster *about); } pov_raster_target;

enum { POV_IMAGE_8 = 1u << 0, POV_IMAGE_16 = 1u << 1, POV_IMAGE_FLOAT = 1u << 2, POV_IMAGE_ALPHA = 1u << 3,
       POV_IMAGE_LAYERS = 1u << 4 };

typedef struct pov_image_format {
    uint32_t size, depths;         /* supported POV_IMAGE_*; the lowest depth is the usual one */
    const char *ending;            /* "png" */
    /* Any thread. NULL when all was put, else what went wrong, static text. Stop when put says false. NULL: not written. */
    const char *(*write)(const pov_image *image, const pov_output *output);
    /* Any thread. Decode the bytes of a whole file; may be NULL. Returns NULL on success, else what is wrong. */
    const char *(*read)(const void *bytes, size_t count, const pov_image_target *target);
    /* Any thread. The same as the file stores it; may be NULL. */
    const char *(*load)(const void *bytes, size_t count, const pov_raster_target *target);
} pov_image_format;

#endif
