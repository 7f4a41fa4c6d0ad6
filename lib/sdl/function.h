/* function.h - function { }: formulas that a scene declares, compiled, and their values. */
#ifndef SDL_FUNCTION_H
#define SDL_FUNCTION_H

#include "function/program.h"
#include "sdl/parse.h"

/* FORMULA: a number. The others give a vector, a colour or a number of what they hold. */
typedef enum function_kind {
    FUNCTION_FORMULA, FUNCTION_SPLINE, FUNCTION_TRANSFORM, FUNCTION_PIGMENT, FUNCTION_PATTERN
} function_kind;

/* In the scene's memory. */
typedef struct function {
    function_kind kind;
    program program;
    value spline;                /* kept until the reader goes, */
    const struct spline *curve;  /* and a copy that stays */
    pov_affine map;
    const pigment_node *pigment;
    const pattern *pattern;
    const model *model;          /* what they stand in */
} function;

/* `function` has been taken: its parameters and its block. */
value function_read(pov_reader *in);
/* The same, whose parameters are u and v where there are two and it names none. */
value function_read_of(pov_reader *in, uint32_t parameters);
/* `(` is next: as many numbers as the function has parameters. */
value function_call(pov_reader *in, value callee);

#endif
