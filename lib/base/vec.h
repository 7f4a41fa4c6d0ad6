/* vec.h - growing an array by doubling. */
#ifndef BASE_VEC_H
#define BASE_VEC_H

#include "base/env.h"

/* Reserve memory for one more element behind `count` of them. False: no memory, nothing changed. */
bool vec_reserve(const env *e, void **items, size_t *capacity, size_t count, size_t bytes);

/* Append a value to an array that has `items`, `count` and `capacity` members: VEC_PUSH(env, list, value). */
#define VEC_PUSH(e, list, value) \
    (vec_reserve((e), (void **)&(list)->items, &(list)->capacity, (list)->count, sizeof *(list)->items) && \
     ((list)->items[(list)->count++] = (value), true))

#endif
