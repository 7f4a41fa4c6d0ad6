/* long_run.h - for main() of tests that ask as many rays as their command line says. */
#ifndef NUMERICS_LONG_RUN_H
#define NUMERICS_LONG_RUN_H

#include "numerics/real.h"

#include <stdlib.h>

static inline long long_run_rays(int argc, char **argv, long otherwise) { return argc > 1 ? strtol(argv[1], NULL, 10) : otherwise; }

/* The teardown of the group. */
static inline int long_run_end(void **state)
{
    (void)state;
    real_free_all();
    return 0;
}

#endif
