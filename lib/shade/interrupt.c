#include "shade/interrupt.h"

#include "base/clock.h"

#include <stddef.h>

/* Seconds between two checks for an interrupt: a cancelled job ends well within 20 ms, also if rays become a hundred
 * times slower from one check to the next. */
static const double ask_soon = 0.002, ask_late = 0.008;
enum { EVERY_MAX = 256 };

void interrupt_set(interrupt *i, bool (*ask)(void *user), void *user)
{
    i->ask = ask;
    i->user = user;
    i->given_up = false;
    if (i->every == 0)
        i->every = i->left = 1;
}

/* Rays cost from 100 ns to many milliseconds, so the interval follows the clock. No colour depends on it. */
bool interrupt_is_due(interrupt *i, uint32_t rays)
{
    double now;

    i->left -= (int)rays;
    if (!i->ask || i->given_up || i->left > 0)
        return i->given_up;
    now = clock_seconds();
    if (now - i->asked < ask_soon && i->every < EVERY_MAX)
        i->every *= 2;
    else if (now - i->asked > ask_late)
        i->every = i->every > 8 ? i->every / 8 : 1;
    i->asked = now;
    i->left = i->every;
    i->given_up = i->ask(i->user);
    return i->given_up;
}
