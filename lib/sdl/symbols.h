/* symbols.h - words to what is known of them. */
#ifndef SDL_SYMBOLS_H
#define SDL_SYMBOLS_H

#include "base/arena.h"
#include "sdl/tokens.h"

typedef struct symbols {
    const env *env;
    arena memory;                /* of words that texts brought */
    symbol *keywords;            /* those of the language, in one piece, by identifier */
    symbol **slots;              /* open addressing; capacity is a power of two, at most half full */
    size_t count, capacity;
} symbols;

#define SYMBOLS_HASH_START 2166136261u

/* One more byte of a word into its hash (FNV-1a). */
static inline uint32_t symbols_hash(uint32_t hash, unsigned char byte)
{
    return (hash ^ byte) * 16777619u;
}

/* Holds the words of the language. False: no memory; free it all the same. */
bool symbols_init(symbols *s, const env *e);
void symbols_free(symbols *s);
/* NULL: never met. */
symbol *symbols_find(const symbols *s, const char *text, uint32_t length, uint32_t hash);
/* The same for a word with an end mark. */
symbol *symbols_named(const symbols *s, const char *name);
/* The symbol of a word, made if it was never met. NULL: no memory. */
symbol *symbols_add(symbols *s, const char *text, uint32_t length, uint32_t hash);

#endif
