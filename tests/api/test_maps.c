/* Maps of a job: what single rays find, and what the text says. */
#include "support/check.h"
#include "support/scenes.h"

#include <povtrace/trace.h>

#include <math.h>
#include <stdlib.h>

enum { WIDTH = 70, HEIGHT = 9, COUNT = WIDTH * HEIGHT };

static const char text[] =
    "#version 3.7; global_settings { assumed_gamma 1 } background { rgbt <0, 0, 1, 1> }\n"
    "camera { orthographic location <0, 0, -10> right 10*x up 3*y } light_source { <5, 9, -7> rgb 1 }\n"
    "sphere { <-3, 0, 0>, 1.4 pigment { rgb <1, .5, .2> } finish { reflection .3 } }\n"
    "box { <-1, -1, 0>, <1, 1, 2> texture { pigment { checker rgb <.9, 0, 0> rgb <0, .7, 0> scale .5 } }\n"
    "      texture { pigment { rgbt <0, 0, 1, .75> } } }\n"
    "plane { z, -2 pigment { rgb 1 } no_image }\n"
    "sphere { <3, 0, 0>, 1.4 pigment { rgbt <.8, .9, 1, .6> } }\n";

typedef struct drawn { pov_context *context; pov_scene *scene; pov_job *job; } drawn;

static drawn draw(void)
{
    pov_render_desc desc = POV_INIT(desc);
    drawn d = { scenes_context(), NULL, NULL };

    d.scene = scenes_text(d.context, text);
    desc.width = WIDTH;
    desc.height = HEIGHT;
    assert_int_equal(pov_job_create(&d.job, d.scene, &desc, NULL), POV_OK);
    return d;
}

static void forget(drawn *d)
{
    pov_job_destroy(d->job);
    pov_scene_destroy(d->scene);
    pov_context_destroy(d->context);
}

static void read(const drawn *d, pov_pixels format, void *to, size_t bytes)
{
    const pov_rect all = { 0, 0, WIDTH, HEIGHT };

    pov_job_read(d->job, all, format, to, bytes * WIDTH);
}

/* The first hit of a pixel's ray that the camera sees: the plane is none. */
typedef struct seen { bool met; pov_hit hit; } seen;

static bool visit(void *user, const pov_hit *h)
{
    seen *s = user;

    if (h->object == 2)
        return true;
    s->met = true;
    s->hit = *h;
    return false;
}

static void assert_near(const float *is, pov_vec3 wanted)
{
    assert_true(is[3] == 1.0f);
    assert_true(fabs((double)is[0] - wanted.x) < 1e-6 && fabs((double)is[1] - wanted.y) < 1e-6 && fabs((double)is[2] - wanted.z) < 1e-6);
}

static void maps_are_what_single_rays_find(void **state)
{
    static float depth[COUNT], normal[4 * COUNT], position[4 * COUNT], certain[COUNT];
    static uint32_t object[COUNT];
    drawn d = draw();
    pov_camera camera = POV_INIT(camera);
    pov_tracer *tracer;
    int hits = 0;

    (void)state;
    read(&d, POV_PIXELS_DEPTH, depth, 4);
    read(&d, POV_PIXELS_NORMAL, normal, 16);
    read(&d, POV_PIXELS_POSITION, position, 16);
    read(&d, POV_PIXELS_OBJECT, object, 4);
    read(&d, POV_PIXELS_CERTAINTY, certain, 4);
    pov_scene_get_camera(d.scene, &camera);
    assert_int_equal(pov_tracer_create(&tracer, d.scene, NULL), POV_OK);
    for (int i = 0; i < COUNT; i++) {
        const double u = (i % WIDTH + 0.5) / WIDTH - 0.5, v = 0.5 - (i / WIDTH + 0.5) / HEIGHT;
        pov_vec3 org, dir;
        seen s = { false, POV_INIT(s.hit) };

        assert_true(pov_camera_ray(&camera, u, v, &org, &dir));
        pov_trace_hits(tracer, org, dir, visit, &s);
        hits += s.met;
        assert_true(certain[i] == 0.0f || certain[i] == 1.0f);
        if (!s.met) {
            assert_true(depth[i] == 0.0f && normal[4 * i + 3] == 0.0f && position[4 * i + 3] == 0.0f && object[i] == UINT32_MAX);
            continue;
        }
        assert_int_equal(object[i], s.hit.object);
        assert_true(fabs((double)depth[i] - (s.hit.point.z + 10.0)) < 1e-5);
        assert_near(normal + 4 * i, s.hit.normal);
        assert_near(position + 4 * i, s.hit.point);
    }
    assert_true(hits > COUNT / 3 && hits < COUNT);
    pov_tracer_destroy(tracer);
    forget(&d);
}

