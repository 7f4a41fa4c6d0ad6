#define _GNU_SOURCE   /* sched_getaffinity, mutexes that spin */
#include "base/thread.h"

#include "base/clock.h"

#include <errno.h>
#include <sched.h>
#include <time.h>
#include <unistd.h>

bool thread_start(thread *t, void *(*run)(void *user), void *user)
{
    return pthread_create(t, NULL, run, user) == 0;
}

void thread_join(thread t)
{
    pthread_join(t, NULL);
}

int thread_cores(void)
{
    long n;
#ifdef __linux__
    cpu_set_t set;

    CPU_ZERO(&set);
    if (sched_getaffinity(0, sizeof set, &set) == 0 && CPU_COUNT(&set) > 0)
        return CPU_COUNT(&set);
#endif
    n = sysconf(_SC_NPROCESSORS_ONLN);
    return n > 0 ? (int)n : 1;
}

/* Critical sections take about a microsecond, putting a thread to sleep and waking it some fifty. Where the system
 * offers mutexes that spin a little before they sleep, these are used. */
bool mutex_init(mutex *m)
{
#ifdef PTHREAD_ADAPTIVE_MUTEX_INITIALIZER_NP
    const mutex spinning = PTHREAD_ADAPTIVE_MUTEX_INITIALIZER_NP;

    *m = spinning;
    return true;
#else
    return pthread_mutex_init(m, NULL) == 0;
#endif
}

void mutex_destroy(mutex *m)
{
    pthread_mutex_destroy(m);
}

void mutex_lock(mutex *m)
{
    pthread_mutex_lock(m);
}

void mutex_unlock(mutex *m)
{
    pthread_mutex_unlock(m);
}

bool condition_init(condition *c)
{
    pthread_condattr_t attributes;
    bool ok;

    if (pthread_condattr_init(&attributes) != 0)
        return false;
    pthread_condattr_setclock(&attributes, CLOCK_MONOTONIC);
    ok = pthread_cond_init(c, &attributes) == 0;
    pthread_condattr_destroy(&attributes);
    return ok;
}

void condition_destroy(condition *c)
{
    pthread_cond_destroy(c);
}

void condition_wait(condition *c, mutex *m)
{
    pthread_cond_wait(c, m);
}

bool condition_wait_until(condition *c, mutex *m, double until)
{
    struct timespec t;

    t.tv_sec = (time_t)until;
    t.tv_nsec = (long)(1e9 * (until - (double)t.tv_sec));
    return pthread_cond_timedwait(c, m, &t) != ETIMEDOUT;
}

void condition_wake_all(condition *c)
{
    pthread_cond_broadcast(c);
}
