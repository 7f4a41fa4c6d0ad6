#include "report.h"
#include "plots.h"
#include "save.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

typedef enum form { FORM_CSV, FORM_JSON, FORM_HTML, FORM_PLOT } form;
static const struct { const char *ending; form form; } forms[] = {
    { "csv", FORM_CSV }, { "json", FORM_JSON }, { "html", FORM_HTML }, { "svg", FORM_PLOT }, { "png", FORM_PLOT },
};

/* The ending of the path's name, in lower case; empty when it is not one of a report. */
static const char *find_form(const char *path, form *out)
{
    const char *dot = strrchr(path, '.');
    char ending[8] = "";

    for (size_t i = 0; dot && dot[1 + i] && i + 1 < sizeof ending; i++)
        ending[i] = (char)tolower((unsigned char)dot[1 + i]);
    for (size_t i = 0; dot && strlen(dot + 1) < sizeof ending && i < sizeof forms / sizeof forms[0]; i++)
        if (strcmp(ending, forms[i].ending) == 0) {
            *out = forms[i].form;
            return forms[i].ending;
        }
    return NULL;
}

pov_status report_check(pov_context *context, const args *a, pov_error *err)
{
    static const char endings[] = "a report's name ends with .csv, .json, .html, .svg or .png";
    form f = FORM_CSV;
    const char *ending = find_form(a->report, &f);
    pov_status status;

    if (!ending)
        return save_fail(err, POV_E_ARGUMENT, a->report, endings);
    status = pov_file_check(context, a->report, err);
    if (status == POV_OK && (f == FORM_PLOT || f == FORM_HTML))
        status = pov_plot_check(context, f == FORM_PLOT ? ending : "svg", err);
    return status;
}

/* ---- writing ---- */

static pov_status put_form(const report *r, FILE *to, pov_error *err)
{
    form f = FORM_CSV;
    const char *ending = find_form(r->args->report, &f);

    switch (f) {
    case FORM_CSV:
        report_put_csv(r, to);
        return POV_OK;
    case FORM_JSON:
        report_put_json(r, to);
        return POV_OK;
    case FORM_HTML:
        return report_put_html(r, to, err);
    default:
        return report_put_plot(r, ending, to, err);
    }
}

static pov_status fetch_rows(report *r, pov_error *err)
{
    pov_pass row = POV_INIT(row);

    for (r->count = 0; pov_job_get_pass(r->job, r->count, &row); r->count++) {
        pov_pass *grown = realloc(r->rows, (r->count + 1) * sizeof *grown);

        if (!grown)
            return save_fail(err, POV_E_MEMORY, r->args->report, "out of memory for the report");
        r->rows = grown;
        r->rows[r->count] = row;
    }
    return POV_OK;
}

pov_status report_write(report *r, pov_error *err)
{
    char *text = NULL;
    size_t length = 0;
    FILE *to = open_memstream(&text, &length);
    pov_status status;

    r->rows = NULL;
    if (!to)
        return save_fail(err, POV_E_MEMORY, r->args->report, "out of memory for the report");
    status = fetch_rows(r, err);
    if (status == POV_OK)
        status = put_form(r, to, err);
    if (fclose(to) != 0 && status == POV_OK)
        status = save_fail(err, POV_E_MEMORY, r->args->report, "out of memory for the report");
    if (status == POV_OK)
        status = pov_file_write(r->context, r->args->report, text, length, err);
    free(text);
    free(r->rows);
    r->rows = NULL;
    return status;
}
