/* expression.h - the two grammars of expressions. The additive one has + - * / signs, dots, calls and parentheses; the
 * full one, which stands between parentheses only, has comparisons, & | and ?: as well.
 *
 * What is returned is the caller's to drop. After an error it is the number 0. */
#ifndef SDL_EXPRESSION_H
#define SDL_EXPRESSION_H

#include "sdl/intrinsic.h"

/* What lies within this of another number is equal to it; what lies within it of 0 is false. */
#define EXPRESSION_NEAR 1e-10

value expression_read(pov_reader *in);
value expression_full(pov_reader *in);
/* One operand, with its signs and dots. */
value expression_operand(pov_reader *in);
/* An operand has been read: what stands behind it. */
value expression_go_on(pov_reader *in, value operand);
/* A minus has been taken: what stands behind it. */
value expression_negative(pov_reader *in);
/* Subscripts behind an array, any number of them: the element's slot, which `lender` keeps. The lender is counted for
 * the caller, before and after. */
value *expression_element(pov_reader *in, value *slot, shared **lender);
/* A value that is a function or spline, and its arguments if they are next. */
value expression_call(pov_reader *in, value callee);
/* Which component the word behind a dot names: an index, or EXPRESSION_GRAY. -1: none. */
enum { EXPRESSION_GRAY = 5, EXPRESSION_HEIGHT = 6 };   /* as the pixel of a height_field's image; behind functions of pigments */
int expression_component(keyword_id word);
/* That component. Gray is POV-Ray's: 0.297 red + 0.589 green + 0.114 blue. */
double expression_part(const double v[5], int component);
/* Is the token one that goes on with an operand? */
bool expression_goes_on(const pov_reader *in);

/* Numbers as they are, infinite ones too. */
double expression_number(pov_reader *in);
double expression_full_number(pov_reader *in);
bool expression_condition(pov_reader *in);
pov_vec3 expression_vector(pov_reader *in);
/* A number cut to an integer of 32 bits: what does not fit is the least one. */
int32_t expression_integer(double number);
/* Drops the value; fails if it is none. */
double expression_to_number(pov_reader *in, value v);
bool expression_to_vector(pov_reader *in, value *v);
string *expression_to_string(pov_reader *in, value v);

static inline bool expression_is_true(double number) { return fabs(number) > EXPRESSION_NEAR; }

#endif
