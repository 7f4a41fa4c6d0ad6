/* tape_record.h - recording a tape: steps by their numbers, of which equal ones are one and constants are computed. */
#ifndef FUNCTION_TAPE_RECORD_H
#define FUNCTION_TAPE_RECORD_H

#include "function/tape.h"

typedef struct tape_node tape_node;

typedef struct recorder {
    const env *env;
    struct node_list { tape_node *items; size_t count, capacity; } nodes;
    uint32_t turns;              /* instructions that were run */
    tape_outcome outcome;
} recorder;

void record_give_up(recorder *r, tape_outcome why);
/* Is a value known? */
bool record_constant_of(const recorder *r, uint32_t a, double *out);
uint32_t record_constant(recorder *r, double k);
/* `op`: one of + - * / */
uint32_t record_arithmetic(recorder *r, char op, uint32_t a, uint32_t b);
/* By the names of formulas; false: there is no such function of one or of two arguments. */
uint32_t record_one(recorder *r, const char *name, uint32_t a);
uint32_t record_two(recorder *r, const char *name, uint32_t a, uint32_t b);
/* A step of other kinds. */
uint32_t record_step(recorder *r, tape_op op, uint32_t a, uint32_t b, uint32_t c);
/* a < 0 ? b : c, a == 0 ? b : c. */
uint32_t record_choice(recorder *r, tape_op op, uint32_t a, uint32_t b, uint32_t c);

/* internal(number) of arguments that stand in a row. */
uint32_t tape_text_internal(recorder *r, uint32_t number, const uint32_t *arguments);

#endif
