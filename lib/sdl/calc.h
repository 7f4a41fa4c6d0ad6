/* calc.h - expressions of kept tokens, compiled: what a loop or a macro reads again is computed.
 *
 * An expression of numbers, vectors, names of these, elements of arrays, formulas and functions of the language
 * becomes a register program of doubles when it is met for the second time. Macros whose bodies are such values become
 * parts of it. It holds while its names lead to values of the kinds that they had then. Where they do not, and wherever the expression would warn or fail, nothing has happened, and it
 * is read from its tokens as ever. */
#ifndef SDL_CALC_H
#define SDL_CALC_H

#include "sdl/intrinsic.h"

enum {
    CALC_CONSTANTS = 64,         /* their registers come first; register 0 is 0 */
    CALC_REGISTERS = 320, CALC_COMPONENTS = 5,
    CALC_ARGUMENTS = 256,        /* registers of a function */
    CALC_RANDOMS = 8
};

typedef enum calc_op {
    CALC_COPY,
    CALC_ADD, CALC_SUBTRACT, CALC_MULTIPLY, CALC_DIVIDE,
    CALC_BELOW, CALC_ABOVE, CALC_AT_MOST, CALC_AT_LEAST, CALC_EQUAL, CALC_UNEQUAL, CALC_AND, CALC_OR,
    CALC_NEGATE, CALC_TRUE, CALC_NOT,
    CALC_SAME,                   /* to = a == b, exactly */
    CALC_PICK,                   /* to = a is true ? b : c; a is 0 or 1 */
    CALC_GRAY,                   /* to = gray of a, b, c */
    CALC_ONE, CALC_TWO,          /* to = rows[c](a[, b]) */
    CALC_CUT,                    /* to = a as an integer of 32 bits */
    CALC_ARC, CALC_LOGARITHM, CALC_ROOT, CALC_ATAN2, CALC_POW,
    CALC_RAND,
    CALC_SUBSCRIPT,              /* to = the index of an element of names[b] so far, with a as subscript c */
    CALC_ELEMENT,                /* to and on = element a of names[b] */
    CALC_ARGUMENT,               /* arguments[b] = a */
    CALC_CALL,                   /* to = names[b] of the arguments */
    CALC_VLENGTH, CALC_VDOT,     /* to = of the vectors at a[, b] */
    CALC_VCROSS, CALC_VNORMALIZE /* to and on */
} calc_op;

typedef struct calc_step { uint16_t op, to, a, b, c; } calc_step;

/* A name and what it must lead to. */
typedef struct calc_name {
    symbol *symbol;
    value_kind kind;
    bool is_colour;
    uint16_t to;                 /* where the components go */
    int size;                    /* of a vector, or of an array's elements; an array's dimensions stand in `to` */
    const void *part;            /* of a function; a macro, whose number stands in `size` */
} calc_name;

typedef struct calc {
    replay head;
    size_t end;                  /* the token behind the expression */
    value_kind kind;             /* of the result */
    bool is_colour, is_part, is_random;
    int size;
    uint16_t result[CALC_COMPONENTS];
    uint16_t names, constants, steps, rows;
    unsigned misses;             /* names led elsewhere */
    const double *constant;
    const calc_name *name;
    const calc_step *step;
    const intrinsic *const *row;
} calc;

/* The program of the expression that begins at the index-th token of the buffer. NULL: it is none that is compiled. */
calc *calc_compile(pov_reader *in, token_buffer *b, size_t index, replay_kind grammar);
/* The result in registers. False: nothing happened. calc_try() compiles anew what holds no more. */
bool calc_run(pov_reader *in, calc *c, double r[CALC_REGISTERS]);
bool calc_try(pov_reader *in, token_buffer *b, size_t index, calc *c, double r[CALC_REGISTERS]);
value calc_value(const calc *c, const double r[CALC_REGISTERS]);
/* The program that is kept of the index-th token, if it is worth one by now. NULL: there is none. */
calc *calc_at(pov_reader *in, token_buffer *b, size_t index, replay_kind grammar);
/* The expression from the next token on, if it is compiled: its value, and it has been taken. */
bool calc_read(pov_reader *in, replay_kind grammar, value *out);
/* Is the next token, of kept ones, an argument by itself: is a comma or a parenthesis behind it? */
bool calc_is_argument(const pov_reader *in);
/* The index in its buffer of the token that is next. False: it comes from a text. */
bool calc_index(const pov_reader *in, size_t *index);

#endif
