#include "support/scenes.h"

#include "support/check.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int by_name(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

char **scenes_list(const char *folder)
{
    char path[512], **list = calloc(1024, sizeof *list);
    struct dirent *entry;
    size_t n = 0;
    DIR *d;

    snprintf(path, sizeof path, "%s/scenes/%s", TEST_ROOT, folder);
    d = opendir(path);
    assert_non_null(list);
    assert_non_null(d);
    while ((entry = readdir(d)) != NULL) {
        size_t length = strlen(entry->d_name);
        /* *.povray.pov is the same scene in the other dialect, for the comparison. */
        if (length < 5 || strcmp(entry->d_name + length - 4, ".pov") != 0 || strstr(entry->d_name, ".povray."))
            continue;
        list[n] = malloc(strlen(path) + length + 2);
        assert_non_null(list[n]);
        sprintf(list[n++], "%s/%s", path, entry->d_name);
        assert_true(n < 1023);
    }
    closedir(d);
    qsort(list, n, sizeof *list, by_name);
    assert_true(n > 0);
    return list;
}

void scenes_free(char **list)
{
    size_t i;

    for (i = 0; list[i]; i++)
        free(list[i]);
    free(list);
}

pov_context *scenes_context(void)
{
    pov_context_desc d = POV_INIT(d);
    pov_context *context;
    pov_error err;

    d.plugin_path = TEST_PLUGINS;
    if (pov_context_create(&context, &d, &err) < 0)
        fail_msg("%s", err.message);
    return context;
}

pov_scene *scenes_text(pov_context *context, const char *text)
{
    pov_scene *scene;
    pov_error err;

    if (pov_scene_load_text(&scene, context, text, strlen(text), "test.pov", NULL, &err) < 0)
        fail_msg("%s:%d:%d: %s", err.file, err.line, err.column, err.message);
    return scene;
}

float *scenes_render(const pov_scene *scene, const pov_render_desc *desc)
{
    int width = desc->crop.width ? desc->crop.width : desc->width;
    int height = desc->crop.width ? desc->crop.height : desc->height;
    pov_rect all = { 0, 0, 0, 0 };
    pov_job *job;
    pov_error err;
    float *pixels = calloc((size_t)width * (size_t)height, 4 * sizeof *pixels);

    assert_non_null(pixels);
    all.width = width;
    all.height = height;
    if (pov_job_create(&job, scene, desc, &err) < 0 || pov_job_start(job, &err) < 0)
        fail_msg("%s", err.message);
    while (pov_job_wait(job, 10.0) == POV_JOB_RUNNING)
        continue;
    if (pov_job_get_error(job, &err) < 0)
        fail_msg("%s", err.message);
    pov_job_read(job, all, POV_PIXELS_LINEAR_FLOAT, pixels, (size_t)width * 4 * sizeof *pixels);
    pov_job_destroy(job);
    return pixels;
}

bool scenes_is_one_of(const char *path, const char *const *names)
{
    const char *slash = strrchr(path, '/'), *file = slash ? slash + 1 : path;

    for (; *names; names++)
        if (strncmp(file, *names, strlen(*names)) == 0)
            return true;
    return false;
}

float *scenes_draw_as(const char *text, const pov_render_desc *desc)
{
    pov_context *context = scenes_context();
    pov_scene *scene = scenes_text(context, text);
    float *picture = scenes_render(scene, desc);

    pov_scene_destroy(scene);
    pov_context_destroy(context);
    return picture;
}

float *scenes_draw(const char *text, int width, int height, int samples, int threads)
{
    pov_render_desc desc = POV_INIT(desc);

    desc.width = width;
    desc.height = height;
    desc.samples = samples;
    desc.threads = threads;
    return scenes_draw_as(text, &desc);
}
