/* clock.h - seconds. */
#ifndef BASE_CLOCK_H
#define BASE_CLOCK_H

/* Monotonic wall time, seconds from an arbitrary moment. */
double clock_seconds(void);
/* Processor time of the calling thread, seconds. */
double clock_thread_seconds(void);

#endif
