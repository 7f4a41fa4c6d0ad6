/* compare.h - the curves of several runs in one diagram. */
#ifndef CLI_COMPARE_H
#define CLI_COMPARE_H

#include "args.h"

/* Compare the reports in a->compared: all but the last are .csv files; the last is the plot to write. */
pov_status compare_run(const args *a, pov_error *err);

#endif
