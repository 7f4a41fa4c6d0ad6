/* intern.h - what is equal is kept once: parts of textures that a scene writes again and again. */
#ifndef SDL_INTERN_H
#define SDL_INTERN_H

#include <stddef.h>
#include <stdint.h>

struct env;
struct pov_reader;

typedef struct interned { const void *item; size_t compared; uint64_t hash; } interned;
typedef struct intern_table { interned *slots; size_t count, capacity; } intern_table;

/* The scene's copy of an item, whose first bytes, as many as are compared, never change. NULL: no memory, and the reader
 * has failed; or there are no bytes. */
const void *intern(struct pov_reader *in, const void *item, size_t bytes, size_t compared);
void intern_free(intern_table *t, const struct env *e);

#endif
