/* What all forms of a report derive from its rows. */
#include "report.h"

#include <math.h>

report_figures report_figures_of(const pov_pass *row, const pov_pass *before)
{
    report_figures f = { -1.0, -1.0, NAN };
    double best = row->ref_rmse >= 0.0 ? row->ref_rmse : row->est_rmse;

    if (row->ref_rmse > 0.0 && row->est_rmse >= 0.0)
        f.est_over_true = row->est_rmse / row->ref_rmse;
    if (best > 0.0 && row->cpu_s > 0.0)
        f.efficiency = 1.0 / (best * best * row->cpu_s);
    if (before && before->est_rmse > 0.0 && row->est_rmse > 0.0 && before->wall_s > 0.0 && row->wall_s > before->wall_s)
        f.slope = log(row->est_rmse / before->est_rmse) / log(row->wall_s / before->wall_s);
    return f;
}

bool report_last_pass(pov_job *job, pov_pass *out)
{
    size_t n = 0;

    while (pov_job_get_pass(job, n, out))
        n++;
    return n > 0;
}

const char *report_stop(const report *r)
{
    switch (r->progress->stop) {
    case POV_STOP_SAMPLES: return "samples";
    case POV_STOP_ERROR: return "error";
    case POV_STOP_TIME: return "time";
    case POV_STOP_USER: return "user";
    default: return "none";
    }
}
