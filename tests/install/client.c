/* client.c - a program of somebody else's, built against the installed library alone. It reads a scene from
 * memory, asks single rays, renders on threads of the library's and step by step on its own, and writes a PNG.
 * Usage: client OUTPUT.png */
#include <povtrace/povtrace.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 32, HEIGHT = 24 };

static const char scene_text[] =
    "camera { location <0, 0, -4> look_at <0, 0, 0> }\n"
    "light_source { <-5, 8, -9> color rgb <1, 1, 1> }\n"
    "sphere { <0, 0, 0>, 1 pigment { color rgb <1, .5, .25> } finish { ambient .2 diffuse .7 } }\n";

static int fail(const pov_error *err)
{
    fprintf(stderr, "%s:%d:%d: %s\n", err->file, err->line, err->column, err->message);
    return 1;
}

static int ask_rays(const pov_scene *scene)
{
    pov_tracer *tracer;
    pov_error err = { POV_OK, 0, 0, 0, "", "", "", "" };
    pov_hit hit = POV_INIT(hit);
    float color[4];

    if (pov_tracer_create(&tracer, scene, &err) < 0 ||
        pov_trace_color(tracer, pov_vec3_of(0, 0, -4), pov_vec3_of(0, 0, 2), color, &err) < 0)
        return fail(&err);
    if (!pov_trace_hit(tracer, pov_vec3_of(0, 0, -4), pov_vec3_of(0, 0, 2), &hit) || hit.distance != 1.5)
        return 2;
    if (!pov_trace_blocked(tracer, pov_vec3_of(0, 0, -4), pov_vec3_of(0, 0, 4)))
        return 3;
    printf("hit %u at %g, color %.3f\n", (unsigned)hit.object, hit.distance, color[0]);
    pov_tracer_destroy(tracer);
    return color[0] > 0.2f && color[3] == 1.0f ? 0 : 4;
}

static pov_status render(const pov_scene *scene, bool stepwise, float *pixels, pov_error *err)
{
    pov_render_desc desc = POV_INIT(desc);
    pov_rect all = { 0, 0, WIDTH, HEIGHT };
    pov_job *job;
    pov_status status;

    desc.width = WIDTH;
    desc.height = HEIGHT;
    desc.threads = 2;
    desc.preview = stepwise ? 8 : 0;
    status = pov_job_create(&job, scene, &desc, err);
    if (status < 0)
        return status;
    if (!stepwise) {
        status = pov_job_start(job, err);
        while (status == POV_OK && pov_job_wait(job, 1.0) == POV_JOB_RUNNING)
            continue;
    } else {
        pov_job_state state;
        do {
            state = pov_job_step(job);
        } while (state == POV_JOB_RUNNING || state == POV_JOB_IDLE);
    }
    pov_job_read(job, all, POV_PIXELS_LINEAR_FLOAT, pixels, WIDTH * 4 * sizeof(float));
    pov_job_destroy(job);
    return status;
}

int main(int argc, char **argv)
{
    static float pixels[2][WIDTH * HEIGHT * 4];
    pov_context *context = NULL;
    pov_scene *scene = NULL;
    pov_error err = { POV_OK, 0, 0, 0, "", "", "", "" };
    int code;

    if (argc != 2)
        return 5;
    if (pov_context_create(&context, NULL, &err) < 0 ||
        pov_scene_load_text(&scene, context, scene_text, strlen(scene_text), "text", NULL, &err) < 0 ||
        render(scene, false, pixels[0], &err) < 0 || render(scene, true, pixels[1], &err) < 0)
        return fail(&err);
    if (memcmp(pixels[0], pixels[1], sizeof pixels[0]) != 0)
        return 6;
    if (pov_image_write(context, argv[1], WIDTH, HEIGHT, pixels[0], WIDTH * 4 * sizeof(float), NULL, &err) < 0)
        return fail(&err);
    code = ask_rays(scene);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
    return code;
}
