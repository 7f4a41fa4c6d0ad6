#include "merge.h"
#include "part.h"
#include "save.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* The parts beside an output. */
typedef struct found {
    char **paths;
    size_t count, capacity;
    int parts;                   /* how many there should be, as the first file's name says */
    int other;                   /* another such number; 0: all names agree */
    bool failed;                 /* no memory */
} found;

static void free_found(found *f)
{
    for (size_t i = 0; i < f->count; i++)
        free(f->paths[i]);
    free(f->paths);
}

static void add(found *f, const char *output, int part, int parts)
{
    char path[PATH_MAX];
    char **grown = f->paths;

    if (f->count == f->capacity) {
        f->capacity = f->capacity ? 2 * f->capacity : 64;
        grown = realloc(f->paths, f->capacity * sizeof *grown);
    }
    f->failed = f->failed || !grown;
    if (!grown || !part_path(output, part, parts, path))
        return;
    f->paths = grown;
    grown[f->count] = strdup(path);
    f->failed = f->failed || !grown[f->count];
    f->count += grown[f->count] != NULL;
}

/* Is the name that of a part of the output, letter for letter? */
static bool is_part(const char *name, const char *base, int *part, int *parts)
{
    const size_t length = strlen(base);
    char again[PATH_MAX];

    return strncmp(name, base, length) == 0 && sscanf(name + length, ".part-%d-of-%d", part, parts) == 2 && *part >= 1 &&
           *part <= *parts && part_path(base, *part, *parts, again) && strcmp(again, name) == 0;
}

static void look(found *f, const char *output)
{
    const char *slash = strrchr(output, '/'), *base = slash ? slash + 1 : output;
    char folder[PATH_MAX];
    const struct dirent *entry;
    int part, parts;
    DIR *open;

    snprintf(folder, sizeof folder, "%.*s", slash ? (int)(slash - output) + 1 : 1, slash ? output : ".");
    open = opendir(folder);
    while (open && (entry = readdir(open)) != NULL) {
        if (!is_part(entry->d_name, base, &part, &parts))
            continue;
        f->other = f->parts && parts != f->parts ? parts : f->other;
        f->parts = f->parts ? f->parts : parts;
        add(f, output, part, parts);
    }
    if (open)
        closedir(open);
}

static pov_status check_found(const found *f, const args *a, pov_error *err)
{
    char text[256];

    if (f->failed)
        return save_fail(err, POV_E_MEMORY, "", "out of memory");
    if (f->count == 0)
        return save_fail(err, POV_E_IO, a->output, "there are no parts of this picture; \"povc SCENE WIDTH HEIGHT OUTPUT --part I/N\" writes them");
    if (f->other == 0)
        return POV_OK;
    snprintf(text, sizeof text, "there are parts of %d and of %d beside this picture: remove those that are not meant", f->parts, f->other);
    return save_fail(err, POV_E_ARGUMENT, a->output, text);
}

/* ---- the picture ---- */

static pov_status write_picture(const args *a, pov_context *context, pov_job *job, const pov_progress *p,
                                const pov_image_options *options, pov_error *err)
{
    const size_t stride = 4 * sizeof(float) * (size_t)p->width;
    const pov_rect all = { 0, 0, p->width, p->height };
    float *pixels = malloc(stride * (size_t)p->height);
    pov_status status;

    if (!pixels)
        return save_fail(err, POV_E_MEMORY, "", "out of memory for a picture of this size");
    pov_job_read(job, all, POV_PIXELS_LINEAR_FLOAT, pixels, stride);
    status = pov_image_write(context, a->output, p->width, p->height, pixels, stride, options, err);
    free(pixels);
    return status;
}

/* Only when the picture is there. */
static void remove_parts(const found *f, const args *a)
{
    char round[PATH_MAX];

    for (size_t i = 0; i < f->count; i++)
        unlink(f->paths[i]);
    if (part_round_path(a->output, round))
        unlink(round);
}

static void say_end(const messages *m, const pov_progress *p, bool short_of)
{
    if (p->est_rmse == 0.0)
        messages_say(m, "joined after round %d; %.1f samples a pixel, all samples alike%s", p->round, p->spp_mean,
                     short_of ? "; the error is not known" : "");
    else if (p->est_rmse > 0.0)
        messages_say(m, "joined after round %d; %.1f samples a pixel, estimated error %.3g%s", p->round, p->spp_mean, p->est_rmse,
                     short_of ? ", target error not reached" : "");
}

static pov_status finish(const args *a, const messages *m, pov_context *context, pov_job *job, const found *f,
                         run_end *end, pov_error *err)
{
    pov_progress p = POV_INIT(p);
    part_note note;
    pov_status status;

    if (!part_note_read(&note, pov_job_get_note(job)))
        return save_fail(err, POV_E_IO, a->output, "these parts were not written by povc");
    pov_job_get_progress(job, &p);
    status = write_picture(a, context, job, &p, &note.options, err);
    if (status < 0)
        return status;
    remove_parts(f, a);
    if (note.error > 0.0 && (p.stop == POV_STOP_SAMPLES || p.est_rmse == 0.0))
        *end = RUN_SHORT;
    say_end(m, &p, *end == RUN_SHORT);
    return POV_OK;
}

static pov_status go_on(const args *a, const messages *m, pov_job *job, run_end *end, pov_error *err)
{
    pov_progress p = POV_INIT(p);
    char round[PATH_MAX];
    pov_status status;

    if (!part_round_path(a->output, round))
        return save_fail(err, POV_E_ARGUMENT, "", "the name of the output is too long for a round beside it");
    status = pov_job_save(job, round, err);
    if (status < 0)
        return status;
    pov_job_get_progress(job, &p);
    messages_say(m, "round %d: %.1f samples a pixel, estimated error %.3g; trace the parts again for round %d", p.round, p.spp_mean,
                 p.est_rmse, p.round + 1);
    *end = RUN_ROUND;
    return POV_OK;
}

pov_status merge_run(const args *a, const messages *m, pov_context *context, run_end *end, pov_error *err)
{
    pov_progress p = POV_INIT(p);
    pov_job *job = NULL;
    found f = { 0 };
    pov_status status;

    look(&f, a->output);
    status = check_found(&f, a, err);
    if (status == POV_OK)
        status = pov_job_join(&job, context, (const char *const *)f.paths, f.count, err);
    pov_job_get_progress(job, &p);
    if (status == POV_OK)
        status = p.stop == POV_STOP_PART ? go_on(a, m, job, end, err) : finish(a, m, context, job, &f, end, err);
    pov_job_destroy(job);
    free_found(&f);
    return status;
}
