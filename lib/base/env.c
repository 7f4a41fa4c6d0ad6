#include "base/env.h"

#include "base/str.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void *resize_with_libc(void *user, void *block, size_t bytes)
{
    (void)user;
    if (bytes == 0) {
        free(block);
        return NULL;
    }
    return realloc(block, bytes);
}

void env_init(env *e, const pov_allocator *allocator, pov_log_fn *log, void *log_user)
{
    e->allocator.resize = resize_with_libc;
    e->allocator.user = NULL;
    if (allocator && allocator->resize)
        e->allocator = *allocator;
    e->log = log;
    e->log_user = log_user;
}

static bool overflows(size_t count, size_t bytes)
{
    return bytes != 0 && count > SIZE_MAX / bytes;
}

void *env_alloc(const env *e, size_t count, size_t bytes)
{
    size_t total = count * bytes;
    void *block;

    if (overflows(count, bytes))
        return NULL;
    if (total == 0)
        total = 1;
    block = e->allocator.resize(e->allocator.user, NULL, total);
    if (block)
        memset(block, 0, total);
    return block;
}

void *env_resize(const env *e, void *block, size_t count, size_t bytes)
{
    if (overflows(count, bytes) || count == 0 || bytes == 0)
        return NULL;
    return e->allocator.resize(e->allocator.user, block, count * bytes);
}

/* The word before the aligned block holds the address that the allocator returned. */
void *env_reserve_aligned(const env *e, size_t bytes, size_t align)
{
    unsigned char *raw, *block;

    if (bytes > SIZE_MAX - align - sizeof raw)
        return NULL;
    raw = env_resize(e, NULL, 1, bytes + align + sizeof raw);
    if (!raw)
        return NULL;
    block = raw + sizeof raw;
    block += (align - ((uintptr_t)block & (align - 1))) & (align - 1);
    memcpy(block - sizeof raw, &raw, sizeof raw);
    return block;
}

void *env_alloc_aligned(const env *e, size_t bytes, size_t align)
{
    void *block = env_reserve_aligned(e, bytes, align);

    if (block)
        memset(block, 0, bytes);
    return block;
}

void env_free_aligned(const env *e, void *block)
{
    unsigned char *raw;

    if (!block)
        return;
    memcpy(&raw, (unsigned char *)block - sizeof raw, sizeof raw);
    env_free(e, raw);
}

void env_free(const env *e, void *block)
{
    if (block)
        e->allocator.resize(e->allocator.user, block, 0);
}

void env_log(const env *e, pov_log_level level, const pov_error *note)
{
    if (e->log)
        e->log(e->log_user, level, note);
}

void env_logf(const env *e, pov_log_level level, const char *format, ...)
{
    pov_error note;
    va_list args;

    if (!e->log)
        return;
    memset(&note, 0, sizeof note);
    va_start(args, format);
    vsnprintf(note.message, sizeof note.message, format, args);
    va_end(args);
    env_log(e, level, &note);
}
