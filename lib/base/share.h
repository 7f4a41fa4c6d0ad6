/* share.h - work in numbered slices, done by several threads at once. */
#ifndef BASE_SHARE_H
#define BASE_SHARE_H

#include <stdbool.h>
#include <stdint.h>

enum { SHARE_MAX = 64 };         /* more threads than this are never used */

/* Call part(user, i, hand) once for each i below count, in any order, on up to `threads` threads, the caller's among
 * them. `worker` is the number of the thread, below `threads`: calls with the same number never overlap. If fewer
 * threads can be started, they do all of the work. */
void share_work(int threads, uint32_t count, void (*slice)(void *user, uint32_t i, int worker), void *user);
/* Number of threads to use: `wanted`, or one for each core if that is 0. */
int share_threads(int wanted);

/* Where the i-th of `slices` nearly equal parts of n begins; it ends where the next begins. */
static inline uint32_t share_begin(uint32_t n, uint32_t slices, uint32_t i)
{
    return (uint32_t)((uint64_t)n * i / slices);
}

#endif
