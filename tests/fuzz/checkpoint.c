#include "fuzz/fuzz.h"

#include "support/scenes.h"

#include "base/hash.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { WIDTH = 8, HEIGHT = 8, STEPS = 5, STEPS_MOST = 60, COUNT_MOST = 1 << 16 };

static const char scene_text[] = "camera { location <0,2,-6> look_at 0 } light_source { <-5,8,-9> rgb 1 }"
                                 " sphere { 0, 1 pigment { rgb <1,.5,.2> } finish { reflection .3 } }";

static pov_job *make(const pov_scene *scene)
{
    pov_render_desc d = POV_INIT(d);
    pov_job *job = NULL;
    pov_error err;

    d.width = WIDTH;
    d.height = HEIGHT;
    d.samples = 16;
    d.preview = 4;
    d.threads = 1;
    d.sampling = POV_SAMPLING_ADAPTIVE;
    if (pov_job_create(&job, scene, &d, &err) < 0)
        abort();
    return job;
}

static size_t save(const pov_scene *scene, const char *path, uint8_t *bytes)
{
    pov_job *job = make(scene);
    size_t count;
    FILE *from;

    for (int i = 0; i < STEPS; i++)
        pov_job_step(job);
    if (pov_job_save(job, path, NULL) < 0 || !(from = fopen(path, "rb")))
        abort();
    count = fread(bytes, 1, COUNT_MOST, from);
    fclose(from);
    pov_job_destroy(job);
    return count;
}

/* Three bytes an edit: where, and what. An odd first byte cuts the file there. */
static size_t forge(uint8_t *bytes, size_t count, const uint8_t *data, size_t size)
{
    uint64_t hash;

    if (size > 2 && data[0] & 1)
        count = 16 + (data[1] * 256u + data[2]) % (count - 16);
    for (size_t i = 1; i + 3 <= size; i += 3)
        bytes[(data[i] * 256u + data[i + 1]) % count] ^= data[i + 2];
    hash = hash_bytes(0, bytes, count - sizeof hash);
    memcpy(bytes + count - sizeof hash, &hash, sizeof hash);
    return count;
}

static void go_on(const pov_scene *scene, const char *path)
{
    pov_job *job = make(scene);
    pov_error err;

    if (pov_job_load(job, path, &err) == POV_OK)
        for (int i = 0; i < STEPS_MOST && pov_job_step(job) == POV_JOB_RUNNING; i++)
            continue;
    pov_job_destroy(job);
}

void fuzz_checkpoint(const uint8_t *data, size_t size)
{
    static uint8_t bytes[COUNT_MOST];
    pov_context_desc d = POV_INIT(d);
    pov_context *context;
    pov_scene *scene;
    char path[64];
    pov_error err;
    size_t count;
    FILE *to;

    d.plugin_path = TEST_PLUGINS;
    snprintf(path, sizeof path, "/tmp/povtrace-fuzz-%ld.checkpoint", (long)getpid());
    if (pov_context_create(&context, &d, &err) < 0 ||
        pov_scene_load_text(&scene, context, scene_text, strlen(scene_text), "fuzz.pov", NULL, &err) < 0)
        abort();
    count = save(scene, path, bytes);
    count = forge(bytes, count, data, size);
    to = fopen(path, "wb");
    if (!to || fwrite(bytes, 1, count, to) != count || fclose(to) != 0)
        abort();
    go_on(scene, path);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
    unlink(path);
}
