#include "base/clock.h"
#include "base/err.h"
#include "base/file.h"
#include "render/budget_singles.h"
#include "render/job_state.h"
#include "render/part.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* Parts of one picture as they are read. What is wrong is collected: whoever is to trace parts again wants to know of
 * all of them. */
typedef struct joining {
    const env *env;
    pov_job *job;                /* NULL until the first good part is read */
    part_head first;
    int32_t *rounds;             /* by part: the round that it has ended; 0: missing */
    int32_t latest;
    char wrong[sizeof ((pov_error *)NULL)->message];
} joining;

static void say(joining *j, const char *format, ...) POV_PRINTF(2, 3);

static void say(joining *j, const char *format, ...)
{
    const size_t used = strlen(j->wrong);
    va_list list;

    va_start(list, format);
    vsnprintf(j->wrong + used, sizeof j->wrong - used, format, list);
    va_end(list);
}

static void say_file(joining *j, const char *file, const char *what)
{
    const char *slash = strrchr(file, '/');

    say(j, "%s%s %s", j->wrong[0] ? "; " : "", slash ? slash + 1 : file, what);
}

/* ---- the job ---- */

static pov_render_desc describe(const part_head *h)
{
    const identity *id = &h->id;
    pov_render_desc d = POV_INIT(d);

    d.width = id->width;
    d.height = id->height;
    d.crop.x = id->crop[0];
    d.crop.y = id->crop[1];
    d.crop.width = id->crop[2];
    d.crop.height = id->crop[3];
    d.threads = 1;
    d.samples = id->samples;
    d.sampling = id->adaptive ? POV_SAMPLING_ADAPTIVE : POV_SAMPLING_UNIFORM;
    d.target_error = id->target_error;
    d.seed = id->seed;
    d.alpha = id->alpha;
    return d;
}

static pov_status begin(joining *j, const part_head *head, pov_error *err)
{
    const gamma g = { head->decodes_srgb != 0, head->decode, (pov_transfer)head->transfer };
    const pov_render_desc desc = describe(head);
    pov_status status = job_create_joined(&j->job, j->env, &g, &desc, head->id.parts, err);

    if (status < 0)
        return status;
    j->first = *head;
    j->job->settings.ends_early = head->id.ends_early != 0;
    j->job->cells.alike = head->alike == ALIKE_SETS || head->alike == ALIKE_PHOTONS ? head->alike : 0;
    if (head->single && !budget_singles_make(&j->job->cells, j->job->env))
        return err_memory(err);
    memcpy(j->job->note, head->note, sizeof head->note);
    j->rounds = env_alloc(j->env, (size_t)head->id.parts, sizeof *j->rounds);
    j->job->joined = env_alloc(j->env, 1, sizeof *j->job->joined);
    if (!j->rounds || !j->job->joined)
        return err_memory(err);
    *j->job->joined = head->id;
    return POV_OK;
}

/* ---- the parts ---- */

static bool are_of_one_picture(const part_head *a, const part_head *b)
{
    return memcmp(&a->id, &b->id, sizeof a->id) == 0 && memcmp(a->note, b->note, sizeof a->note) == 0 &&
           a->decodes_srgb == b->decodes_srgb && a->alike == b->alike && a->single == b->single && a->transfer == b->transfer &&
           memcmp(&a->decode, &b->decode, sizeof a->decode) == 0;
}

static pov_status add_bytes(joining *j, const char *file, const char *bytes, size_t count, pov_error *err)
{
    pov_status status = POV_OK;
    part_head head;

    if (!part_read_head(bytes, count, &head)) {
        say_file(j, file, "is damaged, or of another version of povtrace");
        return POV_OK;
    }
    if (!j->job)
        status = begin(j, &head, err);
    if (status < 0)
        return status;
    if (!are_of_one_picture(&j->first, &head)) {
        say_file(j, file, "is of another scene, or was made with other options");
        return POV_OK;
    }
    status = part_take(j->job, &head, bytes, count);
    if (status == POV_E_IO)
        say_file(j, file, "is damaged");
    else if (status < 0)
        return err_memory(err);
    else
        j->rounds[head.part - 1] = head.round;
    j->latest = head.round > j->latest ? head.round : j->latest;
    return POV_OK;
}

static pov_status add(joining *j, const char *file, pov_error *err)
{
    pov_error unread = { 0 };
    char *bytes;
    size_t count;
    pov_status status = file_read(j->env, file, &bytes, &count, &unread);

    if (status == POV_E_MEMORY)
        return err_memory(err);
    if (status < 0) {
        say_file(j, file, "cannot be read");
        return POV_OK;
    }
    status = add_bytes(j, file, bytes, count, err);
    env_free(j->env, bytes);
    return status;
}

/* "3, 7-9" */
static void say_missing(joining *j)
{
    const int parts = j->first.id.parts;
    bool any = false;

    for (int i = 0; i < parts; i++) {
        int last = i;

        if (j->rounds[i] == j->latest)
            continue;
        while (last + 1 < parts && j->rounds[last + 1] != j->latest)
            last++;
        say(j, "%s%d", any ? ", " : j->wrong[0] ? "; to be traced: " : "to be traced: ", i + 1);
        if (last > i)
            say(j, "-%d", last + 1);
        any = true;
        i = last;
    }
    if (any)
        say(j, " of %d", parts);
}

/* ---- the picture ---- */

static void conclude(pov_job *job, int round)
{
    job->round = round;
    job->refining = job->settings.sampling;
    job->state = POV_JOB_RUNNING;
    job->started = clock_seconds();
    job->claimed = job->committed = job->due;
    passes_end(job);
}

static pov_status check(joining *j, pov_error *err)
{
    if (j->job)
        say_missing(j);
    if (j->wrong[0])
        return err_set(err, POV_E_IO, "the parts do not make a picture: %.440s", j->wrong);
    conclude(j->job, j->latest);
    return job_get_error(j->job, err);
}

pov_status job_join(pov_job **out, const env *e, const char *const *files, size_t count, pov_error *err)
{
    joining *j = env_alloc(e, 1, sizeof *j);
    pov_status status = j ? POV_OK : err_memory(err);

    if (!j)
        return status;
    j->env = e;
    for (size_t i = 0; status == POV_OK && i < count; i++)
        status = add(j, files[i], err);
    if (status == POV_OK)
        status = check(j, err);
    if (status < 0)
        job_destroy(j->job);
    else
        *out = j->job;
    env_free(e, j->rounds);
    env_free(e, j);
    return status;
}
