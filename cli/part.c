#include "part.h"
#include "save.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

bool part_note_write(part_note *n, const pov_image_options *o, double error)
{
    const int length = snprintf(n->text, sizeof n->text, "bits=%d transfer=%d gamma=%.17g alpha=%d error=%.17g format=%s", o->bits,
                                (int)o->transfer, o->gamma, o->alpha, error, o->format ? o->format : "");

    return length < (int)sizeof n->text && (!o->format || strlen(o->format) < sizeof n->format);
}

bool part_note_read(part_note *n, const char *text)
{
    int transfer = 0, end = 0;

    memset(n, 0, sizeof *n);
    n->options.size = sizeof n->options;
    sscanf(text, "bits=%d transfer=%d gamma=%lg alpha=%d error=%lg format=%n%15s", &n->options.bits, &transfer, &n->options.gamma,
           &n->options.alpha, &n->error, &end, n->format);
    n->options.transfer = (pov_transfer)transfer;
    n->options.format = n->format[0] ? n->format : NULL;
    return end > 0;
}

bool part_path(const char *output, int part, int parts, char out[PATH_MAX])
{
    return snprintf(out, PATH_MAX, "%s.part-%d-of-%d", output, part, parts) < PATH_MAX;
}

bool part_round_path(const char *output, char out[PATH_MAX])
{
    return snprintf(out, PATH_MAX, "%s.round", output) < PATH_MAX;
}

/* The part's own file of an earlier round spares that work. Whatever is wrong with it, the part can be traced anew. */
static void take_own(const args *a, const messages *m, pov_job *job, const char *path)
{
    pov_error err = { 0 };

    if (access(path, F_OK) == 0 && pov_job_load(job, path, &err) < 0)
        messages_say(m, "part %d of %d is traced anew: %s: %s", a->part, a->parts, path, err.message);
}

pov_status part_begin(const args *a, const messages *m, pov_context *context, pov_job *job, pov_error *err)
{
    char round[PATH_MAX], own[PATH_MAX];
    pov_status status;

    if (!part_path(a->output, a->part, a->parts, own) || !part_round_path(a->output, round))
        return save_fail(err, POV_E_ARGUMENT, "", "the name of the output is too long for a part beside it");
    status = pov_file_check(context, own, err);
    if (status < 0 || access(round, F_OK) != 0)
        return status;
    status = pov_job_load(job, round, err);
    if (status == POV_OK)
        take_own(a, m, job, own);
    else if (status == POV_E_ARGUMENT)
        messages_say(m, "remove %s to begin anew", round);
    return status;
}

pov_status part_end(const args *a, const messages *m, pov_job *job, pov_error *err)
{
    pov_progress p = POV_INIT(p);
    char own[PATH_MAX];

    pov_job_get_progress(job, &p);
    if (p.stop != POV_STOP_PART) {
        messages_say(m, "interrupted: part %d of %d is not written", a->part, a->parts);
        return POV_OK;
    }
    if (!part_path(a->output, a->part, a->parts, own))
        return save_fail(err, POV_E_ARGUMENT, "", "the name of the output is too long for a part beside it");
    return pov_job_save(job, own, err);
}
