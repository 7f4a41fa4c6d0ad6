/* builder.h - the parts of a program of calc.h while it is compiled: registers, steps, and the tokens it is made of. */
#ifndef SDL_BUILDER_H
#define SDL_BUILDER_H

#include "sdl/calc.h"
#include "sdl/macro.h"

enum {
    BUILDER_NAMES = 24, BUILDER_STEPS = 200, BUILDER_ROWS = 64, BUILDER_DEEPEST = 50, BUILDER_STREAMS = 6,
    BUILDER_LOCALS = 32
};

typedef struct term {
    value_kind kind;
    bool is_colour, is_part;
    int size;
    uint16_t reg[CALC_COMPONENTS];   /* of a value's five numbers, as expressions read from tokens would leave them */
} term;

/* Tokens of the expression, and those of the bodies of macros that it calls. */
typedef struct stream {
    const token *tokens;
    size_t at, end;
    int locals;                  /* how many there were before it */
    int parameters;              /* and with its parameters */
} stream;

/* A parameter of a macro, or what its #local makes: no binding is made of it. */
typedef struct local { const symbol *name; term term; } local;

typedef struct builder {
    pov_reader *in;
    stream streams[BUILDER_STREAMS], *s;
    local local[BUILDER_LOCALS];
    int locals;
    bool is_refused;
    int depth, randoms;
    uint16_t next;               /* register */
    calc calc;
    double constant[CALC_CONSTANTS];
    calc_name name[BUILDER_NAMES];
    calc_step step[BUILDER_STEPS];
    const intrinsic *row[BUILDER_ROWS];
} builder;

/* From here on nothing is compiled; returns the number 0. */
term builder_refuse(builder *b);
uint16_t builder_registers(builder *b, int count);
/* The register of a constant; 0 is 0. */
uint16_t builder_constant(builder *b, double number);
uint16_t builder_row(builder *b, const intrinsic *row);
/* One step more. The second one finds a register for its result. */
void builder_emit_to(builder *b, calc_op op, uint16_t to, uint16_t a, uint16_t second, uint16_t c);
uint16_t builder_emit(builder *b, calc_op op, uint16_t a, uint16_t second, uint16_t c);
term builder_number_in(uint16_t reg);
/* A vector whose first `kept` numbers stand in registers in a row; behind them are zeros. */
term builder_vector_in(uint16_t first, int size, bool is_colour, int kept);

/* The next token, in a macro's body or behind it; that which stands further on in the same text. */
const token *builder_next(builder *b);
const token *builder_peek(builder *b, size_t ahead);
bool builder_is_next(builder *b, int kind);
bool builder_accept(builder *b, int kind);
void builder_expect(builder *b, int kind);

uint16_t builder_to_number(builder *b, term t);
uint16_t builder_number(builder *b);
/* Three registers in a row. */
uint16_t builder_vector(builder *b);

/* The grammars of expression.h. */
term builder_operand(builder *b);
term builder_additive(builder *b);
term builder_full(builder *b);

/* The index of a name of the program, loaded if it is a number or a vector. */
uint16_t builder_name(builder *b, calc_name n);
/* A function of the language, whose name has been taken. */
term builder_function(builder *b, const intrinsic *row);

/* ---- macros whose bodies are values, behind #locals or not ---- */

/* The parameter or #local of that name, or NULL. */
const local *builder_find_local(const builder *b, const symbol *name);
/* `#local NAME = E;` is next in a macro's body. */
void builder_local(builder *b);
/* The macro's name has been taken: its value. */
term builder_insert(builder *b, symbol *name, macro *m);

#endif
