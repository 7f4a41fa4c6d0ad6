/* parse_image.h - the blocks of images and volumes that stand behind the word of a pattern. */
#ifndef SDL_PARSE_IMAGE_H
#define SDL_PARSE_IMAGE_H

#include "sdl/parse_map.h"
#include "texture/pattern.h"

/* What a block says besides the pattern's parsed form. */
typedef struct image_block {
    bool has_bump_size;
    float bump_size;
    map_parsed textures;         /* of material_map */
} image_block;

/* The word of the class was taken: `{ png "name" ... }`, or `df3 "name"` with its words. */
void parse_image(pov_reader *in, const pattern_class *class, void *self, image_block *out);

#endif
