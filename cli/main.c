/* povc - render a scene to an image file. */
#include "aov.h"
#include "args.h"
#include "compare.h"
#include "explain.h"
#include "messages.h"
#include "render.h"
#include "signals.h"
#include "stats.h"
#include "usage.h"

#include <stdio.h>
#include <string.h>

enum { EXIT_COMPLETE = 0, EXIT_ERROR = 1, EXIT_USAGE = 2, EXIT_SHORT = 3 };

/* Reports go to standard output, unless the picture goes there. */
static FILE *report_stream(const args *a)
{
    return a->output && strcmp(a->output, "-") == 0 && !a->check ? stderr : stdout;
}

static pov_status load(pov_scene **scene, pov_context *context, const args *a, pov_error *err)
{
    pov_load_desc desc = POV_INIT(desc);

    desc.dialect = a->dialect;
    desc.accel = a->accel;
    desc.accuracy = a->accuracy;
    desc.max_trace_level = a->max_depth;
    desc.threads = a->threads;
    return pov_scene_load_file(scene, context, a->scene, &desc, err);
}

static void say_checked(const args *a, const messages *m, const pov_scene *scene)
{
    pov_scene_info info = POV_INIT(info);

    if (a->quiet)
        return;
    pov_scene_get_info(scene, &info);
    printf("%s: no errors, %u warning%s; %llu object%s, %llu light%s, %s dialect\n", a->scene, m->warnings,
           m->warnings == 1 ? "" : "s", (unsigned long long)info.objects, info.objects == 1 ? "" : "s",
           (unsigned long long)info.lights, info.lights == 1 ? "" : "s",
           info.dialect == POV_DIALECT_COURSE ? "course" : "povray");
}

static pov_status render_and_report(const args *a, const messages *m, pov_context *context,
                                    const pov_scene *scene, bool *short_of, pov_error *err)
{
    bool rendered = a->output && !a->check;
    stats s = { a, context, scene, NULL, NULL, 0.0, m->warnings };
    pov_status status = POV_OK;
    render r;

    if (rendered) {
        status = render_run(&r, a, m, context, scene, err);
        s.progress = &r.progress;
        s.job = r.job;
        s.write_seconds = r.write_seconds;
    }
    if (status == POV_OK && a->stats)
        stats_print(report_stream(a), &s);
    if (status == POV_OK && rendered && !signals_end_asked())
        status = aov_write(context, scene, r.job, a, err);
    if (rendered) {
        *short_of = r.short_of;
        render_free(&r);
    }
    return status;
}

static pov_status run(const args *a, messages *m, bool *short_of, pov_error *err)
{
    pov_context_desc desc = POV_INIT(desc);
    pov_context *context = NULL;
    pov_scene *scene = NULL;
    pov_status status;

    if (a->compared)
        return compare_run(a, err);
    desc.log = messages_log;
    desc.log_user = m;
    desc.plugin_path = a->plugin_path;
    status = pov_context_create(&context, &desc, err);
    if (status == POV_OK && a->output && !a->check)
        status = render_check_output(context, a, err);
    if (status == POV_OK && a->output && !a->check)
        status = aov_check(context, a, err);
    if (status == POV_OK)
        status = load(&scene, context, a, err);
    if (status == POV_OK) {
        if (a->check)
            say_checked(a, m, scene);
        if (a->explain)
            explain_print(report_stream(a), context, scene);
        status = render_and_report(a, m, context, scene, short_of, err);
    }
    pov_scene_destroy(scene);
    pov_context_destroy(context);
    return status;
}

/* A failed write of a report is an error like any other: a full disk behind "povc --stats > file". */
static int finish(const messages *m, int code)
{
    pov_error err = { 0 };

    if (fflush(stdout) == 0 && !ferror(stdout))
        return code;
    snprintf(err.message, sizeof err.message, "cannot write to standard output");
    messages_error(m, &err);
    return code == EXIT_COMPLETE ? EXIT_ERROR : code;
}

static int refuse(const messages *m, const args *a)
{
    pov_error err = { 0 };

    snprintf(err.message, sizeof err.message, "%s", a->problem);
    messages_error(m, &err);
    fprintf(stderr, "Try \"povc --help\".\n");
    return EXIT_USAGE;
}

int main(int argc, char **argv)
{
    pov_error err = { 0 };
    messages m;
    args a;
    args_verdict verdict = args_parse(&a, argc, argv);
    int code = EXIT_COMPLETE;
    bool short_of = false;

    messages_init(&m, &a);
    if (verdict == ARGS_WRONG)
        return refuse(&m, &a);
    if (verdict == ARGS_HELP) {
        usage_print_help();
    } else if (verdict == ARGS_VERSION) {
        usage_print_version();
    } else if (run(&a, &m, &short_of, &err) < 0) {
        messages_error(&m, &err);
        code = err.status == POV_E_ARGUMENT ? EXIT_USAGE : EXIT_ERROR;
    } else if (short_of) {
        code = EXIT_SHORT;
    }
    code = finish(&m, code);
    if (signals_end_asked())
        signals_end_by(signals_end_asked());
    return code;
}
