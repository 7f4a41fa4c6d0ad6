/* A report as a table: a row for each pass. */
#include "report.h"

#include <math.h>

static void put_csv_number(FILE *to, double value)
{
    if (value >= 0.0)
        fprintf(to, ",%.9g", value);
    else
        fputc(',', to);
}

static void put_csv_row(FILE *to, const pov_pass *p, const pov_pass *before)
{
    report_figures f = report_figures_of(p, before);
    const pov_counts *c = &p->counts;

    fprintf(to, "%d,%.6f,%.6f,%d,%.6g,%d,%llu,%llu,%llu", p->pass, p->wall_s, p->cpu_s, p->threads, p->spp_mean, p->spp_max,
            (unsigned long long)c->camera, (unsigned long long)(c->reflected + c->transmitted),
            (unsigned long long)c->shadow);
    put_csv_number(to, p->est_rmse);
    put_csv_number(to, p->est_ci95_lo);
    put_csv_number(to, p->est_ci95_hi);
    put_csv_number(to, p->est_p99_tile);
    put_csv_number(to, p->est_rmse >= 0.0 ? (double)p->unresolved : -1.0);
    fprintf(to, ",%llu,%llu,%llu", (unsigned long long)c->cut_depth, (unsigned long long)c->cut_weight,
            (unsigned long long)p->clipped);
    put_csv_number(to, p->ref_rmse);
    put_csv_number(to, p->ref_max);
    put_csv_number(to, f.est_over_true);
    put_csv_number(to, f.efficiency);
    if (isnan(f.slope))
        fputs(",\n", to);
    else
        fprintf(to, ",%.4f\n", f.slope);
}

void report_put_csv(const report *r, FILE *to)
{
    fputs("pass,wall_s,cpu_s,threads,spp_mean,spp_max,primary_rays,secondary_rays,shadow_rays,est_rmse,est_ci95_lo,"
          "est_ci95_hi,est_p99_tile,unresolved_px,bias_depth,bias_adc,bias_clamp,ref_rmse,ref_max,est_over_true,"
          "efficiency,slope\n", to);
    for (size_t i = 0; i < r->count; i++)
        put_csv_row(to, &r->rows[i], i > 0 ? &r->rows[i - 1] : NULL);
}
