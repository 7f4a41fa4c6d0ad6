/* thread.h - threads, a mutex, a condition variable. */
#ifndef BASE_THREAD_H
#define BASE_THREAD_H

#include <pthread.h>
#include <stdbool.h>

typedef pthread_t thread;
typedef pthread_mutex_t mutex;
typedef pthread_cond_t condition;

bool thread_start(thread *t, void *(*run)(void *user), void *user);
void thread_join(thread t);
/* Processors this process may run on, at least 1. */
int thread_cores(void);

bool mutex_init(mutex *m);
void mutex_destroy(mutex *m);
void mutex_lock(mutex *m);
void mutex_unlock(mutex *m);

/* Its timed wait uses the monotonic clock. */
bool condition_init(condition *c);
void condition_destroy(condition *c);
void condition_wait(condition *c, mutex *m);
/* Wait until woken or until clock_seconds() reaches `until`; false: the time was reached. */
bool condition_wait_until(condition *c, mutex *m, double until);
void condition_wake_all(condition *c);

#endif
