/* failing.h - an allocator that counts, fails when told to, and knows what has not been given back. */
#ifndef SUPPORT_FAILING_H
#define SUPPORT_FAILING_H

#include <povtrace/base.h>

#include <pthread.h>

typedef struct failing {
    pthread_mutex_t lock;        /* guards all below */
    long calls;                  /* allocations asked for so far */
    long fail_at;                /* the number of the call that fails, and all after it; 0: none */
    long blocks;                 /* not given back */
} failing;

void failing_init(failing *f, long fail_at);
pov_allocator failing_allocator(failing *f);

#endif
