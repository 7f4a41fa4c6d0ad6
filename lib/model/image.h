/* image.h - an image as its file stores it, and what a scene wants to have of it. */
#ifndef MODEL_IMAGE_H
#define MODEL_IMAGE_H

#include "model/texture.h"

#include <povtrace/image.h>

/* Shared by all that name the file. */
typedef struct image {
    uint32_t width, height, channels, bits;   /* as in pov_raster */
    pov_encoding encoding;
    double power;
    uint32_t colours;            /* of the palette; 0: there is none */
    bool has_alpha;              /* of the pixels, or of the palette */
    bool is_cut;                 /* grey that loses precision where it is decoded, as POV-Ray's does */
    size_t stride;
    const unsigned char *samples;
    unsigned char palette[256][4];
} image;

/* Numbers of the language. */
typedef enum image_map_type { IMAGE_PLANAR = 0, IMAGE_SPHERICAL = 1, IMAGE_CYLINDRICAL = 2, IMAGE_TOROIDAL = 5 } image_map_type;
typedef enum image_interpolation {
    IMAGE_PIXELS = 0, IMAGE_BILINEAR = 2, IMAGE_BICUBIC = 3, IMAGE_NORMALISED = 4
} image_interpolation;

/* The parsed form of image_map, bump_map, material_map and image_pattern. */
typedef struct image_map {
    const image *image;
    image_map_type type;
    image_interpolation interpolation;
    bool once;
    bool use_index, use_alpha;
    bool premultiplied;          /* decoded colours are times their alpha, and divided by it */
    const float *decoded;        /* of samples of 8 and 16 bits; NULL: they are what is stored, and floats are decoded already */
    const pigment *palette;      /* decoded; NULL: there is none */
    float filter, transmit;      /* `all`; the first replaces what a pixel has, the second is added to it */
    uint32_t count;              /* of textures */
} image_map;

/* ---- volumes ---- */

/* The parsed form of density_file: samples of 1, 2 or 4 bytes, the high byte first, x fastest. */
typedef struct density_file {
    uint32_t size[3], bytes;
    int32_t interpolation;       /* 0: none, 1: linear, 2: cubic */
    const unsigned char *samples;
} density_file;

#endif
