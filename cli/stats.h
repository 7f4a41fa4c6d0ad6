/* stats.h - costs and counts of a run: one "name: value unit" a line. */
#ifndef CLI_STATS_H
#define CLI_STATS_H

#include "args.h"

#include <stdio.h>

typedef struct stats {
    const args *args;
    pov_context *context;
    const pov_scene *scene;
    const pov_progress *progress;   /* NULL: nothing was rendered */
    pov_job *job;                   /* the same */
    double write_seconds;
    unsigned warnings;
} stats;

void stats_print(FILE *to, const stats *s);

#endif
