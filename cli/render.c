#include "render.h"
#include "part.h"
#include "partial.h"
#include "pixels.h"
#include "progress.h"
#include "report.h"
#include "save.h"
#include "signals.h"
#include "tev.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

/* Longest delay of a signal in seconds. */
static const double patience = 0.05;
/* Edge of a pixel of the first pass if a limit of time asks for one. */
enum { COARSEST = 16 };

static double now_seconds(void)
{
    struct timespec now;

    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* ---- before the work ---- */

static pov_image_options image_options(const args *a)
{
    pov_image_options o = POV_INIT(o);

    o.bits = a->bits;
    o.transfer = a->transfer == ARGS_TRANSFER_SRGB ? POV_TRANSFER_SRGB : POV_TRANSFER_LINEAR;
    o.alpha = a->alpha;
    o.format = a->format;
    if (!o.format && strcmp(a->output, "-") == 0)
        o.format = "png";
    return o;
}

pov_status render_check_output(pov_context *context, const args *a, pov_error *err)
{
    static const char terminal[] = "standard output is a terminal, no place for a picture; pipe it on";
    pov_image_options options = image_options(a);
    pov_status status = save_check_names(a, err);

    if (status == POV_OK)
        status = pov_image_check(context, a->output, &options, err);

    if (status == POV_OK && a->report)
        status = report_check(context, a, err);
    if (status < 0)
        return status;
    if (strcmp(a->output, "-") == 0)
        return isatty(STDOUT_FILENO) ? save_fail(err, POV_E_ARGUMENT, "", terminal) : POV_OK;
    return POV_OK;
}

/* ---- the work ---- */

static pov_status read_reference(render *r, pov_error *err)
{
    r->reference.size = sizeof r->reference;
    r->reference.width = r->width;
    r->reference.height = r->height;
    return pov_image_read(r->context, r->args->reference, &r->reference, err);
}

/* The same for all runs that may share a checkpoint. */
static bool may_end_early(const args *a) { return a->time > 0.0 || a->partial_every > 0.0 || a->resume; }

static bool take_part(render *r, pov_render_desc *desc)
{
    desc->part = r->args->part;
    desc->parts = r->args->parts;
    desc->note = r->note.text;
    return part_note_write(&r->note, &r->options, r->args->error);
}

static pov_status prepare(render *r, pov_error *err)
{
    const args *a = r->args;
    pov_render_desc desc = POV_INIT(desc);
    pov_scene_info info = POV_INIT(info);

    pov_scene_get_info(r->scene, &info);
    r->options = image_options(a);
    if (a->transfer == ARGS_TRANSFER_SCENE)
        r->options.transfer = info.transfer;
    if (info.transfer != POV_TRANSFER_LINEAR)   /* a scene without gamma is written as it is */
        r->options.gamma = a->gamma;
    r->width = a->crop.width ? a->crop.width : a->width;
    r->height = a->crop.width ? a->crop.height : a->height;
    desc.width = a->width;
    desc.height = a->height;
    desc.crop = a->crop;
    /* A limit may be reached before the first pass has ended: a coarse picture of everything is better than part of a
     * fine one. */
    desc.preview = a->preview >= 0 ? a->preview : may_end_early(a) ? COARSEST : 0;
    desc.threads = a->threads;
    desc.samples = a->samples;
    desc.seed = (uint32_t)a->seed;
    desc.alpha = a->alpha;
    desc.time_map = a->aov[ARGS_AOV_TIME] != NULL;
    desc.target_error = a->error;
    desc.time_limit = a->time;
    /* Adaptive sampling reaches an error soonest; a given number of samples is uniform. */
    if (a->sampling == ARGS_SAMPLING_ADAPTIVE || (a->sampling == ARGS_SAMPLING_AUTO && (a->error > 0.0 || a->time > 0.0)))
        desc.sampling = POV_SAMPLING_ADAPTIVE;
    if (a->reference && read_reference(r, err) < 0)
        return err->status;
    desc.reference = r->reference.rgba;
    desc.reference_clipped = r->reference.bits < 32;
    if (a->parts > 0 && !take_part(r, &desc))
        return save_fail(err, POV_E_ARGUMENT, "", "the name of the image format is too long");
    r->pixels = a->parts > 0 ? NULL : pixels_make((size_t)r->width, (size_t)r->height);
    if (!r->pixels && a->parts == 0)
        return save_fail(err, POV_E_MEMORY, "", "out of memory for a picture of this size");
    return pov_job_create(&r->job, r->scene, &desc, err);
}

/* The part in its place; NULL: no memory. */
static float *put_in_whole(const render *r)
{
    const args *a = r->args;
    float *whole = calloc((size_t)a->width * (size_t)a->height, 4 * sizeof *whole);

    for (int y = 0; whole && y < r->height; y++)
        memcpy(whole + 4 * ((size_t)(a->crop.y + y) * (size_t)a->width + (size_t)a->crop.x),
               r->pixels + 4 * (size_t)y * (size_t)r->width, 4 * sizeof *whole * (size_t)r->width);
    return whole;
}

static pov_status write_whole(render *r, pov_error *err)
{
    const args *a = r->args;
    float *whole = put_in_whole(r);
    pov_status status;

    if (!whole)
        return save_fail(err, POV_E_MEMORY, "", "out of memory for a picture of this size");
    status = pov_image_write(r->context, a->output, a->width, a->height, whole, 4 * sizeof *whole * (size_t)a->width,
                             &r->options, err);
    free(whole);
    return status;
}

static pov_status write_picture(render *r, pov_error *err)
{
    size_t stride = 4 * sizeof(float) * (size_t)r->width;
    pov_rect all = { 0, 0, r->width, r->height };
    double start = now_seconds();
    pov_status status;

    pov_job_read(r->job, all, POV_PIXELS_LINEAR_FLOAT, r->pixels, stride);
    if (r->args->in_whole && r->args->crop.width > 0)
        status = write_whole(r, err);
    else
        status = pov_image_write(r->context, r->args->output, r->width, r->height, r->pixels, stride, &r->options, err);
    r->write_seconds = now_seconds() - start;
    return status;
}

/* SIGUSR1: a failure to write the picture does not end the render; the last write may succeed. */
static void write_now(render *r)
{
    pov_error err = { 0 };

    if (strcmp(r->args->output, "-") == 0)
        messages_say(r->messages, "standard output takes one picture only; it comes at the end");
    else if (write_picture(r, &err) < 0)
        messages_error(r->messages, &err);
    else
        messages_say(r->messages, "%s now holds the picture so far", r->args->output);
}

/* The checkpoint comes first: a picture newer than it would be lost. */
static void write_partial(render *r, partial *kept)
{
    pov_error err = { 0 };

    partial_save(kept);
    if (write_picture(r, &err) < 0)
        messages_error(r->messages, &err);
}

static pov_job_state watch(render *r, progress *shown, partial *kept, tev *viewer)
{
    double start = now_seconds();
    pov_progress now = POV_INIT(now);

    for (;;) {
        /* Without a viewer, changed tiles are not taken, so only the first tile and the end are news: tiles do not wake
         * this thread. */
        pov_job_state state = pov_job_wait(r->job, patience);

        tev_send(viewer, r->job);

        if (state != POV_JOB_RUNNING)
            return state;
        if (signals_end_asked())
            pov_job_cancel(r->job);
        if (signals_write_asked() && r->args->parts == 0)
            write_now(r);
        if (partial_due(kept, now_seconds() - start))
            write_partial(r, kept);
        if (progress_due(shown, now_seconds() - start)) {
            pov_job_get_progress(r->job, &now);
            progress_show(shown, &now);
        }
    }
}

static void say_partial(const render *r)
{
    const pov_progress *p = &r->progress;
    const char *name = strcmp(r->args->output, "-") == 0 ? "standard output" : r->args->output;
    char percent[16], error[40] = "";

    if (p->spp_mean < 1.0) {
        progress_percent(p->spp_mean > p->fraction ? p->spp_mean : p->fraction, percent, sizeof percent);
        messages_say(r->messages, "interrupted: %s holds %s %% of the picture", name, percent);
        return;
    }
    if (p->est_rmse > 0.0)
        snprintf(error, sizeof error, ", estimated error %.2g", p->est_rmse);
    if (r->args->samples > 0)
        messages_say(r->messages, "interrupted: %s holds %.3g of %d samples a pixel%s", name, p->spp_mean, r->args->samples, error);
    else
        messages_say(r->messages, "interrupted: %s holds %.3g samples a pixel%s", name, p->spp_mean, error);
}

/* The reason why refinement ended, when there was a choice. Where all samples were alike nothing is known of the error, so what
 * was asked for was not reached, however many samples there are. */
static void say_end(render *r)
{
    const args *a = r->args;
    const pov_progress *p = &r->progress;
    const bool alike = p->stop == POV_STOP_ERROR && p->est_rmse == 0.0;
    char reached[160] = "", percent[16];
    pov_pass last = POV_INIT(last);

    r->short_of = (p->stop == POV_STOP_TIME && (a->error > 0.0 || a->samples > 0 || p->spp_mean < 1.0)) ||
                  (p->stop == POV_STOP_SAMPLES && a->error > 0.0) || alike;
    if (!(a->error > 0.0 || a->time > 0.0))
        return;
    if (p->spp_mean < 1.0) {
        progress_percent(p->spp_mean, percent, sizeof percent);
        messages_say(r->messages, "stopped: time limit reached; %s holds %s %% of the picture", a->output, percent);
        return;
    }
    if (p->est_rmse == 0.0)
        snprintf(reached, sizeof reached, ", all samples alike; not excluded: a feature of less than %.3g of 4 x 4 pixels",
                 report_last_pass(r->job, &last) ? last.est_ci95_hi : 1.0);
    else if (p->est_rmse > 0.0)
        snprintf(reached, sizeof reached, ", estimated error %.3g", p->est_rmse);
    messages_say(r->messages, "stopped: %s after %.2f s; %.1f samples a pixel%s%s",
                 alike ? "no sample differs" : p->stop == POV_STOP_ERROR ? "target error reached" :
                 p->stop == POV_STOP_TIME ? "time limit reached" : "number of samples reached", p->seconds, p->spp_mean, reached,
                 alike ? "; the error is not known" : r->short_of && a->error > 0.0 ? ", target error not reached" : "");
}

static bool is_black(const render *r)
{
    for (size_t i = 0; i < (size_t)r->width * (size_t)r->height; i++)
        if (r->pixels[4 * i] != 0.0f || r->pixels[4 * i + 1] != 0.0f || r->pixels[4 * i + 2] != 0.0f)
            return false;
    return true;
}

/* A black picture has a reason more often than a purpose. One that ended in time may not have begun. */
static void warn_of_black(const render *r)
{
    pov_scene_info info = POV_INIT(info);
    pov_camera camera = POV_INIT(camera);
    const char *why = "nothing is in view, or no light reaches it";

    if (r->progress.stop == POV_STOP_TIME || !is_black(r))
        return;
    pov_scene_get_info(r->scene, &info);
    pov_scene_get_camera(r->scene, &camera);
    if (info.objects == 0)
        why = "the scene has no object";
    else if (info.lights == 0)
        why = "the scene has no light source, and nothing in view glows";
    messages_warn(r->messages, "the picture is black: %s; %s at <%g, %g, %g>", why,
                  info.has_camera ? "the camera stands" : "there is no camera, so it stands", camera.location.x,
                  camera.location.y, camera.location.z);
}

static pov_status write_report(render *r, pov_error *err)
{
    report of = { .args = r->args, .messages = r->messages, .context = r->context, .scene = r->scene, .job = r->job };

    of.progress = &r->progress;
    of.write_seconds = r->write_seconds;
    of.pixels = r->pixels;
    of.width = r->width;
    of.height = r->height;
    of.options = r->options;
    return report_write(&of, err);
}

static pov_status trace(render *r, pov_error *err)
{
    pov_job_state state;
    progress own, *shown = r->args->progress_of_all ? r->args->progress_of_all : &own;
    partial kept;
    tev viewer;
    pov_status status = partial_begin(&kept, r->args, r->messages, r->job, err);

    if (status == POV_OK && r->args->parts > 0)
        status = part_begin(r->args, r->messages, r->context, r->job, err);
    if (status == POV_OK)
        status = tev_begin(&viewer, r->args, r->messages, r->width, r->height, err);
    if (status == POV_OK)
        status = pov_job_start(r->job, err);
    if (status < 0)
        return status;
    if (!r->args->progress_of_all)
        progress_init(&own, r->args);
    state = watch(r, shown, &kept, &viewer);
    tev_end(&viewer);
    r->progress.size = sizeof r->progress;
    pov_job_get_progress(r->job, &r->progress);
    progress_end(shown, &r->progress);
    if (state == POV_JOB_FAILED)
        return pov_job_get_error(r->job, err);
    if (r->args->parts > 0)
        return part_end(r->args, r->messages, r->job, err);
    if (state == POV_JOB_CANCELLED || r->progress.stop == POV_STOP_TIME)
        partial_save(&kept);
    if (state == POV_JOB_CANCELLED && !save_is_awaited(r->args->output)) {
        messages_say(r->messages, "interrupted: nobody reads %s, so the picture is not written", r->args->output);
        return POV_OK;
    }
    status = write_picture(r, err);
    if (status == POV_OK && state == POV_JOB_DONE && r->progress.stop != POV_STOP_TIME)
        partial_forget(&kept);
    if (status == POV_OK && state == POV_JOB_DONE)
        warn_of_black(r);
    if (status == POV_OK && state == POV_JOB_CANCELLED)
        say_partial(r);
    else if (status == POV_OK)
        say_end(r);
    return status == POV_OK && r->args->report ? write_report(r, err) : status;
}

pov_status render_run(render *r, const args *a, const messages *m, pov_context *context,
                      const pov_scene *scene, pov_error *err)
{
    pov_status status;

    memset(r, 0, sizeof *r);
    r->args = a;
    r->messages = m;
    r->context = context;
    r->scene = scene;
    status = prepare(r, err);
    if (status < 0)
        return status;
    signals_watch();
    return trace(r, err);
}

void render_free(render *r)
{
    pov_job_destroy(r->job);
    pov_image_free(r->context, &r->reference);
    free(r->pixels);
    r->job = NULL;
    r->pixels = NULL;
}
