/* message.h - #debug, #warning, #error and the like. */
#ifndef SDL_MESSAGE_H
#define SDL_MESSAGE_H

#include "sdl/state.h"

void message_run(pov_reader *in, const place *at);

#endif