/* Layers: a quarter of blue upon red or green. */
static void albedo_is_the_pigment(void **state)
{
    static float albedo[4 * COUNT];
    static uint32_t object[COUNT];
    drawn d = draw();
    int red = 0, green = 0;

    (void)state;
    read(&d, POV_PIXELS_ALBEDO, albedo, 16);
    read(&d, POV_PIXELS_OBJECT, object, 4);
    for (int i = 0; i < COUNT; i++) {
        const float *c = albedo + 4 * i;

        if (object[i] == 0)
            assert_near(c, pov_vec3_of(1.0, 0.5, 0.2));
        else if (object[i] == 3)
            assert_near(c, pov_vec3_of(0.8, 0.9, 1.0));
        else if (object[i] == 1 && c[0] > 0.0f)
            assert_near(c, pov_vec3_of(0.75 * 0.9, 0.0, 0.25)), red++;
        else if (object[i] == 1)
            assert_near(c, pov_vec3_of(0.0, 0.75 * 0.7, 0.25)), green++;
        else
            assert_true(c[0] == 0.0f && c[3] == 0.0f);
    }
    assert_true(red > 10 && green > 10);
    forget(&d);
}

/* The same as that of a picture with alpha whose pixels have one sample each. */
static void alpha_is_that_of_a_picture(void **state)
{
    static float alpha[COUNT];
    pov_render_desc desc = POV_INIT(desc);
    drawn d = draw();
    float *picture, least = 1.0f, most = 0.0f;

    (void)state;
    desc.width = WIDTH;
    desc.height = HEIGHT;
    desc.alpha = 1;
    picture = scenes_render(d.scene, &desc);
    read(&d, POV_PIXELS_ALPHA, alpha, 4);
    for (int i = 0; i < COUNT; i++) {
        assert_true(alpha[i] == picture[4 * i + 3]);
        least = fminf(least, alpha[i]);
        most = fmaxf(most, alpha[i]);
    }
    assert_true(least == 0.0f && most == 1.0f);
    free(picture);
    forget(&d);
}

/* Any rectangle is a part of the whole, and nothing else is written. */
static void parts_are_those_of_the_whole(void **state)
{
    static float whole[4 * COUNT], some[4 * 8 * 5];
    const pov_rect part = { WIDTH - 3, -2, 8, 5 };
    drawn d = draw();

    (void)state;
    read(&d, POV_PIXELS_ALBEDO, whole, 16);
    for (int i = 0; i < 4 * 8 * 5; i++)
        some[i] = -7.0f;
    pov_job_read(d.job, part, POV_PIXELS_ALBEDO, some, 4 * 8 * sizeof *some);
    for (int y = 0; y < 5; y++)
        for (int x = 0; x < 8; x++)
            for (int c = 0; c < 4; c++)
                assert_true(some[4 * (8 * y + x) + c] == (y < 2 || x >= 3 ? -7.0f : whole[4 * (WIDTH * (y - 2) + WIDTH - 3 + x) + c]));
    forget(&d);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(maps_are_what_single_rays_find),
        cmocka_unit_test(albedo_is_the_pigment),
        cmocka_unit_test(alpha_is_that_of_a_picture),
        cmocka_unit_test(parts_are_those_of_the_whole),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
