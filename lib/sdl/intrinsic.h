/* intrinsic.h - the functions and constants of expressions that the language itself has. */
#ifndef SDL_INTRINSIC_H
#define SDL_INTRINSIC_H

#include "sdl/state.h"

#include <math.h>

/* What compiled expressions make of it; OTHER: such are not compiled. */
typedef enum intrinsic_form {
    INTRINSIC_OTHER, INTRINSIC_CONSTANT, INTRINSIC_ONE, INTRINSIC_TWO, INTRINSIC_MANY, INTRINSIC_BITS,
    INTRINSIC_SELECT, INTRINSIC_ARC, INTRINSIC_LOGARITHM, INTRINSIC_ROOT, INTRINSIC_ATAN2, INTRINSIC_POW,
    INTRINSIC_RAND, INTRINSIC_VLENGTH, INTRINSIC_VDOT, INTRINSIC_VCROSS, INTRINSIC_VNORMALIZE
} intrinsic_form;

typedef struct intrinsic {
    const char *name;
    void (*read)(pov_reader *in, const struct intrinsic *row, value *out);   /* its name has been taken */
    double (*of_one)(double);
    double (*of_two)(double, double);
    double v[5];                 /* of a constant */
    int size;
    intrinsic_form form;
} intrinsic;

typedef struct intrinsic_list { const intrinsic *rows; size_t count; } intrinsic_list;

/* Note at the words of the language which of them are functions. */
void intrinsic_init(symbols *words);
intrinsic_list intrinsic_vector_rows(void);
intrinsic_list intrinsic_string_rows(void);
intrinsic_list intrinsic_object_rows(void);

#endif
