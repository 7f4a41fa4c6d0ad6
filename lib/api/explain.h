/* explain.h - what is told of a scene besides what its world was compiled of. */
#ifndef API_EXPLAIN_H
#define API_EXPLAIN_H

#include "model/model.h"
#include "plug/registry.h"
#include "world/plan.h"

/* Rows on the primitives' plugins: which the scene uses, and which it had no need of. */
pov_status explain_plugins(plan *p, const model *m, const registry *plugins, pov_error *err);

#endif
