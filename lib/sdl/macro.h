/* macro.h - #macro, and calls of macros. */
#ifndef SDL_MACRO_H
#define SDL_MACRO_H

#include "sdl/state.h"

typedef struct macro {
    shared head;
    token_buffer_list *buffers;
    token_buffer *tokens;        /* in use */
    size_t start, end;           /* of the body */
    place at;
    int number;                  /* no two macros have the same */
    int count;
    symbol *parameters[];
} macro;

void macro_define(pov_reader *in, const place *at);
/* The next token is a macro's name: its arguments, then its body is what comes next. */
void macro_call(pov_reader *in);

#endif
