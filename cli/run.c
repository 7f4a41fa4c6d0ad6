#include "run.h"
#include "aov.h"
#include "compare.h"
#include "explain.h"
#include "merge.h"
#include "render.h"
#include "save.h"
#include "signals.h"
#include "stats.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Reports go to standard output, unless the picture goes there. */
static FILE *report_stream(const args *a)
{
    return a->output && strcmp(a->output, "-") == 0 && !a->check ? stderr : stdout;
}

/* The folders of -L with colons between them; free() it. NULL: no memory. */
static char *join_folders(const args *a)
{
    size_t size = 1;
    char *all;

    for (int i = 0; i < a->folder_count; i++)
        size += strlen(a->folders[i]) + 1;
    all = calloc(size, 1);
    for (int i = 0; all && i < a->folder_count; i++) {
        strcat(all, i > 0 ? ":" : "");
        strcat(all, a->folders[i]);
    }
    return all;
}

static pov_status load(pov_scene **scene, pov_context *context, const args *a, pov_error *err)
{
    pov_load_desc desc = POV_INIT(desc);
    char *folders = join_folders(a);
    pov_status status;

    desc.dialect = a->dialect;
    /* What is only read needs no tree. */
    desc.accel = a->check && !a->explain ? POV_ACCEL_NONE : a->accel;
    desc.accuracy = a->accuracy;
    desc.max_trace_level = a->max_depth;
    desc.threads = a->threads;
    desc.strict = a->strict;
    desc.soft_lights = a->soft_lights;
    desc.quick_colours = a->quick_colours;
    desc.width = a->width;
    desc.height = a->height;
    desc.library_path = folders;
    desc.write_path = a->write_path;
    desc.declares = a->declares;
    desc.animation = a->animation;
    desc.limits = a->limits;
    desc.most_rays = a->most_rays;
    desc.most_input = a->most_input;
    desc.most_images = a->most_images;
    status = folders ? pov_scene_load_file(scene, context, a->scene, &desc, err)
                     : save_fail(err, POV_E_MEMORY, a->scene, "out of memory");
    free(folders);
    return status;
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
                                    const pov_scene *scene, run_end *end, pov_error *err)
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
        status = aov_write(context, r.job, a, err);
    if (rendered) {
        *end = r.short_of ? RUN_SHORT : RUN_COMPLETE;
        render_free(&r);
    }
    return status;
}

static pov_status run_scene(const args *a, messages *m, pov_context *context, run_end *end, pov_error *err)
{
    pov_scene *scene = NULL;
    pov_status status = POV_OK;

    if (a->output && !a->check)
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
        status = render_and_report(a, m, context, scene, end, err);
    }
    pov_scene_destroy(scene);
    return status;
}

/* Each scene's messages are its own; the first error is the verdict, and is written like the others. */
static pov_status check_all(const args *a, messages *m, run_end *end, pov_error *err)
{
    pov_status worst = POV_OK;

    for (int i = 0; i < a->checked_count; i++) {
        args one = *a;
        pov_error wrong = { 0 };
        messages own = *m;

        one.scene = a->checked[i];
        one.checked_count = 1;
        if (run_args(&one, &own, end, &wrong) == POV_OK)
            continue;
        messages_error(&own, &wrong);
        m->errors = 1;
        if (worst == POV_OK) {
            *err = wrong;
            worst = wrong.status;
        }
    }
    return worst;
}

pov_status run_args(const args *a, messages *m, run_end *end, pov_error *err)
{
    char folders[4096];
    pov_context_desc desc = POV_INIT(desc);
    pov_context *context = NULL;
    pov_status status;

    if (a->compared)
        return compare_run(a, err);
    if (a->checked_count > 1)
        return check_all(a, m, end, err);
    desc.log = messages_log;
    desc.log_user = m;
    snprintf(folders, sizeof folders, "%s:", a->plugin_path ? a->plugin_path : "");
    desc.plugin_path = a->plugin_path ? folders : NULL;   /* in front of the standard ones */
    status = pov_context_create(&context, &desc, err);
    if (status == POV_OK)
        status = a->merge ? merge_run(a, m, context, end, err) : run_scene(a, m, context, end, err);
    pov_context_destroy(context);
    return status;
}
