#include "plots.h"
#include "progress.h"
#include "report_origin.h"
#include "save.h"
#include "stats.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- text ---- */

static void put_text(FILE *to, const char *text)
{
    for (; *text; text++) {
        switch (*text) {
        case '<': fputs("&lt;", to); break;
        case '>': fputs("&gt;", to); break;
        case '&': fputs("&amp;", to); break;
        case '"': fputs("&quot;", to); break;
        default: fputc(*text, to);
        }
    }
}

static void put_base64(FILE *to, const unsigned char *bytes, size_t count)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

    for (size_t i = 0; i < count; i += 3) {
        unsigned three = (unsigned)bytes[i] << 16;
        char four[5] = "====";

        if (i + 1 < count)
            three |= (unsigned)bytes[i + 1] << 8;
        if (i + 2 < count)
            three |= bytes[i + 2];
        for (size_t k = 0; k < 4 && i + k <= count; k++)
            four[k] = digits[three >> (18 - 6 * k) & 63u];
        fputs(four, to);
    }
}

/* ---- pictures inside the page ---- */

/* `kind` is the image's class in the page, `what` is its alternative text. */
static pov_status put_image(const report *r, FILE *to, const float *rgba, pov_transfer transfer, const char *kind,
                            const char *what, pov_error *err)
{
    pov_image_options options = POV_INIT(options);
    char *bytes = NULL;
    size_t count = 0;
    FILE *png = open_memstream(&bytes, &count);
    pov_output output = { png, plots_put_bytes };
    pov_status status;

    if (!png)
        return save_fail(err, POV_E_MEMORY, r->args->report, "out of memory for the report");
    options.bits = 8;
    options.transfer = transfer;
    options.format = "png";
    status = pov_image_put(r->context, &output, r->width, r->height, rgba, 4 * sizeof(float) * (size_t)r->width,
                           &options, err);
    if (fclose(png) != 0 && status == POV_OK)
        status = save_fail(err, POV_E_MEMORY, r->args->report, "out of memory for the report");
    if (status == POV_OK) {
        fprintf(to, "<img class=\"%s\" alt=\"%s\" src=\"data:image/png;base64,", kind, what);
        put_base64(to, (const unsigned char *)bytes, count);
        fputs("\">\n", to);
    }
    free(bytes);
    return status;
}

static pov_status put_curve(const report *r, FILE *to, pov_error *err)
{
    char *bytes = NULL;
    size_t count = 0;
    FILE *svg = open_memstream(&bytes, &count);
    pov_status status;

    if (!svg)
        return save_fail(err, POV_E_MEMORY, r->args->report, "out of memory for the report");
    status = report_put_plot(r, "svg", svg, err);
    if (fclose(svg) != 0 && status == POV_OK)
        status = save_fail(err, POV_E_MEMORY, r->args->report, "out of memory for the report");
    if (status == POV_OK) {
        fputs("<img class=\"curve\" alt=\"rms error against time\" src=\"data:image/svg+xml;base64,", to);
        put_base64(to, (const unsigned char *)bytes, count);
        fputs("\">\n", to);
    }
    free(bytes);
    return status;
}

/* Text of a missing value. */
static const float blank = 1.0f;

/* Dark blue to yellow with increasing lightness: readable with colour blindness, and in grey. */
static const float ramp[5][3] = {
    { 0.00f, 0.13f, 0.30f }, { 0.26f, 0.30f, 0.42f }, { 0.48f, 0.48f, 0.47f }, { 0.74f, 0.68f, 0.41f }, { 1.00f, 0.92f, 0.28f },
};

typedef struct span { double low, high; } span;   /* range of a map, both above zero */

/* Two decades below the largest value, or from the smallest one on. */
static span span_of(const float *map, size_t count)
{
    span s = { HUGE_VAL, 0.0 };

    for (size_t i = 0; i < count; i++)
        if (map[i] > 0.0f) {
            s.low = fmin(s.low, (double)map[i]);
            s.high = fmax(s.high, (double)map[i]);
        }
    if (!(s.high > 0.0))
        s.low = s.high = 1.0;
    s.low = fmax(s.low, s.high * 0.01);
    return s;
}

/* Negative values mean none. */
static void colour_of(float value, span s, float *rgba)
{
    double part = value > 0.0f ? log((double)value / s.low) / fmax(log(s.high / s.low), 1e-300) : 0.0;
    double at = 4.0 * fmin(fmax(part, 0.0), 1.0);
    int low = at < 3.0 ? (int)at : 3;

    for (int i = 0; i < 3; i++)
        rgba[i] = value < 0.0f ? blank : (float)(ramp[low][i] + (at - low) * (ramp[low + 1][i] - ramp[low][i]));
    rgba[3] = 1.0f;
}

