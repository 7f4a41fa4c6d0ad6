#include "base/arena.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { FIRST_BLOCK = 4096, LARGEST_BLOCK = 1 << 20 };

struct arena_block {
    struct arena_block *next;
    size_t used, size;           /* bytes, counted from the block's own start */
};

void arena_init(arena *a, const env *e)
{
    a->env = e;
    a->blocks = NULL;
    a->next_bytes = FIRST_BLOCK;
    a->bytes = 0;
}

void arena_free(arena *a)
{
    struct arena_block *b, *next;

    for (b = a->blocks; b; b = next) {
        next = b->next;
        env_free(a->env, b);
    }
    arena_init(a, a->env);
}

/* Where the next allocation of that alignment starts in a block. */
static size_t start_of(const struct arena_block *b, size_t align)
{
    uintptr_t at = (uintptr_t)b + b->used;
    return b->used + (size_t)((align - (at & (align - 1))) & (align - 1));
}

static struct arena_block *add_block(arena *a, size_t bytes, size_t align)
{
    size_t head = sizeof(struct arena_block) + align, size = a->next_bytes;
    struct arena_block *b;

    if (bytes > SIZE_MAX - head)
        return NULL;
    if (size < bytes + head)
        size = bytes + head;
    b = env_resize(a->env, NULL, 1, size);
    if (!b)
        return NULL;
    b->used = sizeof *b;
    b->size = size;
    a->bytes += size;
    if (a->blocks && size > a->next_bytes) {
        /* A block larger than usual goes behind the current one, so that the rest of the current block is still
         * used. */
        b->next = a->blocks->next;
        a->blocks->next = b;
    } else {
        b->next = a->blocks;
        a->blocks = b;
    }
    if (a->next_bytes < LARGEST_BLOCK)
        a->next_bytes *= 2;
    return b;
}

void *arena_alloc(arena *a, size_t bytes, size_t align)
{
    struct arena_block *b = a->blocks;
    size_t start = 0;

    if (b)
        start = start_of(b, align);
    if (!b || start > b->size || bytes > b->size - start) {
        b = add_block(a, bytes, align);
        if (!b)
            return NULL;
        start = start_of(b, align);
    }
    b->used = start + bytes;
    return memset((unsigned char *)b + start, 0, bytes);   /* not before: so it is in the cache when it is written */
}

bool arena_give_back(arena *a, void *block, size_t bytes)
{
    struct arena_block *b = a->blocks;

    if (!b || (unsigned char *)block + bytes != (unsigned char *)b + b->used)
        return false;
    b->used -= bytes;
    return true;
}

char *arena_text(arena *a, const char *text, size_t length)
{
    char *copy = length < SIZE_MAX ? arena_alloc(a, length + 1, 1) : NULL;

    if (copy && length > 0)
        memcpy(copy, text, length);
    return copy;
}

char *arena_printf(arena *a, const char *format, ...)
{
    char text[1024];
    va_list args;

    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    return arena_text(a, text, strlen(text));
}
