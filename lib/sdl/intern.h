/* intern.h - what is equal is kept once: parts of textures that a scene writes again and again. */
#ifndef SDL_INTERN_H
#define SDL_INTERN_H

#include <stddef.h>
#include <stdint.h>

struct env;
struct pov_reader;

typedef struct interned { const void *item; size_t bytes; uint64_t hash; } interned;
typedef struct intern_table { interned *slots; size_t count, capacity; } intern_table;

/* The scene's copy of these bytes, which never change. NULL: no memory, and the reader has failed; or bytes is 0. */
const void *intern(struct pov_reader *in, const void *item, size_t bytes);
void intern_free(intern_table *t, const struct env *e);

#endif
