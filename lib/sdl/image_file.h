/* image_file.h - images and volumes that a scene names. Each file is read once, in the folders that scenes are read
 * from, by the plugin of its format; one that the scene wrote, once each time that it was written. */
#ifndef SDL_IMAGE_FILE_H
#define SDL_IMAGE_FILE_H

#include "model/image.h"
#include "sdl/state.h"

/* `png "name"`, `"name" gamma 2.2`: what stands at the beginning of each block of an image. */
typedef struct image_gamma { bool is_given, is_srgb; double number; } image_gamma;
/* colours: see image_function_parse(). NULL: the reader has failed. */
const image *image_file_parse(pov_reader *in, image_gamma *given, bool colours);

/* format NULL: by the name's ending. NULL: the reader has failed, at the name. */
const image *image_file_read(pov_reader *in, const string *name, const char *format);
/* A df3 file. False: the reader has failed. */
bool image_file_read_volume(pov_reader *in, const string *name, density_file *out);

#endif
