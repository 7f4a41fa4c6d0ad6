/* intrinsic.h - the functions and constants of expressions that the language itself has. */
#ifndef SDL_INTRINSIC_H
#define SDL_INTRINSIC_H

#include "sdl/state.h"

#include <math.h>

typedef struct intrinsic {
    const char *name;
    void (*read)(pov_reader *in, const struct intrinsic *row, value *out);   /* its name has been taken */
    double (*of_one)(double);
    double (*of_two)(double, double);
    double v[5];                 /* of a constant */
    int size;
} intrinsic;

typedef struct intrinsic_list { const intrinsic *rows; size_t count; } intrinsic_list;

/* Note at the words of the language which of them are functions. */
void intrinsic_init(symbols *words);
intrinsic_list intrinsic_vector_rows(void);
intrinsic_list intrinsic_string_rows(void);
intrinsic_list intrinsic_object_rows(void);

#endif
