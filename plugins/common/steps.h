/* steps.h - crossings of a threshold along lines, by a function of which nothing is known but how fast it changes at most.
 *
 * So around a point there is no root as near as its value over that bound, and a stretch is made shorter from both ends before it
 * is halved. Stretches of a given length are searched no further; roots between points on different sides are found to the last bit.
 * Several lines ask their next values together: a function takes many points for little more than one. */
#ifndef COMMON_STEPS_H
#define COMMON_STEPS_H

#include <povtrace/plugin.h>

#include <stdbool.h>
#include <stdint.h>

/* Points o + t d, t from 0 to `end`. */
typedef struct common_steps_line {
    pov_vec3 o, d;
    double speed, end;           /* speed: the length of d */
    double start;                /* the function's value at 0, if it is known */
    bool start_is_known;
    void *user;
} common_steps_line;

typedef enum common_steps_event { COMMON_STEPS_BELOW_START, COMMON_STEPS_ROOT, COMMON_STEPS_BELOW_END } common_steps_event;

typedef struct common_steps {
    const pov_function *function;
    double threshold, gradient;
    double accuracy, size;       /* the length of the shortest stretches, and of the largest */
    /* What is found along a line, in order of t. False: nothing more is wanted of this line. */
    bool (*found)(void *user, common_steps_event event, double t);
} common_steps;

/* Doubles that common_steps_search() needs. */
static inline size_t common_steps_memory(const pov_function *f)
{
    return f->memory > f->memory_many ? f->memory : f->memory_many;
}

void common_steps_search(const common_steps *s, const common_steps_line *lines, uint32_t n, double *memory);

#endif
