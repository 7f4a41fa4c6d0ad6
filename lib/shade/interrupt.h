/* interrupt.h - checks for an interrupt every few milliseconds, whatever the cost of a ray. */
#ifndef SHADE_INTERRUPT_H
#define SHADE_INTERRUPT_H

#include <stdbool.h>
#include <stdint.h>

typedef struct interrupt {
    bool (*ask)(void *user);     /* NULL: never */
    void *user;
    bool given_up;
    int left, every;             /* rays until the next check, and between two checks */
    double asked;                /* time of the last check */
} interrupt;

/* Set the callback. The interval between checks stays. */
void interrupt_set(interrupt *i, bool (*ask)(void *user), void *user);
/* After so many rays: is it time to give up? */
bool interrupt_is_due(interrupt *i, uint32_t rays);

#endif
