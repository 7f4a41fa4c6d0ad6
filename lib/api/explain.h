/* explain.h - rows of --explain about parts outside the compiled world. */
#ifndef API_EXPLAIN_H
#define API_EXPLAIN_H

#include "model/model.h"
#include "plug/registry.h"
#include "world/plan.h"

/* Rows on the primitives' plugins: those that the scene uses, and those that it does not need. */
pov_status explain_plugins(plan *p, const model *m, const registry *plugins, pov_error *err);

#endif
