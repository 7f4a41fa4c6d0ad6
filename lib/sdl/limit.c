#include "sdl/limit.h"

#include "base/clock.h"
#include "base/file.h"
#include "sdl/parse_copies.h"

/* Turns between two looks at the clock and at the memory. */
enum { LOOK_EVERY = 1 << 10 };

/* What was read of objects; values count for themselves. */
static size_t scene_bytes(const pov_reader *in)
{
    const model *m = in->model;

    return m->memory.bytes + m->maps.bytes + in->members.bytes + m->leaves.capacity * sizeof *m->leaves.items +
           m->lights.capacity * sizeof *m->lights.items + (in->copies ? in->copies->uses.capacity * sizeof(copy_use) : 0);
}

void limit_tell(pov_reader *in)
{
    const reader_options *o = in->options;
    const source *text = in->frames.count > 0 ? in->frames.items[0].text : NULL;
    const double length = text ? (double)(text->end - text->text) : 0.0;

    in->until_told = LIMIT_TELL_EVERY;
    if (o && o->progress && !in->failed &&
        !o->progress(o->progress_user, length > 0.0 ? (double)(text->at - text->text) / length : 0.0, in->model->leaves.count))
        report_fail(in, &in->token.at, POV_E_CANCELLED, "loading was cancelled");
}

bool limit_time(pov_reader *in, const place *at)
{
    limit_tell(in);
    if (!in->failed && clock_seconds() - in->started > in->limits.seconds)
        report_fail(in, at, POV_E_SYNTAX, "reading takes longer than %g seconds", in->limits.seconds);
    return !in->failed;
}

void limit_look(pov_reader *in, const place *at)
{
    if (limit_time(in, at) && scene_bytes(in) > in->limits.memory)
        report_fail(in, at, POV_E_MEMORY, "this loop has made the scene larger than %zu bytes", in->limits.memory);
}

bool limit_input(pov_reader *in, size_t bytes)
{
    const bool fits = bytes <= in->limits.input - in->input;

    in->input += fits ? bytes : 0;
    return fits;
}

bool limit_images(pov_reader *in, size_t bytes)
{
    const bool fits = bytes <= in->limits.images - in->image_bytes;

    in->image_bytes += fits ? bytes : 0;
    return fits;
}

pov_status limit_read_file(pov_reader *in, const char *path, char **bytes, size_t *count, pov_error *err)
{
    const size_t left = in->limits.input - in->input;
    const bool is_limited = in->limits.input < SIZE_MAX;
    const pov_status status = is_limited ? file_read_most(in->model->env, path, left, bytes, count, err)
                                         : file_read(in->model->env, path, bytes, count, err);

    if (status == POV_OK)
        in->input += *count;
    return status;
}

bool limit_turn(pov_reader *in, const place *at)
{
    if (++in->turns > in->limits.turns)
        report_fail(in, at, POV_E_SYNTAX, "more than %llu turns of loops and calls of macros",
                    (unsigned long long)in->limits.turns);
    else if (in->turns % LOOK_EVERY == 0)
        limit_look(in, at);
    return !in->failed;
}
