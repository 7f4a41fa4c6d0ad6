#include "compare.h"
#include "plots.h"
#include "save.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { RUNS_MAX = 16, LINE_MAX_BYTES = 4096, WIDTH = 820, HEIGHT = 580 };

/* One report's columns. */
typedef struct run {
    char name[128];
    size_t count, capacity;
    double *time, *error, *low, *high;
} run;

/* ---- reading ---- */

/* Column of a word in a comma separated line; -1: missing. */
static int column_of(const char *line, const char *word)
{
    size_t length = strlen(word);

    for (int i = 0; line; i++) {
        if (strncmp(line, word, length) == 0 && (line[length] == ',' || line[length] == '\0'))
            return i;
        line = strchr(line, ',');
        line = line ? line + 1 : NULL;
    }
    return -1;
}

/* NaN: the field is empty. */
static double number_at(const char *line, int column)
{
    char *end;
    double value;

    for (; line && column > 0; column--) {
        line = strchr(line, ',');
        line = line ? line + 1 : NULL;
    }
    if (!line || column < 0)
        return NAN;
    value = strtod(line, &end);
    return end == line || (*end != ',' && *end != '\0') ? NAN : value;
}

typedef struct columns { int time, estimate, low, high; } columns;

static bool find_columns(const char *line, columns *c)
{
    c->time = column_of(line, "wall_s");
    c->estimate = column_of(line, "est_rmse");
    c->low = column_of(line, "est_ci95_lo");
    c->high = column_of(line, "est_ci95_hi");
    return c->time >= 0 && c->estimate >= 0;
}

static bool add_row(run *r, const char *line, const columns *c)
{
    double **lists[4] = { &r->time, &r->error, &r->low, &r->high };
    const int from[4] = { c->time, c->estimate, c->low, c->high };

    if (r->count == r->capacity) {
        r->capacity = r->capacity ? 2 * r->capacity : 32;
        for (int i = 0; i < 4; i++) {
            double *grown = realloc(*lists[i], r->capacity * sizeof *grown);

            if (!grown)
                return false;
            *lists[i] = grown;
        }
    }
    for (int i = 0; i < 4; i++)
        (*lists[i])[r->count] = number_at(line, from[i]);
    r->count++;
    return true;
}

static void name_run(run *r, const char *path)
{
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path, *dot = strrchr(name, '.');

    snprintf(r->name, sizeof r->name, "%.*s", dot ? (int)(dot - name) : (int)strlen(name), name);
}

static bool read_line(FILE *from, char *line)
{
    if (!fgets(line, LINE_MAX_BYTES, from))
        return false;
    line[strcspn(line, "\r\n")] = '\0';
    return true;
}

static pov_status read_run(run *r, const char *path, pov_error *err)
{
    char line[LINE_MAX_BYTES], text[160];
    FILE *from = fopen(path, "r");
    columns c;
    bool known, room = true;

    if (!from) {
        snprintf(text, sizeof text, "cannot open: %s", strerror(errno));
        return save_fail(err, POV_E_IO, path, text);
    }
    name_run(r, path);
    known = read_line(from, line) && find_columns(line, &c);
    while (known && room && read_line(from, line))
        room = add_row(r, line, &c);
    fclose(from);
    if (!known)
        return save_fail(err, POV_E_ARGUMENT, path, "this is no report of --report in .csv: it has no columns wall_s and est_rmse");
    return room ? POV_OK : save_fail(err, POV_E_MEMORY, path, "out of memory for this report");
}

/* ---- drawing ---- */

static pov_status draw(pov_context *context, const run *runs, size_t count, const char *ending, FILE *to, pov_error *err)
{
    pov_series series[RUNS_MAX];
    pov_plot plot = POV_INIT(plot);
    pov_panel panel = { .x = { "wall time, seconds", true, 0.0, 0.0 }, .y = { "estimated rms error, linear light", true, 0.0, 0.0 } };

    for (size_t i = 0; i < count; i++)
        series[i] = (pov_series){ runs[i].name, runs[i].count, runs[i].time, runs[i].error, runs[i].low, runs[i].high, false };
    panel.series = series;
    panel.series_count = count;
    panel.guide = "slope \xe2\x88\x92\xc2\xbd";
    panel.slope = -0.5;
    plot.width = WIDTH;
    plot.height = HEIGHT;
    plot.title = "Work and precision";
    plot.note = "each point is the end of a pass; bands hold the true error in 95 of 100 cases";
    plot.panels = &panel;
    plot.panel_count = 1;
    return plots_put(context, ending, &plot, to, err);
}

static const char *ending_of(const char *path)
{
    const char *dot = strrchr(path, '.');

    return dot && (strcmp(dot, ".svg") == 0 || strcmp(dot, ".png") == 0) ? dot + 1 : NULL;
}

static pov_status draw_file(pov_context *context, const run *runs, size_t count, const char *path, pov_error *err)
{
    char *bytes = NULL;
    size_t length = 0;
    FILE *to = open_memstream(&bytes, &length);
    pov_status status;

    if (!to)
        return save_fail(err, POV_E_MEMORY, path, "out of memory for the plot");
    status = draw(context, runs, count, ending_of(path), to, err);
    if (fclose(to) != 0 && status == POV_OK)
        status = save_fail(err, POV_E_MEMORY, path, "out of memory for the plot");
    if (status == POV_OK)
        status = pov_file_write(context, path, bytes, length, err);
    free(bytes);
    return status;
}

static void free_run(run *r)
{
    free(r->time);
    free(r->error);
    free(r->low);
    free(r->high);
}

pov_status compare_run(const args *a, pov_error *err)
{
    size_t count = (size_t)a->compared_count - 1;
    const char *path = a->compared[count];
    pov_context_desc desc = POV_INIT(desc);
    pov_context *context = NULL;
    run runs[RUNS_MAX] = { { .count = 0 } };
    pov_status status = POV_OK;

    if (!ending_of(path))
        return save_fail(err, POV_E_ARGUMENT, path, "the last name is the plot's, and ends with .svg or .png");
    if (count > RUNS_MAX)
        return save_fail(err, POV_E_ARGUMENT, "", "no more than 16 reports can be told apart in one plot");
    for (size_t i = 0; i < count && status == POV_OK; i++)
        status = read_run(&runs[i], a->compared[i], err);
    desc.plugin_path = a->plugin_path;
    if (status == POV_OK)
        status = pov_context_create(&context, &desc, err);
    if (status == POV_OK)
        status = draw_file(context, runs, count, path, err);
    pov_context_destroy(context);
    for (size_t i = 0; i < count; i++)
        free_run(&runs[i]);
    return status;
}
