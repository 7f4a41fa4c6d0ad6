/* limit.h - loops and macros that do not end, and programs that want no more of the text. */
#ifndef SDL_LIMIT_H
#define SDL_LIMIT_H

#include "sdl/state.h"

/* One more turn of a loop, or call of a macro. False: there were too many, or the scene has grown too large or has taken
 * too long; the reader has failed. */
bool limit_turn(pov_reader *in, const place *at);
/* Tell how far reading is; the reader fails if the program wants no more. */
void limit_tell(pov_reader *in);
/* Tokens between two times. */
enum { LIMIT_TELL_EVERY = 1 << 12 };

#endif
