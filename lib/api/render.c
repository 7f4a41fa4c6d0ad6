#include "api/adapt.h"
#include "api/handles.h"
#include "render/job.h"

/* The scene's camera, or the program's, which may be of another size. */
static pov_status take_camera(pov_render_desc *d, pov_camera *copy, pov_error *err)
{
    pov_status status;

    if (!d->camera)
        return POV_OK;
    status = adapt_in(copy, sizeof *copy, d->camera, "the camera", err);
    d->camera = copy;
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
    return status < 0 ? status : job_create(out, &scene->model, scene->world, &d, err);
}

void pov_job_destroy(pov_job *job)
{
    job_destroy(job);
}

pov_status pov_job_start(pov_job *job, pov_error *err)
{
    return job_start(job, err);
}

pov_job_state pov_job_step(pov_job *job)
{
    return job_step(job);
}

pov_job_state pov_job_wait(pov_job *job, double seconds)
{
    return job_wait(job, seconds);
}

bool pov_job_take(pov_job *job, pov_rect *changed)
{
    return job_take(job, changed);
}

void pov_job_read(pov_job *job, pov_rect rect, pov_pixels format, void *dst, size_t stride)
{
    job_read(job, rect, format, dst, stride);
}

void pov_job_restart(pov_job *job, const pov_camera *camera)
{
    pov_camera ours;

    /* What says no size is no camera, and must not be read as one. */
    if (camera)
        camera = adapt_in(&ours, sizeof ours, camera, "the camera", NULL) == POV_OK ? &ours : NULL;
    job_restart(job, camera);
}

void pov_job_pause(pov_job *job, bool paused)
{
    job_pause(job, paused);
}

void pov_job_cancel(pov_job *job)
{
    job_cancel(job);
}

void pov_job_get_progress(pov_job *job, pov_progress *out)
{
    pov_progress ours = POV_INIT(ours);

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

bool pov_job_get_pass(pov_job *job, size_t index, pov_pass *out)
{
    pov_pass ours = POV_INIT(ours);

    if (!job_get_pass(job, index, &ours))
        return false;
    adapt_out(out, &ours, sizeof ours);
    return true;
}

bool pov_job_get_class(pov_job *job, size_t index, pov_class_counts *out)
{
    pov_class_counts ours = POV_INIT(ours);

    if (!job_get_class(job, index, &ours))
        return false;
    adapt_out(out, &ours, sizeof ours);
    return true;
}

pov_status pov_job_get_error(pov_job *job, pov_error *err)
{
    return job_get_error(job, err);
}
