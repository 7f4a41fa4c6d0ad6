/* number.h - decimal digits to the nearest double. */
#ifndef SDL_NUMBER_H
#define SDL_NUMBER_H

typedef enum number_state {
    NUMBER_FINE,
    NUMBER_MALFORMED,            /* as in 1.2.3 */
    NUMBER_HUGE,                 /* beyond the largest double */
    NUMBER_TINY                  /* not zero in the text, but rounds to zero */
} number_state;

/* Read an unsigned number that begins at `at` with a digit, or with a point and a digit. *after is where it
 * ends, also when it is no number. Correctly rounded always, whatever the program's locale. */
number_state number_read(const char *at, const char *end, const char **after, double *out);

#endif
