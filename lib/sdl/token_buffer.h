/* token_buffer.h - tokens that were lexed once, to be read as often as a loop or macro wants. */
#ifndef SDL_TOKEN_BUFFER_H
#define SDL_TOKEN_BUFFER_H

#include "sdl/tokens.h"

/* What is kept of a token that is read again: an expression or a directive that begins there, compiled. */
typedef enum replay_kind {
    REPLAY_MET,                  /* once; what is met again is compiled */
    REPLAY_NONE,                 /* it is read as ever */
    REPLAY_ADDITIVE, REPLAY_FULL,   /* an expression of that grammar */
    REPLAY_SET, REPLAY_IF, REPLAY_ELSE, REPLAY_END
} replay_kind;

typedef struct replay {
    struct replay *next;         /* of the buffer, for freeing */
    replay_kind kind;
} replay;

typedef struct token_buffer {
    struct token_buffer *next, *previous;   /* every buffer of a reader, for freeing */
    unsigned uses;
    token *items;
    size_t count, capacity;
    replay **replays;            /* by token; NULL: none was met yet */
    replay *compiled;            /* all that has memory of its own */
    replay met, none;            /* of tokens that are not compiled */
} token_buffer;

typedef struct token_buffer_list {
    const env *env;
    token_buffer *first;
} token_buffer_list;

/* Empty, in use once. NULL: no memory. */
token_buffer *token_buffer_create(token_buffer_list *list);
bool token_buffer_add(token_buffer_list *list, token_buffer *b, const token *t);
/* The first time for any token. */
replay **token_buffer_begin_replay(token_buffer_list *list, token_buffer *b, size_t index);
/* What is kept of the index-th token. NULL: no memory. */
static inline replay **token_buffer_replay(token_buffer_list *list, token_buffer *b, size_t index)
{
    return b->replays ? &b->replays[index] : token_buffer_begin_replay(list, b, index);
}
/* Memory that is freed with the buffer, zeroed. NULL: there is none. */
void *token_buffer_keep(token_buffer_list *list, token_buffer *b, size_t bytes);
void token_buffer_release(token_buffer_list *list, token_buffer *b);
void token_buffer_free_all(token_buffer_list *list);

#endif
