/* povtrace/plot.h - curves in panels, to a file or a program's own output. Each format is a plugin in plots/, loaded at
 * first use, so a program without plots never loads a drawing library. */
#ifndef POVTRACE_PLOT_H
#define POVTRACE_PLOT_H

#include <povtrace/image.h>

/* Texts are UTF-8. Values that an axis cannot show are left out: on a logarithmic axis, those not above 0. */
typedef struct pov_axis { const char *title; bool logarithmic; double least, most; } pov_axis;   /* 0, 0: as the data */
/* A curve with a mark at each point, and a band around it; thin: a line without marks. */
typedef struct pov_series {
    const char *name;
    size_t count;
    const double *x, *y, *low, *high;   /* low and high may be NULL */
    bool thin;
} pov_series;
/* A straight line across the panel, named at its end. */
typedef struct pov_level { const char *name; double at; bool vertical; } pov_level;
typedef struct pov_panel {
    pov_axis x, y;
    const pov_series *series;
    const pov_level *levels;
    size_t series_count, level_count;
    const char *guide;           /* NULL, or the name of a guide line of `slope` (of the logarithms) above the first
                                  * curve */
    double slope;
    double share;                /* of the height */
} pov_panel;
typedef struct pov_plot {
    size_t size;
    int width, height;           /* points of 1/72 inch in SVG, pixels in PNG */
    const char *title, *note;    /* above the panels; the note is smaller */
    const pov_panel *panels;     /* from the top down */
    size_t panel_count;
} pov_plot;

/* The ending names the format: "svg" or "png". */
POV_API pov_status pov_plot_put(struct pov_context *context, const char *ending, const pov_plot *plot,
                                const pov_output *output, pov_error *err);
/* Is there a plugin for the ending? Loads it. A program may ask before it works. */
POV_API pov_status pov_plot_check(struct pov_context *context, const char *ending, pov_error *err);

/* ---- a format, for plugins: see plugin.h --------------------------------- */

typedef struct pov_plot_format {
    uint32_t size;
    const char *ending;          /* "svg" */
    /* Any thread. NULL when all was put, else what went wrong, static text. Stop when put says false. */
    const char *(*draw)(const pov_plot *plot, const pov_output *output);
} pov_plot_format;

#endif
