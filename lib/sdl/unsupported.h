/* unsupported.h - what is right in POV-Ray's language and not drawn here yet: it is read, named once with its place,
 * and left out. */
#ifndef SDL_UNSUPPORTED_H
#define SDL_UNSUPPORTED_H

#include "sdl/state.h"

/* `WHAT is not supported yet`, once for each keyword; an error where the program asked for that. */
void unsupported_note(pov_reader *in, const place *at, keyword_id keyword, const char *what);
/* The word that is next: note it, then it, its values and its block are left out. */
void unsupported_item(pov_reader *in);
/* The same without a note. */
void unsupported_skip_item(pov_reader *in);
/* A '{' is next: what stands up to its '}' is left out, which is taken. Directives in it are carried out, macros called,
 * random numbers drawn. */
void unsupported_skip_block(pov_reader *in);
/* The same from within a block, up to its '}', which is next then. */
void unsupported_skip_rest(pov_reader *in);
/* The word was taken: the name of a file in which POV-Ray keeps what is made anew for each picture here. A note says so. */
void unsupported_skip_file(pov_reader *in, keyword_id keyword, const char *of);

#endif
