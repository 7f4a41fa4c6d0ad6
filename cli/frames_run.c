#include "frames_run.h"
#include "progress.h"
#include "save.h"
#include "signals.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

/* The files of a frame. */
typedef struct names { char output[1100], report[1100], aov[ARGS_AOVS][1100]; } names;

static bool name_one(const frames *f, int frame, const char *path, char *out, const char **to)
{
    *to = path ? out : NULL;
    return !path || frames_name(f, frame, path, out, sizeof ((names *)0)->output);
}

static bool name_all(const args *of_all, int frame, names *n, args *one)
{
    const frames *f = &of_all->frames;
    bool named = name_one(f, frame, of_all->output, n->output, &one->output) &&
                 name_one(f, frame, of_all->report, n->report, &one->report);

    for (int i = 0; named && i < ARGS_AOVS; i++)
        named = name_one(f, frame, of_all->aov[i], n->aov[i], &one->aov[i]);
    return named;
}

/* A picture stands under its name when it is whole, or with a checkpoint beside it. */
static bool is_there(const char *output)
{
    char checkpoint[1200];

    snprintf(checkpoint, sizeof checkpoint, "%s.checkpoint", output);
    return strcmp(output, "-") != 0 && strncmp(output, "/dev/", 5) != 0 && access(output, F_OK) == 0 &&
           access(checkpoint, F_OK) != 0;
}

/* Is the scene's file missing, or the picture's place wrong, so that every other frame would fail like this one? */
static bool is_lost(const args *one, const pov_error *err)
{
    return err->status == POV_E_ARGUMENT ||
           (err->status == POV_E_IO && (strcmp(err->file, one->output) == 0 || strcmp(err->file, one->scene) == 0));
}

typedef struct counts { int there, failed; bool is_short; } counts;

static pov_status draw(const args *of_all, messages *m, int frame, counts *c, pov_error *err)
{
    const pov_animation now = frames_animation(&of_all->frames, frame);
    args one = *of_all;
    messages own = *m;           /* an error of one frame does not silence the next one's */
    run_end end = RUN_COMPLETE;
    names n;

    if (!name_all(of_all, frame, &n, &one))
        return save_fail(err, POV_E_ARGUMENT, "", "the output's name is too long");
    if (one.resume && is_there(one.output)) {
        c->there++;
        return POV_OK;
    }
    one.animation = &now;
    one.progress_of_all->frame = frame;
    if (run_args(&one, &own, &end, err) < 0) {
        if (is_lost(&one, err))
            return err->status;
        messages_error(&own, err);
        messages_say(m, "frame %d is left out", frame);
        c->failed++;
    }
    c->is_short = c->is_short || end == RUN_SHORT;
    return POV_OK;
}

static pov_status end_all(const args *a, const messages *m, const counts *c, run_end *end, pov_error *err)
{
    char text[80];

    if (c->there > 0)
        messages_say(m, "%d of %d frames were there already", c->there, frames_count(&a->frames));
    *end = c->is_short ? RUN_SHORT : RUN_COMPLETE;
    if (c->failed == 0)
        return POV_OK;
    snprintf(text, sizeof text, "%d of %d frames failed", c->failed, frames_count(&a->frames));
    return save_fail(err, POV_E_SYNTAX, "", text);
}

pov_status frames_run(args *a, messages *m, run_end *end, pov_error *err)
{
    progress shown;
    counts c = { 0 };

    if (!a->frames.asked)
        return run_args(a, m, end, err);
    progress_init(&shown, a);
    shown.frames = frames_count(&a->frames);
    a->progress_of_all = &shown;
    for (int frame = a->frames.from; frame <= a->frames.to && !signals_end_asked(); frame += a->frames.step, shown.done++)
        if (draw(a, m, frame, &c, err) < 0)
            return err->status;
    return end_all(a, m, &c, end, err);
}
