#include "plots.h"
#include "report.h"
#include "save.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 820, HEIGHT = 540, HEIGHT_OF_SECOND = 200 };

/* Columns of the rows; unknown values are NaN, which plots omit. */
typedef struct columns { double *wall, *cpu, *estimate, *low, *high, *truth, *ratio, *all; } columns;

static bool make_columns(columns *c, const report *r)
{
    size_t n = r->count > 0 ? r->count : 1;

    c->all = malloc(7 * n * sizeof *c->all);
    if (!c->all)
        return false;
    c->wall = c->all;
    c->cpu = c->all + n;
    c->estimate = c->all + 2 * n;
    c->low = c->all + 3 * n;
    c->high = c->all + 4 * n;
    c->truth = c->all + 5 * n;
    c->ratio = c->all + 6 * n;
    for (size_t i = 0; i < r->count; i++) {
        const pov_pass *p = &r->rows[i];
        report_figures f = report_figures_of(p, NULL);

        c->wall[i] = p->wall_s;
        c->cpu[i] = p->cpu_s;
        c->estimate[i] = p->est_rmse > 0.0 ? p->est_rmse : NAN;
        c->low[i] = p->est_ci95_lo > 0.0 ? p->est_ci95_lo : NAN;
        c->high[i] = p->est_ci95_hi > 0.0 ? p->est_ci95_hi : NAN;
        c->truth[i] = p->ref_rmse > 0.0 ? p->ref_rmse : NAN;
        c->ratio[i] = f.est_over_true > 0.0 ? f.est_over_true : NAN;
    }
    return true;
}

static bool has_reference(const report *r)
{
    return r->count > 0 && r->rows[r->count - 1].ref_rmse >= 0.0;
}

static pov_panel error_panel(const report *r, const columns *c, pov_series series[3], pov_level levels[2])
{
    const char *by_wall = "estimated, 95 % band, by wall time", *by_cpu = "estimated, 95 % band, by processor time";
    pov_panel p = { .x = { "seconds", true, 0.0, 0.0 }, .y = { "rms error, linear light", true, 0.0, 0.0 } };

    p.series = series;
    series[p.series_count++] = (pov_series){ by_wall, r->count, c->wall, c->estimate, c->low, c->high, false };
    if (has_reference(r))
        series[p.series_count++] =
            (pov_series){ "true, against the reference, by wall time", r->count, c->wall, c->truth, NULL, NULL, false };
    series[p.series_count++] = (pov_series){ by_cpu, r->count, c->cpu, c->estimate, c->low, c->high, true };
    p.levels = levels;
    if (r->args->error > 0.0)
        levels[p.level_count++] = (pov_level){ "asked error", r->args->error, false };
    if (r->args->time > 0.0)
        levels[p.level_count++] = (pov_level){ "time limit", r->args->time, true };
    p.guide = "slope \xe2\x88\x92\xc2\xbd";
    p.slope = -0.5;
    p.share = 3.0;
    return p;
}

/* Both panels show the same time. */
static void find_span(const report *r, const columns *c, pov_axis *x)
{
    double least = HUGE_VAL, most = 0.0;

    for (size_t i = 0; i < r->count; i++) {
        least = fmin(least, c->wall[i]);
        most = fmax(most, c->wall[i]);
        if (c->estimate[i] > 0.0 && c->cpu[i] > 0.0) {
            least = fmin(least, c->cpu[i]);
            most = fmax(most, c->cpu[i]);
        }
    }
    most = fmax(most, r->args->time);
    if (least > 0.0 && least < most) {
        x->least = least / 1.2;
        x->most = most * 1.2;
    }
}

static pov_panel ratio_panel(const report *r, const columns *c, pov_series *series, pov_level levels[3])
{
    pov_panel p = { .x = { "seconds", true, 0.0, 0.0 }, .y = { "estimated / true", false, 0.0, 0.0 } };

    *series = (pov_series){ NULL, r->count, c->wall, c->ratio, NULL, NULL, false };
    levels[0] = (pov_level){ "0.85", 0.85, false };
    levels[1] = (pov_level){ "1", 1.0, false };
    levels[2] = (pov_level){ "1.18", 1.18, false };
    p.y.least = 0.7;
    p.y.most = 1.35;
    for (size_t i = 0; i < r->count; i++)
        if (c->ratio[i] > 0.0) {
            p.y.least = fmin(p.y.least, 0.95 * c->ratio[i]);
            p.y.most = fmax(p.y.most, 1.05 * c->ratio[i]);
        }
    p.series = series;
    p.series_count = 1;
    p.levels = levels;
    p.level_count = 3;
    p.share = 1.0;
    return p;
}

static void make_note(const report *r, char *note, size_t size)
{
    const pov_pass *last = r->count > 0 ? &r->rows[r->count - 1] : NULL;

    if (last)
        snprintf(note, size, "%d \xc3\x97 %d pixels, %.1f samples a pixel, %d thread%s, %.2f s; ended by: %s", r->width,
                 r->height, last->spp_mean, last->threads, last->threads == 1 ? "" : "s", last->wall_s, report_stop(r));
    else
        snprintf(note, size, "no pass was completed");
}

pov_status report_put_plot(const report *r, const char *ending, FILE *to, pov_error *err)
{
    const char *slash = strrchr(r->args->scene, '/');
    char title[256], note[256];
    pov_plot plot = POV_INIT(plot);
    pov_series series[3], ratio;
    pov_level levels[2], bounds[3];
    pov_panel panels[2];
    columns c;
    pov_status status;

    if (!make_columns(&c, r))
        return save_fail(err, POV_E_MEMORY, r->args->report, "out of memory for the report");
    snprintf(title, sizeof title, "Error against run time: %s", slash ? slash + 1 : r->args->scene);
    make_note(r, note, sizeof note);
    plot.width = WIDTH;
    plot.height = HEIGHT + (has_reference(r) ? HEIGHT_OF_SECOND : 0);
    plot.title = title;
    plot.note = note;
    plot.panels = panels;
    plot.panel_count = has_reference(r) ? 2 : 1;
    panels[0] = error_panel(r, &c, series, levels);
    if (has_reference(r)) {
        panels[1] = ratio_panel(r, &c, &ratio, bounds);
        find_span(r, &c, &panels[1].x);
    }
    find_span(r, &c, &panels[0].x);
    status = plots_put(r->context, ending, &plot, to, err);
    free(c.all);
    return status;
}
