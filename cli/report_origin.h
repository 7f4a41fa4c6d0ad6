/* report_origin.h - version, command, date, processor, seed and sampling of a run, for those who repeat it. */
#ifndef CLI_REPORT_ORIGIN_H
#define CLI_REPORT_ORIGIN_H

#include "report.h"

typedef struct report_origin {
    const char *command, *sampling;
    int seed;
    char version[32], date[32], processor[128];
} report_origin;

void report_find_origin(const report *r, report_origin *out);

#endif
