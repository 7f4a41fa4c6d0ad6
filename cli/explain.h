/* explain.h - what was compiled for a scene, and what was left out, as a table. */
#ifndef CLI_EXPLAIN_H
#define CLI_EXPLAIN_H

#include <povtrace/povtrace.h>

#include <stdio.h>

/* The scene's plan, and the plugins that are in use for something else than the scene. */
void explain_print(FILE *to, pov_context *context, const pov_scene *scene);

#endif
