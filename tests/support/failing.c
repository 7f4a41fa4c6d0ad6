#include "support/failing.h"

#include <stdlib.h>

static void *resize(void *user, void *block, size_t bytes)
{
    failing *f = user;
    void *result = NULL;
    bool fail;

    pthread_mutex_lock(&f->lock);
    if (bytes == 0) {
        f->blocks -= block != NULL;
        pthread_mutex_unlock(&f->lock);
        free(block);
        return NULL;
    }
    f->calls++;
    fail = f->fail_at != 0 && f->calls >= f->fail_at;
    pthread_mutex_unlock(&f->lock);
    if (!fail)
        result = realloc(block, bytes);
    if (result && !block) {
        pthread_mutex_lock(&f->lock);
        f->blocks++;
        pthread_mutex_unlock(&f->lock);
    }
    return result;
}

void failing_init(failing *f, long fail_at)
{
    pthread_mutex_init(&f->lock, NULL);
    f->calls = f->blocks = 0;
    f->fail_at = fail_at;
}

pov_allocator failing_allocator(failing *f)
{
    pov_allocator a = { resize, f };

    return a;
}
