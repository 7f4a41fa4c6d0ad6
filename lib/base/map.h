/* map.h - from names to pointers. Names are copied; the values are the caller's. */
#ifndef BASE_MAP_H
#define BASE_MAP_H

#include "base/env.h"

typedef struct map_entry { char *name; void *value; } map_entry;
typedef struct map { const env *env; map_entry *slots; size_t count, capacity; } map;

void map_init(map *m, const env *e);
void map_free(map *m);
void *map_get(const map *m, const char *name);
/* Add or replace. False: no memory. */
bool map_put(map *m, const char *name, void *value);

#endif
