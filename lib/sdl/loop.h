/* loop.h - #while, #for, #break. */
#ifndef SDL_LOOP_H
#define SDL_LOOP_H

#include "sdl/state.h"

void loop_while(pov_reader *in, const place *at);
void loop_for(pov_reader *in, const place *at);
/* The #end of the innermost condition, a loop: its next turn, or what stands behind it. */
void loop_turn(pov_reader *in, const place *at);
void loop_break(pov_reader *in, const place *at);

#endif
