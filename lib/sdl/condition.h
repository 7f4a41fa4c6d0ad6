/* condition.h - #if, #ifdef, #switch and what belongs to them. */
#ifndef SDL_CONDITION_H
#define SDL_CONDITION_H

#include "sdl/state.h"

void condition_if(pov_reader *in, const place *at);
void condition_ifdef(pov_reader *in, const place *at);
void condition_elseif(pov_reader *in, const place *at);
void condition_else(pov_reader *in, const place *at);
void condition_end(pov_reader *in, const place *at);
void condition_switch(pov_reader *in, const place *at);
void condition_case(pov_reader *in, const place *at);

/* #else, #elseif, #case, #range */
bool condition_is_branch(keyword_id keyword);
/* The next token is the word; behind it stands a condition in parentheses, whose ')' is not taken. */
bool condition_holds(pov_reader *in);
/* One more is open. False: no memory, and the reader has failed. */
bool condition_open(pov_reader *in, const condition *c);
/* The innermost one that is open in this macro, or NULL. */
condition *condition_top(pov_reader *in);

#endif