/* `but` follows the unit: other contents of the map. */
static void put_scale(FILE *to, span s, const char *unit, const char *but)
{
    if (s.low < s.high) {
        fputs("<div class=\"ramp\" style=\"background:linear-gradient(to right", to);
        for (int i = 0; i < 5; i++)
            fprintf(to, ",rgb(%d,%d,%d)", (int)(255 * ramp[i][0]), (int)(255 * ramp[i][1]), (int)(255 * ramp[i][2]));
        fprintf(to, ")\"></div><div class=\"ends\"><span>%.3g</span><span>%s, logarithmic%s</span><span>%.3g</span></div>\n",
                s.low, unit, but, s.high);
    } else {
        fprintf(to, "<div class=\"ends\"><span>everywhere %.3g %s%s</span></div>\n", s.high, unit, but);
    }
}

static pov_status put_map(const report *r, FILE *to, pov_pixels kind, const char *what, const char *unit, pov_error *err)
{
    size_t count = (size_t)r->width * (size_t)r->height;
    pov_rect all = { 0, 0, r->width, r->height };
    float *map = malloc(count * sizeof *map), *rgba = malloc(4 * count * sizeof *rgba);
    pov_status status = POV_OK;
    bool has_blanks = false;
    span s;

    if (map && rgba) {
        pov_job_read(r->job, all, kind, map, sizeof *map * (size_t)r->width);
        s = span_of(map, count);
        for (size_t i = 0; i < count; i++) {
            bool blank_here = map[i] < 0.0f || (kind == POV_PIXELS_SAMPLES && !(map[i] > 0.0f));

            has_blanks = has_blanks || blank_here;
            colour_of(blank_here ? -1.0f : map[i], s, rgba + 4 * i);
        }
        fprintf(to, "<figure><figcaption>%s</figcaption>\n", what);
        status = put_image(r, to, rgba, POV_TRANSFER_LINEAR, "map", what, err);
        put_scale(to, s, unit, !has_blanks ? "" : kind == POV_PIXELS_SAMPLES ? "; white: none" : "; white: not known");
        fputs("</figure>\n", to);
    } else {
        status = save_fail(err, POV_E_MEMORY, r->args->report, "out of memory for the report");
    }
    free(map);
    free(rgba);
    return status;
}

/* ---- tables ---- */

static void put_cell(FILE *to, double value, const char *format)
{
    fputs("<td>", to);
    if (value >= 0.0)
        fprintf(to, format, value);
    fputs("</td>", to);
}

static void put_count(FILE *to, uint64_t count)
{
    fprintf(to, "<td>%llu</td>", (unsigned long long)count);
}

static void put_errors(const report *r, FILE *to)
{
    fputs("<h2>Passes</h2>\n<div class=\"wide\"><table class=\"numbers\"><thead><tr><th>pass</th><th>wall s</th><th>cpu s</th>"
          "<th>samples a pixel</th><th>most</th><th>estimated rms error</th><th>95 % band from</th><th>to</th>"
          "<th>99 % of cells below</th><th>unresolved pixels</th><th>true rms error</th><th>true largest</th>"
          "<th>estimated / true</th><th>slope</th></tr></thead>\n", to);
    for (size_t i = 0; i < r->count; i++) {
        const pov_pass *p = &r->rows[i];
        report_figures f = report_figures_of(p, i > 0 ? &r->rows[i - 1] : NULL);

        fprintf(to, "<tr><td>%d</td><td>%.3f</td><td>%.3f</td><td>%.2f</td><td>%d</td>", p->pass, p->wall_s, p->cpu_s,
                p->spp_mean, p->spp_max);
        put_cell(to, p->est_rmse, "%.6f");
        put_cell(to, p->est_ci95_lo, "%.6f");
        put_cell(to, p->est_ci95_hi, "%.6f");
        put_cell(to, p->est_p99_tile, "%.6f");
        put_cell(to, p->est_rmse >= 0.0 ? (double)p->unresolved : -1.0, "%.0f");
        put_cell(to, p->ref_rmse, "%.6f");
        put_cell(to, p->ref_max, "%.4f");
        put_cell(to, f.est_over_true, "%.3f");
        if (isnan(f.slope))
            fputs("<td></td></tr>\n", to);
        else
            fprintf(to, "<td>%.2f</td></tr>\n", f.slope);
    }
    fputs("</table></div>\n", to);
}

