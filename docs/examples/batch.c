/* Render a scene to an image file: batch SCENE WIDTH HEIGHT OUTPUT. */
#include <povtrace/povtrace.h>

#include <stdio.h>
#include <stdlib.h>

int main(int argc, char **argv)
{
    pov_context *context = NULL;
    pov_scene *scene = NULL;
    pov_job *job = NULL;
    pov_render_desc desc = POV_INIT(desc);
    pov_scene_info info = POV_INIT(info);
    pov_image_options options = POV_INIT(options);
    pov_error err = { 0 };
    pov_rect all = { 0, 0, 0, 0 };
    float *pixels = NULL;
    size_t row;

    if (argc != 5) {
        fprintf(stderr, "usage: batch SCENE WIDTH HEIGHT OUTPUT\n");
        return 2;
    }
    desc.width = all.width = atoi(argv[2]);
    desc.height = all.height = atoi(argv[3]);
    row = (size_t)all.width * 4 * sizeof *pixels;
    if (pov_context_create(&context, NULL, &err) < 0 ||
        pov_scene_load_file(&scene, context, argv[1], NULL, &err) < 0 ||
        pov_job_create(&job, scene, &desc, &err) < 0 || pov_job_start(job, &err) < 0)
        goto out;
    while (pov_job_wait(job, 1.0) == POV_JOB_RUNNING)
        continue;
    pixels = malloc(row * (size_t)all.height);
    if (!pixels || pov_job_get_error(job, &err) < 0)
        goto out;
    pov_job_read(job, all, POV_PIXELS_LINEAR_FLOAT, pixels, row);
    pov_scene_get_info(scene, &info);
    options.transfer = info.transfer;
    pov_image_write(context, argv[4], all.width, all.height, pixels, row, &options, &err);
out:
    if (err.status < 0)
        fprintf(stderr, "%s:%d:%d: %s\n", err.file, err.line, err.column, err.message);
    free(pixels);
    pov_job_destroy(job);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
    return err.status < 0 || !pixels;
}
