/* still.c - a clock that stands still, and waits that only an event ends: how many rays go together follows the clock, and how often
 * a thread looks whether another is done. To be loaded before povc, so that its instructions can be counted. */
#include <pthread.h>
#include <time.h>

int clock_gettime(clockid_t clock, struct timespec *out)
{
    (void)clock;
    out->tv_sec = 1000;
    out->tv_nsec = 0;
    return 0;
}

int pthread_cond_timedwait(pthread_cond_t *restrict condition, pthread_mutex_t *restrict mutex, const struct timespec *restrict until)
{
    (void)until;
    return pthread_cond_wait(condition, mutex);
}
