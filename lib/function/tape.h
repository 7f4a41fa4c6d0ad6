/* tape.h - a function as a tape: steps in a row without jumps, calls and repetitions.
 *
 * A tape is recorded by running the register program once on names in place of numbers. What does not depend on the
 * arguments becomes a constant, calls and sums are written out, and equal steps are one. So it can be run on more than
 * doubles: on bounds over stretches (form.h), and on values with derivatives (slope.h). */
#ifndef FUNCTION_TAPE_H
#define FUNCTION_TAPE_H

#include "function/program.h"

typedef enum tape_op {
    TAPE_CONSTANT,               /* to = k */
    TAPE_ADD, TAPE_SUBTRACT, TAPE_MULTIPLY, TAPE_DIVIDE,   /* of a and b */
    TAPE_OFFSET, TAPE_SCALE,     /* a + k, a k */
    TAPE_ABS, TAPE_MIN, TAPE_MAX, TAPE_MOD,
    TAPE_SQRT, TAPE_POWER,       /* TAPE_POWER: a^k, k no small whole number */
    TAPE_SIN, TAPE_COS, TAPE_EXP, TAPE_LN, TAPE_ASIN, TAPE_ATAN, TAPE_ASINH, TAPE_ATAN2,
    TAPE_FLOOR, TAPE_CEIL, TAPE_CUT,
    TAPE_LESS, TAPE_AT_MOST, TAPE_EQUAL, TAPE_AND, TAPE_OR,
    TAPE_BELOW, TAPE_ZERO,       /* a < 0 ? b : c, a == 0 ? b : c */
    TAPE_HEX_ALONG, TAPE_HEX_ACROSS      /* internal_hexagon() of a and b */
} tape_op;

/* Registers of the arguments come first; `to` is none of the operands. */
typedef struct tape_step {
    uint16_t op, to, a, b, c;
    uint16_t is_positive;        /* a is known to be 0 at least */
    double k;
} tape_step;

typedef struct tape {
    uint32_t parameters, registers, result, count;
    const tape_step *steps;
} tape;

/* TAPE_NONE: the function asks a host, or repeats something as often as its arguments say, or is far too long. */
typedef enum tape_outcome { TAPE_RECORDED, TAPE_NONE, TAPE_NO_MEMORY } tape_outcome;

/* The steps are from env_alloc(). */
tape_outcome tape_record(const env *e, const program *p, tape *out);

#endif
