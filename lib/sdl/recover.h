/* recover.h - reading on behind an error, to find more of them in one run. */
#ifndef SDL_RECOVER_H
#define SDL_RECOVER_H

#include "sdl/state.h"

enum { RECOVER_ERRORS_MAX = 20 };

/* The reader has failed in a statement: log the error and go on behind the statement. False: it has been read as far as
 * it makes sense, and the last error is not logged. */
bool recover(pov_reader *in);
/* The first of the errors is the result; the last one is logged if it is another. */
void recover_finish(pov_reader *in);

#endif