static void put_work(const report *r, FILE *to)
{
    fputs("<h2>Cost per pass</h2>\n<div class=\"wide\"><table class=\"numbers\"><thead><tr><th>pass</th><th>threads</th>"
          "<th>primary rays</th><th>secondary rays</th><th>shadow rays</th><th>cut off by depth</th><th>by weight</th>"
          "<th>pixels outside 0 &hellip; 1</th><th>efficiency, 1 / (error&sup2; cpu s)</th></tr></thead>\n", to);
    for (size_t i = 0; i < r->count; i++) {
        const pov_pass *p = &r->rows[i];

        fprintf(to, "<tr><td>%d</td><td>%d</td>", p->pass, p->threads);
        put_count(to, p->counts.camera);
        put_count(to, p->counts.reflected + p->counts.transmitted);
        put_count(to, p->counts.shadow);
        put_count(to, p->counts.cut_depth);
        put_count(to, p->counts.cut_weight);
        put_count(to, p->clipped);
        put_cell(to, report_figures_of(p, NULL).efficiency, "%.5g");
        fputs("</tr>\n", to);
    }
    fputs("</table></div>\n", to);
}

static void put_bias(const report *r, FILE *to)
{
    const pov_counts *c = &r->progress->counts;
    uint64_t clipped = r->count > 0 ? r->rows[r->count - 1].clipped : 0;

    fprintf(to, "<h2>Not covered by the estimate</h2>\n<table><tr><th>cut off by</th><th>how often</th><th>effect</th></tr>\n"
            "<tr><td>depth (max_trace_level)</td><td class=\"n\">%llu rays</td><td>each adds black</td></tr>\n"
            "<tr><td>weight (adc_bailout)</td><td class=\"n\">%llu rays</td><td>each adds black</td></tr>\n"
            "<tr><td>clamping to 0 &hellip; 1</td><td class=\"n\">%llu pixels</td>"
            "<td>clipped where the picture is stored in integers; PFM keeps them</td></tr></table>\n",
            (unsigned long long)c->cut_depth, (unsigned long long)c->cut_weight, (unsigned long long)clipped);
    if (r->count > 0 && r->rows[r->count - 1].est_rmse == 0.0)
        fprintf(to, "<p>All samples of each pixel are alike. So many do not exclude a feature that covers less than %.3g of "
                "a cell of 4 &times; 4 pixels; that is where the band ends.</p>\n", r->rows[r->count - 1].est_ci95_hi);
}

static void put_plan(const report *r, FILE *to)
{
    pov_plan_row row = POV_INIT(row);

    fputs("<h2>Compiled for this scene</h2>\n<table><tr><th></th><th>subject</th><th>state</th><th>reason</th></tr>\n", to);
    for (int used = 1; used >= 0; used--)
        for (size_t i = 0; pov_scene_get_plan(r->scene, i, &row); i++) {
            if (row.used != (used == 1))
                continue;
            fprintf(to, "<tr%s><td>%s</td><td>", used ? "" : " class=\"out\"", used ? "+" : "&minus;");
            put_text(to, row.subject);
            fputs("</td><td>", to);
            put_text(to, row.state);
            fputs("</td><td>", to);
            put_text(to, row.reason);
            fputs("</td></tr>\n", to);
        }
    fputs("</table>\n", to);
}

static pov_status put_stats(const report *r, FILE *to, pov_error *err)
{
    stats s = { r->args, r->context, r->scene, r->progress, r->job, r->write_seconds, r->messages->warnings };
    char *text = NULL;
    size_t length = 0;
    FILE *lines = open_memstream(&text, &length);

    if (!lines)
        return save_fail(err, POV_E_MEMORY, r->args->report, "out of memory for the report");
    stats_print(lines, &s);
    if (fclose(lines) != 0) {
        free(text);
        return save_fail(err, POV_E_MEMORY, r->args->report, "out of memory for the report");
    }
    fputs("<h2>Statistics</h2>\n<pre>", to);
    put_text(to, text);
    fputs("</pre>\n", to);
    free(text);
    return POV_OK;
}

static void put_origin(const report *r, FILE *to)
{
    report_origin o;

    report_find_origin(r, &o);
    fprintf(to, "<h2>How to reproduce</h2>\n<p>povtrace %s, %s, on ", o.version, o.date);
    put_text(to, o.processor);
    fprintf(to, "; seed %d, sampling %s. The same words draw the same picture on any machine, unless time ended it.</p>\n<pre>",
            o.seed, o.sampling);
    put_text(to, o.command);
    fputs("</pre>\n", to);
}

/* ---- the page ---- */

