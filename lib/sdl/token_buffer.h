/* token_buffer.h - tokens that were lexed once, to be read as often as a loop or macro wants. */
#ifndef SDL_TOKEN_BUFFER_H
#define SDL_TOKEN_BUFFER_H

#include "sdl/tokens.h"

typedef struct token_buffer {
    struct token_buffer *next, *previous;   /* every buffer of a reader, for freeing */
    unsigned uses;
    token *items;
    size_t count, capacity;
} token_buffer;

typedef struct token_buffer_list {
    const env *env;
    token_buffer *first;
} token_buffer_list;

/* Empty, in use once. NULL: no memory. */
token_buffer *token_buffer_create(token_buffer_list *list);
bool token_buffer_add(token_buffer_list *list, token_buffer *b, const token *t);
void token_buffer_release(token_buffer_list *list, token_buffer *b);
void token_buffer_free_all(token_buffer_list *list);

#endif
