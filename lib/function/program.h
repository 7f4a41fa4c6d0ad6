/* program.h - function { } compiled to a register program.
 *
 * A register holds a double. Those of the parameters come first; the arguments of a call stand in registers in a row. All
 * arithmetic is plain C: what has no value is infinite or NaN, and nothing is reported. */
#ifndef FUNCTION_PROGRAM_H
#define FUNCTION_PROGRAM_H

#include "base/env.h"

typedef enum program_op {
    PROGRAM_CONSTANT,            /* to = constants[a] */
    PROGRAM_COPY,                /* to = a */
    PROGRAM_ADD, PROGRAM_SUBTRACT, PROGRAM_MULTIPLY, PROGRAM_DIVIDE, PROGRAM_NEGATE,
    PROGRAM_LESS, PROGRAM_AT_MOST, PROGRAM_EQUAL, PROGRAM_UNEQUAL, PROGRAM_AND, PROGRAM_OR,
    PROGRAM_ONE,                 /* to = one_argument(b)(a) */
    PROGRAM_TWO,                 /* to = two_arguments(c)(a, b) */
    PROGRAM_SELECT,              /* to = select(a, a + 1, a + 2[, a + 3]), b of them */
    PROGRAM_INTERNAL,            /* to = internal(b) of the registers from a on */
    PROGRAM_HOST,                /* to = part c of hosts[b] of the registers from a on */
    PROGRAM_CALL,                /* to = callees[b] of the registers from a on */
    PROGRAM_JUMP_ABOVE,          /* to the instruction `to` unless a <= b */
    PROGRAM_JUMP_WITHIN          /* to the instruction `to` if a <= b */
} program_op;

typedef struct instruction { uint16_t op, c; uint32_t to, a, b; } instruction;

/* Several runs go side by side: argument or register a of lane i is at [a * PROGRAM_LANES + i]. */
enum { PROGRAM_LANES = 16 };

/* What others compute: noise, patterns, pigments. Any thread may ask. */
typedef struct program_host {
    double (*value)(const void *self, const double *arguments, uint32_t part);
    /* Of the first n lanes, with the same bits; may be NULL. memo: as program_run_many() was given it. */
    void (*values)(const void *self, const double *arguments, uint32_t part, uint32_t n, void *memo, double *out);
    const void *self;
    uint32_t arguments;
} program_host;

/* Plain data, in one owner's memory. */
typedef struct program {
    uint32_t parameters, registers;
    uint32_t capacity;               /* registers that a run needs, with those of what it calls */
    uint32_t result;             /* the register of the value */
    uint32_t count;
    const instruction *code;
    const double *constants;
    const struct program *const *callees;
    const program_host *hosts;
} program;

/* `registers` has capacity for program->capacity of them; the first hold the arguments. */
double program_run(const program *p, double *registers);

/* The same for n lanes, n up to PROGRAM_LANES, with the same bits. `registers` has room for program_lanes_capacity(); the first hold the
 * arguments of all lanes, of which those from n on may be any numbers. memo: where hosts keep what they were asked, for who runs several
 * programs of the same points; or NULL. */
void program_run_many(const program *p, double *registers, uint32_t n, void *memo, double *out);
static inline size_t program_lanes_capacity(const program *p) { return (PROGRAM_LANES + 1) * (size_t)p->capacity; }

/* The number of a function of one or two arguments; -1: unknown name. */
int program_one_argument(const char *name);
int program_two_arguments(const char *name);
/* And back. */
const char *program_one_name(uint32_t number);
const char *program_two_name(uint32_t number);

#endif
