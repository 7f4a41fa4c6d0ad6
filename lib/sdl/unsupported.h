/* unsupported.h - what is right in POV-Ray's language and not here yet. */
#ifndef SDL_UNSUPPORTED_H
#define SDL_UNSUPPORTED_H

#include "sdl/state.h"

/* Fail with POV_E_UNSUPPORTED: `WHAT is not supported yet`. The rest of the text is looked through, and each
 * other missing feature that its words stand for is logged once, with its first place. */
void unsupported_form(pov_reader *in, const place *at, const char *what);
/* The same for the word that is next, one of a feature to come. */
void unsupported_word(pov_reader *in);
/* For the directive of that index, whose # is given and whose name is next. */
void unsupported_directive(pov_reader *in, const place *mark, int index);

#endif
