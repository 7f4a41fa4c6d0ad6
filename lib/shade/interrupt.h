/* interrupt.h - asking now and then whether to give up, each few milliseconds at most, whatever a ray costs. */
#ifndef SHADE_INTERRUPT_H
#define SHADE_INTERRUPT_H

#include <stdbool.h>
#include <stdint.h>

typedef struct interrupt {
    bool (*ask)(void *user);     /* NULL: never */
    void *user;
    bool given_up;
    int left, every;             /* rays until the next question, and from one question to the next */
    double asked;                /* when the last one was */
} interrupt;

/* Ask from now on. The pace that was found stays. */
void interrupt_set(interrupt *i, bool (*ask)(void *user), void *user);
/* After so many rays: is it time to give up? */
bool interrupt_is_due(interrupt *i, uint32_t rays);

#endif
