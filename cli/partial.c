#include "partial.h"
#include "save.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

/* Seconds between two checkpoints when --resume alone asks for them. */
static const double every_by_default = 60.0;

pov_status partial_begin(partial *p, const args *a, const messages *m, pov_job *job, pov_error *err)
{
    memset(p, 0, sizeof *p);
    p->args = a;
    p->messages = m;
    p->job = job;
    if (!a->resume && !(a->partial_every > 0.0))
        return POV_OK;
    if ((size_t)snprintf(p->path, sizeof p->path, "%s.checkpoint", a->output) >= sizeof p->path)
        return save_fail(err, POV_E_ARGUMENT, "", "the name of the output is too long for a checkpoint beside it");
    p->every = a->partial_every > 0.0 ? a->partial_every : every_by_default;
    if (!a->resume)
        return POV_OK;
    if (access(p->path, F_OK) == 0)
        return pov_job_load(job, p->path, err);
    messages_say(m, "there is no %s; beginning anew", p->path);
    return POV_OK;
}

bool partial_due(partial *p, double now)
{
    if (!p->path[0] || now - p->last < p->every)
        return false;
    p->last = now;
    return true;
}

void partial_save(const partial *p)
{
    pov_error err = { 0 };

    if (p->path[0] && pov_job_save(p->job, p->path, &err) < 0)
        messages_error(p->messages, &err);
}

void partial_forget(const partial *p)
{
    if (p->path[0])
        unlink(p->path);
}