static const char *const style =
    "body{font:15px/1.45 system-ui,sans-serif;color:#222;background:#fff;margin:2em auto;max-width:1080px;padding:0 1em}"
    "h1{font-size:1.5em;margin:0;overflow-wrap:anywhere}"
    "h2{font-size:1.15em;margin:1.6em 0 .5em;border-bottom:1px solid #ccc}"
    ".lead{color:#444;margin:.3em 0 1.2em}.row{display:flex;flex-wrap:wrap;gap:16px}"
    "figure{margin:0;flex:1 1 300px;min-width:0}figcaption{font-size:.85em;color:#444;margin-bottom:4px}"
    "img{width:100%;height:auto;display:block}img.map{image-rendering:pixelated;box-shadow:0 0 0 1px #ccc}"
    "img.curve{max-width:820px}"
    ".ramp{height:10px;margin-top:6px;-webkit-print-color-adjust:exact;print-color-adjust:exact}"
    ".ends{display:flex;justify-content:space-between;font-size:.8em;color:#444;margin-top:2px}"
    ".wide{overflow-x:auto}table{border-collapse:collapse;font-size:.85em}"
    "th,td{text-align:left;padding:3px 8px;border-bottom:1px solid #ddd;vertical-align:top}"
    ".numbers td,.numbers th,td.n{text-align:right;font-variant-numeric:tabular-nums}.out td{color:#666}"
    "pre{font-size:.82em;columns:2 24em;background:#f6f6f6;padding:10px;margin:0}"
    "@page{margin:14mm}"
    "@media print{body{margin:0;max-width:none;padding:0;font-size:10px}.row{flex-wrap:nowrap;gap:8px}"
    "figure{flex-basis:0}.wide{overflow:visible}.numbers{font-size:.78em}.numbers th,.numbers td{padding:2px 4px}"
    "h2{break-after:avoid}figure,tr,img{break-inside:avoid}pre{break-inside:avoid}thead{display:table-header-group}"
    "img.curve{max-width:150mm}pre{background:none;padding:0;columns:2}}";

static const char *stop_in_words(const report *r)
{
    switch (r->progress->stop) {
    case POV_STOP_SAMPLES: return "the number of samples was reached";
    case POV_STOP_ERROR: return "the target error was reached";
    case POV_STOP_TIME: return "the time limit was reached";
    case POV_STOP_USER: return "it was interrupted";
    default: return "it did not end";
    }
}

static void put_head(const report *r, FILE *to)
{
    const pov_pass *last = r->count > 0 ? &r->rows[r->count - 1] : NULL;

    fputs("<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
          "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\"><title>", to);
    put_text(to, r->args->scene);
    fprintf(to, " - povtrace</title><style>%s</style></head><body>\n<h1>", style);
    put_text(to, r->args->scene);
    fprintf(to, "</h1>\n<p class=\"lead\">%d &times; %d pixels", r->width, r->height);
    if (last) {
        fprintf(to, ", %.1f samples a pixel in %.2f s on %d thread%s", last->spp_mean, last->wall_s, last->threads,
                last->threads == 1 ? "" : "s");
        if (last->est_rmse >= 0.0)
            fprintf(to, "; estimated rms error <b>%.5f</b> (95 %% band %.5f to %.5f)", last->est_rmse, last->est_ci95_lo,
                    last->est_ci95_hi);
        if (last->ref_rmse >= 0.0)
            fprintf(to, ", against the reference <b>%.5f</b>", last->ref_rmse);
    }
    fprintf(to, ". It stopped: %s.</p>\n", stop_in_words(r));
}

/* Is there a pass whose error is known? */
static bool shows_error(const report *r)
{
    for (size_t i = 0; i < r->count; i++)
        if (r->rows[i].est_rmse >= 0.0 || r->rows[i].ref_rmse >= 0.0)
            return true;
    return false;
}

static pov_status put_pictures(const report *r, FILE *to, pov_error *err)
{
    pov_status status;

    fputs("<div class=\"row\">\n<figure><figcaption>the picture</figcaption>\n", to);
    status = put_image(r, to, r->pixels, r->options.transfer, "picture", "the picture", err);
    fputs("</figure>\n", to);
    if (status == POV_OK && shows_error(r))
        status = put_map(r, to, POV_PIXELS_ERROR, "estimated rms error, by cells of 4 &times; 4 pixels", "linear light", err);
    /* A map with one sample everywhere is omitted, unless it shows that pixels are missing. */
    if (status == POV_OK && r->count > 0 && r->rows[r->count - 1].spp_mean != 1.0)
        status = put_map(r, to, POV_PIXELS_SAMPLES, "samples a pixel", "samples", err);
    fputs("</div>\n<h2>Error against run time</h2>\n", to);
    if (status == POV_OK && shows_error(r))
        return put_curve(r, to, err);
    if (status == POV_OK)
        fputs("<p>It is not known: to estimate the error takes two samples of each pixel, to measure it a reference "
              "(<code>--spp</code>, <code>--error</code>, <code>--time</code>, <code>--reference</code>).</p>\n", to);
    return status;
}

pov_status report_put_html(const report *r, FILE *to, pov_error *err)
{
    pov_status status;

    put_head(r, to);
    status = put_pictures(r, to, err);
    put_errors(r, to);
    put_work(r, to);
    put_bias(r, to);
    put_origin(r, to);
    put_plan(r, to);
    if (status == POV_OK)
        status = put_stats(r, to, err);
    fputs("</body></html>\n", to);
    return status;
}
