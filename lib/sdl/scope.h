/* scope.h - which value a name has: one global scope, and one for each macro and include file that runs. */
#ifndef SDL_SCOPE_H
#define SDL_SCOPE_H

#include "sdl/tokens.h"
#include "sdl/value.h"

/* A value under a name. Inner bindings hide outer ones; a macro's parameter may lead to what its caller named. */
typedef struct binding {
    shared head;
    symbol *symbol;
    struct binding *outer;       /* of the same name */
    struct binding *next, *previous;   /* of the same scope */
    size_t level;                /* of its scope; the global one is 0 */
    value *slot;                 /* own, or that of the lender */
    shared *lender;              /* a binding or an array; NULL: the value is own */
    value own;
} binding;

typedef struct scope { binding *first; } scope;
typedef struct scope_list { scope *items; size_t count, capacity; } scope_list;

/* The value that a name leads to, or NULL. */
static inline value *scope_value(const symbol *name) { return name->binding ? name->binding->slot : NULL; }

bool scope_push(pov_reader *in);
void scope_pop(pov_reader *in);
/* Give the name a value, which is the scope's from here on: #declare changes the innermost binding of that name, or
 * makes a global one; #local changes or makes one at `level`. */
void scope_declare(pov_reader *in, symbol *name, value v);
void scope_local(pov_reader *in, symbol *name, size_t level, value v);
/* Let the name lead to a value that a binding or an array keeps. */
void scope_lend(pov_reader *in, symbol *name, value *slot, shared *lender);
/* Forget the innermost binding. */
void scope_forget(pov_reader *in, symbol *name);

#endif
