/* failing.h - an allocator that counts, fails on request, and finds leaks. */
#ifndef SUPPORT_FAILING_H
#define SUPPORT_FAILING_H

#include <povtrace/base.h>

#include <pthread.h>

typedef struct failing {
    pthread_mutex_t lock;        /* guards all below */
    long calls;                  /* allocations asked for so far */
    long fail_at;                /* number of the first call that fails; all later calls fail too; 0: none */
    long blocks;                 /* allocations not freed */
} failing;

void failing_init(failing *f, long fail_at);
pov_allocator failing_allocator(failing *f);

#endif
