/* arena.h - memory that is freed all at once: a scene's. */
#ifndef BASE_ARENA_H
#define BASE_ARENA_H

#include "base/env.h"

typedef struct arena {
    const env *env;
    struct arena_block *blocks;
    size_t next_bytes;           /* size of the next block: sizes double, so that small scenes stay small */
    size_t bytes;                /* of all blocks */
} arena;

void arena_init(arena *a, const env *e);
void arena_free(arena *a);
/* Zeroed; align is a power of two of at most 64. NULL when memory ends. */
void *arena_alloc(arena *a, size_t bytes, size_t align);
/* Give back the last allocation. False: this was not the last one, and it stays. */
bool arena_give_back(arena *a, void *block, size_t bytes);
/* A copy of the first `length` bytes with an end mark. */
char *arena_text(arena *a, const char *text, size_t length);
char *arena_printf(arena *a, const char *format, ...) POV_PRINTF(2, 3);

#endif
