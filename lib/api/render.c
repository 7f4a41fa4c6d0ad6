#include "api/adapt.h"
#include "api/handles.h"
#include "render/job.h"

static bool is_finite(pov_vec3 v) { return isfinite(v.x) && isfinite(v.y) && isfinite(v.z); }
static bool is_direction(pov_vec3 v) { return is_finite(v) && pov_largest(v) > 0.0; }

static bool is_camera(const pov_camera *c)
{
    return is_finite(c->location) && is_direction(c->direction) && is_direction(c->right) && is_direction(c->up) &&
           (unsigned)c->type < POV_CAMERA_TYPES;
}

/* The scene's camera, or the program's, whose struct may have another size. */
static pov_status take_camera(pov_render_desc *d, pov_camera *copy, pov_error *err)
{
    pov_status status;

    if (!d->camera)
        return POV_OK;
    status = adapt_in(copy, sizeof *copy, d->camera, "the camera", err);
    d->camera = copy;
    if (status == POV_OK && !is_camera(copy))
        return err_set(err, POV_E_ARGUMENT, "the camera's location must be finite, its direction, right and up finite and "
                                            "not zero, and its type a known one");
    return status;
}

pov_status pov_job_create(pov_job **out, const pov_scene *scene, const pov_render_desc *desc, pov_error *err)
{
    pov_render_desc d;
    pov_camera camera;
    pov_status status;

    if (out)
        *out = NULL;
    if (!out || !scene || !desc)
        return err_set(err, POV_E_ARGUMENT, "a job needs a place, a scene and a description");
    status = adapt_in(&d, sizeof d, desc, "the render description", err);
    if (status == POV_OK)
        status = take_camera(&d, &camera, err);
    return status < 0 ? status : job_create(out, scene->shading, &d, err);
}

void pov_job_destroy(pov_job *job)
{
    job_destroy(job);
}

pov_status pov_job_start(pov_job *job, pov_error *err)
{
    if (!job)
        return err_set(err, POV_E_ARGUMENT, "no job was given");
    return job_start(job, err);
}

pov_job_state pov_job_step(pov_job *job)
{
    return job ? job_step(job) : POV_JOB_FAILED;
}

pov_job_state pov_job_wait(pov_job *job, double seconds)
{
    return job ? job_wait(job, seconds) : POV_JOB_FAILED;
}

bool pov_job_take(pov_job *job, pov_rect *changed)
{
    return job && changed && job_take(job, changed);
}

void pov_job_read(pov_job *job, pov_rect rect, pov_pixels format, void *dst, size_t stride)
{
    if (job && dst)
        job_read(job, rect, format, dst, stride);
}

void pov_job_restart(pov_job *job, const pov_camera *camera)
{
    pov_camera ours;

    /* Without a size or a direction it is no camera. */
    if (camera)
        camera = adapt_in(&ours, sizeof ours, camera, "the camera", NULL) == POV_OK && is_camera(&ours) ? &ours : NULL;
    if (job)
        job_restart(job, camera);
}

void pov_job_pause(pov_job *job, bool paused)
{
    if (job)
        job_pause(job, paused);
}

void pov_job_cancel(pov_job *job)
{
    if (job)
        job_cancel(job);
}

void pov_job_get_progress(pov_job *job, pov_progress *out)
{
    pov_progress ours = POV_INIT(ours);

    if (!job || !out)
        return;
    job_get_progress(job, &ours);
    adapt_out(out, &ours, sizeof ours);
}

pov_status pov_job_save(pov_job *job, const char *file, pov_error *err)
{
    if (!job || !file)
        return err_set(err, POV_E_ARGUMENT, "to save takes a job and a path");
    return job_save(job, file, err);
}

pov_status pov_job_load(pov_job *job, const char *file, pov_error *err)
{
    if (!job || !file)
        return err_set(err, POV_E_ARGUMENT, "to load takes a job and a path");
    return job_load(job, file, err);
}

pov_status pov_job_join(pov_job **out, pov_context *context, const char *const *files, size_t count, pov_error *err)
{
    if (out)
        *out = NULL;
    if (!out || !context || !files || count == 0)
        return err_set(err, POV_E_ARGUMENT, "to join takes a place, a context and the files of parts");
    return job_join(out, &context->env, files, count, err);
}

const char *pov_job_get_note(const pov_job *job)
{
    return job ? job_note(job) : "";
}

bool pov_job_get_pass(pov_job *job, size_t index, pov_pass *out)
{
    pov_pass ours = POV_INIT(ours);

    if (!job || !out || !job_get_pass(job, index, &ours))
        return false;
    adapt_out(out, &ours, sizeof ours);
    return true;
}

bool pov_job_get_class(pov_job *job, size_t index, pov_class_counts *out)
{
    pov_class_counts ours = POV_INIT(ours);

    if (!job || !out || !job_get_class(job, index, &ours))
        return false;
    adapt_out(out, &ours, sizeof ours);
    return true;
}

pov_status pov_job_get_error(pov_job *job, pov_error *err)
{
    if (!job)
        return err_set(err, POV_E_ARGUMENT, "no job was given");
    return job_get_error(job, err);
}
