#include "render/identity.h"

#include "base/err.h"
#include "render/job_state.h"

#include <stdio.h>
#include <string.h>

enum { FORMAT = 7, ORDER = 0x01020304 };

static void identify_version(identity *id)
{
    snprintf(id->version, sizeof id->version, "%d.%d.%d", POVTRACE_VERSION_MAJOR, POVTRACE_VERSION_MINOR,
             POVTRACE_VERSION_PATCH);
    id->order = ORDER;
    id->format = FORMAT;
}

static void identify_scene(const shading *scene, identity *id)
{
    id->scene = scene->model->identity;
    id->dialect = (int32_t)scene->model->dialect;
    id->depth = scene->model->max_trace_level;
    id->exact = world_is_exact(scene->world);
}

static void identify_camera(const pov_camera *c, identity *id)
{
    const pov_vec3 vectors[4] = { c->location, c->direction, c->right, c->up };

    id->camera_type = (int32_t)c->type;
    memcpy(id->camera, vectors, sizeof id->camera);
}

static void identify_settings(const settings *s, identity *id)
{
    id->width = s->width;
    id->height = s->height;
    id->crop[0] = s->crop.x;
    id->crop[1] = s->crop.y;
    id->crop[2] = s->crop.width;
    id->crop[3] = s->crop.height;
    id->first_step = s->first_step;
    id->samples = s->samples;
    id->adaptive = s->adaptive;
    id->alpha = s->alpha;
    id->cell_edge = CELL_EDGE;
    id->seed = s->seed;
    id->target_error = s->target_error;
    id->parts = s->parts;
    id->ends_early = s->ends_early;
}

void identity_of(const pov_job *job, const char *magic, identity *id)
{
    memset(id, 0, sizeof *id);
    if (job->joined)
        *id = *job->joined;
    memset(id->magic, 0, sizeof id->magic);
    strcpy(id->magic, magic);
    if (job->joined)
        return;
    identify_version(id);
    identify_scene(job->scene, id);
    identify_camera(&job->camera, id);
    identify_settings(&job->settings, id);
}

bool identity_is_ours(const identity *theirs)
{
    identity ours;

    memset(&ours, 0, sizeof ours);
    identify_version(&ours);
    return theirs->order == ours.order && theirs->format == ours.format &&
           memcmp(theirs->version, ours.version, sizeof ours.version) == 0;
}

pov_status identity_check(const identity *theirs, const identity *ours, const char *file, const char *what, pov_error *err)
{
    if (memcmp(theirs->magic, ours->magic, sizeof ours->magic) != 0)
        return err_file(err, POV_E_IO, file, "this is no %s", what);
    if (!identity_is_ours(theirs))
        return err_file(err, POV_E_ARGUMENT, file, "this %s was made by another version of povtrace, %.15s, or another machine",
                        what, theirs->order == ours->order ? theirs->version : "unknown");
    if (theirs->scene != ours->scene)
        return err_file(err, POV_E_ARGUMENT, file, "this %s was made from another scene text", what);
    if (memcmp(theirs, ours, sizeof *ours) != 0)
        return err_file(err, POV_E_ARGUMENT, file,
                        "this %s was made with other settings: size, crop, preview, parts, samples, error, sampling, seed, depth, accuracy or camera",
                        what);
    return POV_OK;
}
