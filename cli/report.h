/* report.h - error against run time: one row a pass, as a table, a plot, or a page with everything. */
#ifndef CLI_REPORT_H
#define CLI_REPORT_H

#include "args.h"
#include "messages.h"

#include <stdio.h>

typedef struct report {
    const args *args;
    const messages *messages;
    pov_context *context;
    const pov_scene *scene;
    pov_job *job;
    const pov_progress *progress;   /* at the end */
    double write_seconds;
    const float *pixels;         /* the picture, linear, four channels */
    int width, height;           /* of it */
    pov_image_options options;   /* encoding of the file */
    pov_pass *rows;
    size_t count;
} report;

/* Can it be written, as far as this is known before the work? Finds the plugin for plots, if one is needed. */
pov_status report_check(pov_context *context, const args *a, pov_error *err);
/* `r` has all but the rows. */
pov_status report_write(report *r, pov_error *err);

/* The last pass that ended; false: none has. */
bool report_last_pass(pov_job *job, pov_pass *out);

/* ---- for the files that write one form each ---- */

/* Values derived from a row and the one before it (NULL: none). Below zero, and NaN for the slope: not known. */
typedef struct report_figures { double est_over_true, efficiency, slope; } report_figures;
report_figures report_figures_of(const pov_pass *row, const pov_pass *before);
/* The end of the job in words. */
const char *report_stop(const report *r);

void report_put_csv(const report *r, FILE *to);
void report_put_json(const report *r, FILE *to);
pov_status report_put_html(const report *r, FILE *to, pov_error *err);
pov_status report_put_plot(const report *r, const char *ending, FILE *to, pov_error *err);

#endif
