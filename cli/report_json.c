#include "report_origin.h"

#include <math.h>

static void put_string(FILE *to, const char *text)
{
    fputc('"', to);
    for (; *text; text++) {
        if (*text == '"' || *text == '\\')
            fprintf(to, "\\%c", *text);
        else if ((unsigned char)*text < 0x20)
            fprintf(to, "\\u%04x", (unsigned)(unsigned char)*text);
        else
            fputc(*text, to);
    }
    fputc('"', to);
}

/* JSON has no NaN: unknown values are null. */
static void put_number(FILE *to, const char *name, double value, bool known)
{
    if (known && isfinite(value))
        fprintf(to, ",\"%s\":%.9g", name, value);
    else
        fprintf(to, ",\"%s\":null", name);
}

static void put_count(FILE *to, const char *name, uint64_t value)
{
    fprintf(to, ",\"%s\":%llu", name, (unsigned long long)value);
}

static void put_row(FILE *to, const pov_pass *p, const pov_pass *before)
{
    report_figures f = report_figures_of(p, before);

    fprintf(to, "    {\"pass\":%d", p->pass);
    put_number(to, "wall_s", p->wall_s, true);
    put_number(to, "cpu_s", p->cpu_s, true);
    put_count(to, "threads", (uint64_t)p->threads);
    put_number(to, "spp_mean", p->spp_mean, true);
    put_count(to, "spp_max", (uint64_t)p->spp_max);
    put_count(to, "primary_rays", p->counts.camera);
    put_count(to, "secondary_rays", p->counts.reflected + p->counts.transmitted);
    put_count(to, "shadow_rays", p->counts.shadow);
    put_number(to, "est_rmse", p->est_rmse, p->est_rmse >= 0.0);
    put_number(to, "est_ci95_lo", p->est_ci95_lo, p->est_ci95_lo >= 0.0);
    put_number(to, "est_ci95_hi", p->est_ci95_hi, p->est_ci95_hi >= 0.0);
    put_number(to, "est_p99_tile", p->est_p99_tile, p->est_p99_tile >= 0.0);
    put_number(to, "unresolved_px", (double)p->unresolved, p->est_rmse >= 0.0);
    put_count(to, "bias_depth", p->counts.cut_depth);
    put_count(to, "bias_adc", p->counts.cut_weight);
    put_count(to, "bias_clamp", p->clipped);
    put_number(to, "ref_rmse", p->ref_rmse, p->ref_rmse >= 0.0);
    put_number(to, "ref_max", p->ref_max, p->ref_max >= 0.0);
    put_number(to, "est_over_true", f.est_over_true, f.est_over_true >= 0.0);
    put_number(to, "efficiency", f.efficiency, f.efficiency >= 0.0);
    put_number(to, "slope", f.slope, true);
    fputc('}', to);
}

static void put_plan(const report *r, FILE *to)
{
    pov_plan_row row = POV_INIT(row);

    for (size_t i = 0; pov_scene_get_plan(r->scene, i, &row); i++) {
        fprintf(to, "%s\n    {\"used\":%s,\"subject\":", i > 0 ? "," : "", row.used ? "true" : "false");
        put_string(to, row.subject);
        fputs(",\"state\":", to);
        put_string(to, row.state);
        fputs(",\"reason\":", to);
        put_string(to, row.reason);
        fputc('}', to);
    }
}

static void put_origin(const report *r, FILE *to)
{
    report_origin o;

    report_find_origin(r, &o);
    fprintf(to, ",\n  \"version\":\"%s\",\"date\":\"%s\",\"processor\":", o.version, o.date);
    put_string(to, o.processor);
    fputs(",\"command\":", to);
    put_string(to, o.command);
    fprintf(to, ",\"seed\":%d,\"sampling\":\"%s\"", o.seed, o.sampling);
}

void report_put_json(const report *r, FILE *to)
{
    const args *a = r->args;

    fputs("{\n  \"scene\":", to);
    put_string(to, a->scene);
    put_origin(r, to);
    fprintf(to, ",\n  \"width\":%d,\"height\":%d", r->width, r->height);
    put_number(to, "asked_error", a->error, a->error > 0.0);
    put_number(to, "asked_time", a->time, a->time > 0.0);
    put_number(to, "asked_spp", a->samples, a->samples > 0);
    fprintf(to, ",\"ended_by\":\"%s\",\n  \"passes\":[\n", report_stop(r));
    for (size_t i = 0; i < r->count; i++) {
        put_row(to, &r->rows[i], i > 0 ? &r->rows[i - 1] : NULL);
        fputs(i + 1 < r->count ? ",\n" : "\n", to);
    }
    fputs("  ],\n  \"explain\":[", to);
    put_plan(r, to);
    fputs("\n  ]\n}\n", to);
}
