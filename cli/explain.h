/* explain.h - prints the parts compiled for a scene, and the parts left out, as a table. */
#ifndef CLI_EXPLAIN_H
#define CLI_EXPLAIN_H

#include <povtrace/povtrace.h>

#include <stdio.h>

/* The scene's plan, and the plugins that other parts of the program use. */
void explain_print(FILE *to, pov_context *context, const pov_scene *scene);

#endif
