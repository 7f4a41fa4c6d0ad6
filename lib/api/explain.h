/* explain.h - rows of --explain: parts that a scene needs, and parts that are left out. */
#ifndef API_EXPLAIN_H
#define API_EXPLAIN_H

#include "model/model.h"
#include "plug/registry.h"
#include "world/world.h"

typedef struct explain_row { bool used; const char *subject, *state, *reason; } explain_row;
typedef struct explain_row_list { explain_row *items; size_t count, capacity; } explain_row_list;

typedef struct explanation {
    explain_row_list rows;
    arena memory;                /* of their texts */
} explanation;

void explain_init(explanation *e, const env *from);
void explain_free(explanation *e);
/* Rows on the plan of the world, its objects and its tree. */
pov_status explain_world(explanation *e, const model *m, const world *w, pov_error *err);
/* Rows on the primitives' plugins: those that the scene uses, and those that it does not need. */
pov_status explain_plugins(explanation *e, const model *m, const registry *plugins, pov_error *err);

#endif
