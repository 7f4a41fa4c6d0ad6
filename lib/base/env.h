/* env.h - the environment that every object of the library holds: the program's memory and log hooks. */
#ifndef BASE_ENV_H
#define BASE_ENV_H

#include <povtrace/base.h>

typedef struct env {
    pov_allocator allocator;
    pov_log_fn *log;
    void *log_user;
} env;

/* Fill from the program's description; a NULL resize means malloc. */
void env_init(env *e, const pov_allocator *allocator, pov_log_fn *log, void *log_user);

/* Zeroed memory, or NULL; also NULL when count * bytes overflows. */
void *env_alloc(const env *e, size_t count, size_t bytes);
/* As realloc for an array; new elements are not zeroed. On failure the old block stays. */
void *env_resize(const env *e, void *block, size_t count, size_t bytes);
/* A zeroed block whose address is a multiple of align (a power of two); free it with env_free_aligned only. */
void *env_alloc_aligned(const env *e, size_t bytes, size_t align);
/* The same, not zeroed: for memory that several threads fill completely. */
void *env_reserve_aligned(const env *e, size_t bytes, size_t align);
void env_free_aligned(const env *e, void *block);
void env_free(const env *e, void *block);

void env_log(const env *e, pov_log_level level, const pov_error *note);
/* A message without a place in a scene. */
void env_logf(const env *e, pov_log_level level, const char *format, ...) POV_PRINTF(3, 4);

#endif
