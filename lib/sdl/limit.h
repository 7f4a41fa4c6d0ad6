/* limit.h - loops and macros that do not end, and programs that want no more of the text. */
#ifndef SDL_LIMIT_H
#define SDL_LIMIT_H

#include "sdl/state.h"

/* One more turn of a loop, or call of a macro. False: there were too many, or the scene has grown too large or has taken
 * too long; the reader has failed. */
bool limit_turn(pov_reader *in, const place *at);
/* Only the latter two. */
void limit_look(pov_reader *in, const place *at);
/* Only the last. */
bool limit_time(pov_reader *in, const place *at);
/* Count bytes of text that was read. False: there are more than there may be. */
bool limit_input(pov_reader *in, size_t bytes);
/* The same of pixels of images. */
bool limit_images(pov_reader *in, size_t bytes);
/* Read a file as file_read() does, as far as the limit of all input allows. */
pov_status limit_read_file(pov_reader *in, const char *path, char **bytes, size_t *count, pov_error *err);
/* Tell how far reading is; the reader fails if the program wants no more. */
void limit_tell(pov_reader *in);
/* Tokens between two times. */
enum { LIMIT_TELL_EVERY = 1 << 12 };

#endif
