/* plots.h - a plot to a stream. */
#ifndef CLI_PLOTS_H
#define CLI_PLOTS_H

#include <povtrace/povtrace.h>

#include <stdio.h>

pov_status plots_put(pov_context *context, const char *ending, const pov_plot *plot, FILE *to, pov_error *err);
/* For outputs of pov_image_put() and pov_plot_put(): user is a FILE. */
bool plots_put_bytes(void *user, const void *bytes, size_t count);

#endif
