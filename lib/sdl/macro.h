/* macro.h - #macro, and calls of macros. */
#ifndef SDL_MACRO_H
#define SDL_MACRO_H

#include "sdl/state.h"

typedef struct macro {
    shared head;
    token_buffer_list *buffers;
    token_buffer *tokens;        /* in use; NULL: the macro was not called yet, and its body is text */
    size_t start, end;           /* of the body in them */
    source *text;
    source begin;                /* the text as it stands before the body */
    const char *behind;          /* its #end */
    place at;
    int number;                  /* no two macros have the same */
    int count;
    symbol *parameters[];
} macro;

void macro_define(pov_reader *in, const place *at);
/* The next token is a macro's name: its arguments, then its body is what comes next. */
void macro_call(pov_reader *in);
/* The body becomes tokens, unless it is. False: no memory, and the reader has failed. */
bool macro_lex(pov_reader *in, macro *m);

#endif
