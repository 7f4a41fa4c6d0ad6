#include "base/share.h"

#include "base/thread.h"

typedef struct work {
    void (*slice)(void *user, uint32_t i, int worker);
    void *user;
    uint32_t count;
    mutex lock;                  /* guards next */
    uint32_t next;
} work;

typedef struct worker { work *work; int worker; } worker;

static void *run(void *user)
{
    worker *k = user;
    work *w = k->work;

    for (;;) {
        uint32_t mine;
        mutex_lock(&w->lock);
        mine = w->next < w->count ? w->next++ : w->count;
        mutex_unlock(&w->lock);
        if (mine == w->count)
            return NULL;
        w->slice(w->user, mine, k->worker);
    }
}

int share_threads(int wanted)
{
    int n = wanted > 0 ? wanted : thread_cores();
    return n < SHARE_MAX ? n : SHARE_MAX;
}

void share_work(int threads, uint32_t count, void (*slice)(void *user, uint32_t i, int worker), void *user)
{
    work w = { .slice = slice, .user = user, .count = count };
    worker workers[SHARE_MAX];
    thread started[SHARE_MAX];
    int i, n = 0;
    uint32_t k;

    if ((uint32_t)threads > count)
        threads = (int)count;
    if (threads <= 1 || !mutex_init(&w.lock)) {
        for (k = 0; k < count; k++)
            slice(user, k, 0);
        return;
    }
    for (i = 0; i < threads; i++) {
        workers[i].work = &w;
        workers[i].worker = i;
    }
    while (n < threads - 1 && thread_start(&started[n], run, &workers[n + 1]))
        n++;
    run(&workers[0]);
    for (i = 0; i < n; i++)
        thread_join(started[i]);
    mutex_destroy(&w.lock);
}
