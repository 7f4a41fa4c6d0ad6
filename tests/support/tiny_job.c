#include "support/tiny_job.h"

#include "support/check.h"

#include <stdlib.h>

static material coloured(float r, float g, float b)
{
    material m = tiny_matt();

    m.pigment = colour_of(r, g, b);
    m.finish.ambient = colour_of(0.1f, 0.1f, 0.1f);
    m.finish.phong = 0.5f;
    return m;
}

void tiny_room(tiny *s, const pov_allocator *memory)
{
    material mirror = coloured(0.2f, 0.2f, 0.2f), glass = tiny_glass(1.5);

    tiny_begin(s, memory);
    mirror.finish.reflection.min = mirror.finish.reflection.max = colour_of(0.7f, 0.7f, 0.6f);
    glass.transmit = 0.9f;
    glass.finish.reflection.min = glass.finish.reflection.max = colour_of(0.1f, 0.1f, 0.1f);
    s->model.background = colour_of(0.2f, 0.4f, 0.8f);
    tiny_plane(s, 0, 1, 0, -1, coloured(0.8f, 0.7f, 0.5f));
    tiny_sphere(s, -1.2, 0, 4, 1, mirror);
    tiny_sphere(s, 1.2, 0, 4, 1, glass);
    tiny_sphere(s, 0.5, 0, 7, 1, coloured(0.9f, 0.1f, 0.1f));
    tiny_light(s, 5, 8, -2, 0.8f, 0.8f, 0.8f);
    tiny_light(s, -5, 4, 1, 0.2f, 0.2f, 0.4f);
    tiny_build(s);
}

void tiny_endless(tiny *s)
{
    material half = tiny_glass(1.0);

    tiny_begin(s, NULL);
    half.finish.reflection.min = half.finish.reflection.max = colour_of(1.0f, 1.0f, 1.0f);
    s->model.max_trace_level = 200;
    for (int i = 1; i < 5; i++) {
        tiny_plane(s, 0, 0, 1, i, half);
        tiny_plane(s, 0, 0, 1, -i, half);
    }
    tiny_build(s);
}

pov_render_desc tiny_desc(int width, int height)
{
    pov_render_desc d = POV_INIT(d);

    d.width = width;
    d.height = height;
    return d;
}

pov_job *tiny_job(const tiny *s, const pov_render_desc *desc)
{
    pov_job *job = NULL;

    assert_int_equal(job_create(&job, s->shading, desc, NULL), POV_OK);
    return job;
}

float *tiny_read(pov_job *job, int width, int height)
{
    float *pixels = malloc(4 * sizeof *pixels * (size_t)width * (size_t)height);
    pov_rect all = { 0, 0, width, height };

    assert_non_null(pixels);
    job_read(job, all, POV_PIXELS_LINEAR_FLOAT, pixels, 4 * sizeof *pixels * (size_t)width);
    return pixels;
}

float *tiny_picture(const tiny *s, const pov_render_desc *desc)
{
    pov_job *job = tiny_job(s, desc);
    int width = desc->crop.width ? desc->crop.width : desc->width;
    int height = desc->crop.width ? desc->crop.height : desc->height;
    float *pixels;

    assert_int_equal(job_start(job, NULL), POV_OK);
    while (job_wait(job, 1.0) == POV_JOB_RUNNING)
        ;
    assert_int_equal(job_wait(job, 0.0), POV_JOB_DONE);
    pixels = tiny_read(job, width, height);
    job_destroy(job);
    return pixels;
}
