#include "fuzz/fuzz.h"

#include "support/scenes.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 8, HEIGHT = 6, BYTES_MOST = 1 << 16 };
static const size_t memory_most = (size_t)1 << 28;

/* Memory ends at a ceiling, and every eighth text finds that an allocation fails. */
typedef struct heap { size_t used; uint32_t left; } heap;

static void *resize(void *user, void *block, size_t bytes)
{
    heap *h = user;
    size_t *old = block ? (size_t *)block - 2 : NULL, before = old ? *old : 0, *fresh;

    if (bytes == 0) {
        h->used -= before;
        free(old);
        return NULL;
    }
    if (h->left == 0 || bytes > memory_most || h->used - before > memory_most - bytes)
        return NULL;
    h->left--;
    fresh = realloc(old, bytes + 2 * sizeof *fresh);
    if (!fresh)
        return NULL;
    h->used += bytes - before;
    *fresh = bytes;
    return fresh + 2;
}

static pov_load_desc description(pov_accel accel)
{
    pov_load_desc d = POV_INIT(d);

    d.accel = accel;
    d.threads = 1;
    d.max_trace_level = 3;
    d.limits.turns = 20000;
    d.limits.memory = (size_t)1 << 24;
    d.limits.seconds = 5.0;
    return d;
}

static void trace(pov_tracer *tracer, const pov_camera *camera, float pixels[WIDTH * HEIGHT][4], double distance[WIDTH * HEIGHT])
{
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        pov_hit hit = POV_INIT(hit);
        pov_vec3 org, dir;
        pov_error err;

        memset(pixels[i], 0, sizeof pixels[i]);
        distance[i] = -1.0;
        if (!pov_camera_ray(camera, (i % WIDTH + 0.5) / WIDTH - 0.5, 0.5 - (i / WIDTH + 0.5) / HEIGHT, &org, &dir))
            continue;
        if (pov_trace_hit(tracer, org, dir, &hit))
            distance[i] = hit.distance;
        if (pov_trace_color(tracer, org, dir, pixels[i], &err) < 0)
            memset(pixels[i], 0, sizeof pixels[i]);
    }
}

/* False: it was refused. */
static int draw(pov_context *context, const char *text, size_t size, pov_accel accel, float pixels[WIDTH * HEIGHT][4],
                double distance[WIDTH * HEIGHT])
{
    const pov_load_desc d = description(accel);
    pov_camera camera = POV_INIT(camera);
    pov_scene_info info = POV_INIT(info);
    pov_tracer *tracer = NULL;
    pov_scene *scene = NULL;
    pov_error err;
    int drawn = 0;

    if (pov_scene_load_text(&scene, context, text, size, "fuzz.pov", &d, &err) == POV_OK) {
        pov_scene_get_info(scene, &info);
        pov_scene_get_camera(scene, &camera);
        if (info.objects < 2000 && info.lights < 50 && pov_tracer_create(&tracer, scene, &err) == POV_OK) {
            trace(tracer, &camera, pixels, distance);
            drawn = 1;
        }
        pov_tracer_destroy(tracer);
    } else if (!err.message[0]) {
        abort();                 /* a refusal says why */
    }
    pov_scene_destroy(scene);
    return drawn;
}

static void compare(const double tree[WIDTH * HEIGHT], const double list[WIDTH * HEIGHT])
{
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        if (tree[i] != list[i]) {
            fprintf(stderr, "ray %d: %.17g in the tree, %.17g in the list\n", i, tree[i], list[i]);
            abort();
        }
}

void fuzz_scene(const uint8_t *data, size_t size)
{
    static float pixels[WIDTH * HEIGHT][4];
    static double tree[WIDTH * HEIGHT], list[WIDTH * HEIGHT];
    const uint32_t seed = size > 0 ? data[size - 1] + 7u * data[size / 2] + (uint32_t)size : 0;
    heap h = { 0, seed % 8 ? UINT32_MAX : seed * 37u % 4000u };
    pov_context_desc d = POV_INIT(d);
    pov_context *context;
    pov_error err;

    if (size > BYTES_MOST)
        return;
    d.plugin_path = TEST_PLUGINS;
    d.allocator.resize = resize;
    d.allocator.user = &h;
    if (pov_context_create(&context, &d, &err) < 0)
        return;
    if (draw(context, (const char *)data, size, POV_ACCEL_TREE, pixels, tree) && h.left > UINT32_MAX / 2 &&
        draw(context, (const char *)data, size, POV_ACCEL_NONE, pixels, list))
        compare(tree, list);
    pov_context_destroy(context);
    if (h.used > 0) {
        fprintf(stderr, "%lu bytes are left\n", (unsigned long)h.used);
        abort();
    }
}
