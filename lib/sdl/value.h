/* value.h - numbers, vectors, colours. Every reader of the language, plugins too, gets its values here; here
 * alone expressions will be known. */
#ifndef SDL_VALUE_H
#define SDL_VALUE_H

#include "sdl/state.h"

/* Does a value come next? */
bool value_follows(const pov_reader *in);
double value_number(pov_reader *in);
/* A number that a float holds: fails where it doesn't. */
float value_float(pov_reader *in);
/* A number stands for all components, two numbers have a 0 behind them, as in POV-Ray (for flat polygons). */
pov_vec3 value_vector(pov_reader *in);

enum { VALUE_LIST_MAX = 12 };
/* `<...>` of `least` to `most` numbers, zeros behind those that are not given; returns how many are. A number
 * in place of a list returns 1 and stands in out[0], which has room for `most`. */
int value_list(pov_reader *in, const char *wanted, int least, int most, double *out);

typedef struct paint {
    colour colour;
    float filter, transmit;
} paint;

/* A colour begins with one of its words; a bare number or vector counts as one where bare is true. */
bool value_colour_follows(const pov_reader *in, bool bare);
paint value_colour(pov_reader *in, bool bare);

#endif
