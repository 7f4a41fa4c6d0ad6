/* explain.h - what was compiled for a scene, and what was left out, as a table. */
#ifndef CLI_EXPLAIN_H
#define CLI_EXPLAIN_H

#include <povtrace/povtrace.h>

#include <stdio.h>

void explain_print(FILE *to, const pov_scene *scene);

#endif
