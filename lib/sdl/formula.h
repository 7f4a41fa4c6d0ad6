/* formula.h - the grammar of formulas, which is not that of expressions: comparisons bind tighter than &, & tighter than
 * |, there is no ! and no ?, and only numbers. */
#ifndef SDL_FORMULA_H
#define SDL_FORMULA_H

#include "function/program.h"
#include "sdl/state.h"

/* A formula of these parameters, up to what cannot go on with it. False: the reader has failed. */
bool formula_compile(pov_reader *in, symbol *const *parameters, uint32_t count, program *out);
/* internal(N), whose number has been read. */
bool formula_internal(pov_reader *in, uint32_t number, program *out);

#endif
