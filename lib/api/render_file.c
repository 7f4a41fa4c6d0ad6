/* A scene file to an image file in one call. */
#include "api/adapt.h"
#include "api/handles.h"

#include <povtrace/image.h>
#include <povtrace/render.h>

enum { USUAL_WIDTH = 800, USUAL_HEIGHT = 600 };

static pov_status write(pov_context *context, const pov_scene *scene, pov_job *job, const pov_render_desc *d, const char *image,
                        pov_error *err)
{
    pov_scene_info info = POV_INIT(info);
    pov_image_options options = POV_INIT(options);
    const int width = d->crop.width ? d->crop.width : d->width, height = d->crop.width ? d->crop.height : d->height;
    const pov_rect all = { 0, 0, width, height };
    const size_t stride = 4 * sizeof(float) * (size_t)width;
    float *pixels = env_resize(&context->env, NULL, (size_t)height, stride);
    pov_status status;

    if (!pixels)
        return err_memory(err);
    pov_scene_get_info(scene, &info);
    options.transfer = info.transfer;
    options.alpha = d->alpha;
    pov_job_read(job, all, POV_PIXELS_LINEAR_FLOAT, pixels, stride);
    status = pov_image_write(context, image, width, height, pixels, stride, &options, err);
    env_free(&context->env, pixels);
    return status;
}

static pov_status draw(pov_context *context, const pov_scene *scene, const char *image, const pov_render_desc *d, pov_error *err)
{
    pov_job *job = NULL;
    pov_status status = pov_job_create(&job, scene, d, err);

    if (status == POV_OK)
        status = pov_job_start(job, err);
    while (status == POV_OK && pov_job_wait(job, 3600.0) == POV_JOB_RUNNING)
        continue;
    if (status == POV_OK)
        status = pov_job_get_error(job, err);
    if (status == POV_OK)
        status = write(context, scene, job, d, image, err);
    pov_job_destroy(job);
    return status;
}

/* What is known to fail fails before the work. */
static pov_status check(pov_context *context, const char *image, const pov_render_desc *d, pov_error *err)
{
    pov_image_options options = POV_INIT(options);

    if (d->parts > 0)
        return err_set(err, POV_E_ARGUMENT, "a part is no picture: pov_job_save() writes it");
    options.alpha = d->alpha;
    return pov_image_check(context, image, &options, err);
}

pov_status pov_render_file(const char *scene, const char *image, const pov_load_desc *load, const pov_render_desc *desc,
                           pov_error *err)
{
    pov_context *context = NULL;
    pov_scene *loaded = NULL;
    pov_load_desc l;
    pov_render_desc d;
    pov_status status;

    if (!scene || !image)
        return err_set(err, POV_E_ARGUMENT, "to render a file takes the names of a scene and of an image");
    status = adapt_in(&d, sizeof d, desc, "the render description", err);
    if (status == POV_OK)
        status = adapt_in(&l, sizeof l, load, "the load description", err);
    d.width = desc ? d.width : USUAL_WIDTH;
    d.height = desc ? d.height : USUAL_HEIGHT;
    l.width = l.width ? l.width : d.width;
    l.height = l.height ? l.height : d.height;
    if (status == POV_OK)
        status = pov_context_create(&context, NULL, err);
    if (status == POV_OK)
        status = check(context, image, &d, err);
    if (status == POV_OK)
        status = pov_scene_load_file(&loaded, context, scene, &l, err);
    if (status == POV_OK)
        status = draw(context, loaded, image, &d, err);
    pov_scene_destroy(loaded);
    pov_context_destroy(context);
    return status;
}
