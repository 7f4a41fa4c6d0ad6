/* Magnified pixels, their numbers, and the comparison with a reference; drawn on OSMesa. */
#include "cells.h"
#include "reference.h"
#include "stage.h"

#include <povtrace/image.h>

#include <math.h>

/* The corner of a zoomed view shows each pixel as a square, and the camera is where it was. */
static void pixels_magnify_and_leave_the_camera(void **state)
{
    stage *s = begin(good, 0);
    uint8_t *before = copy(see(s, ""));
    const unsigned long restarts = session_restarts(s->v.session);
    const uint8_t *p = see(s, "<move 200,100>zzzz");
    const int left = (int)s->v.app.zoom.left, top = (int)s->v.app.zoom.top;

    (void)state;
    assert_int_equal(s->v.app.zoom.factor, 6);
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            double across, down;

            zoom_to_picture(&s->v.app.zoom, x + 0.5, y + 0.5, &across, &down);
            assert_memory_equal(at(p, x, y), at(before, (int)across, (int)down), 3);
        }
    see(s, "<drag 60,-30>");
    assert_int_equal((int)s->v.app.zoom.left, left - 10);
    assert_int_equal((int)s->v.app.zoom.top, top + 5);
    see(s, "<wheel 1>");
    assert_int_equal(s->v.app.zoom.factor, 8);
    assert_int_equal(session_restarts(s->v.session), restarts);
    assert_true(app_camera(&s->v.app).location.z == -5.0);
    assert_int_equal(differences(see(s, "0"), before), 0);
    free(before);
    end(s);
}

static void assert_written(double value, const char *text)
{
    char out[16];

    cells_write(value, out, sizeof out);
    assert_string_equal(out, text);
    assert_true(strlen(out) <= 7);
}

static void pixels_have_numbers_of_six_characters(void **state)
{
    (void)state;
    assert_written(0.0, "0");
    assert_written(-0.0, "0");
    assert_written(1.0, "1");
    assert_written(4096.0, "4096");
    assert_written(0.4356, "0.436");
    assert_written(-0.4356, "-0.436");
    assert_written(0.00144, "0.0014");
    assert_written(-0.00144, "-0.001");
    assert_written(1.44e-4, "1.4e-4");
    assert_written(9.96e-5, "1.0e-4");
    assert_written(10.949, "10.95");
    assert_written(99.997, "100.0");
    assert_written(1234.5, "1234");
    assert_written(6.02e23, "6.0e23");
    assert_written(HUGE_VAL, "inf");
}

/* Values of the pixels in the middle, in each view. */
static void pixels_show_their_numbers(void **state)
{
    const pov_rect middle = { WIDTH / 2, HEIGHT / 2, 1, 1 };
    stage *s = begin(good, 0);
    uint8_t *before = copy(see(s, "<move 160,120>zzzzzzzzz"));
    float v[3], color[4];
    int bright = 0;

    (void)state;
    assert_int_equal(s->v.app.zoom.factor, 32);
    memcpy(before, see(s, "z"), WIDTH * HEIGHT * 4);
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        bright += before[4 * i + 1] > 150 && before[4 * i + 2] > 150;
    assert_true(bright > 500);
    assert_int_equal(session_values(s->v.session, middle, v), 3);
    assert_true(v[0] > 0.1f && v[1] == 0.0f && v[2] == 0.0f);
    memcpy(color, v, sizeof v);
    see(s, "<tab>");
    assert_int_equal(session_values(s->v.session, middle, v), 3);
    assert_true(v[2] < -0.99f);
    see(s, "<tab>");
    assert_int_equal(session_values(s->v.session, middle, v), 1);
    assert_true(fabsf(v[0] - 4.0f) < 0.001f);
    see(s, "<tab>");
    assert_int_equal(session_values(s->v.session, middle, v), 1);
    assert_true(v[0] == 1.0f);
    free(before);
    end(s);
}

/* Save the picture of the scene, with the red of its right half doubled. */
static void save_reference(const char *text, const char *path)
{
    pov_context *context = scenes_context();
    pov_scene *scene = scenes_text(context, text);
    pov_rect all = { 0, 0, WIDTH, HEIGHT };
    pov_render_desc d = POV_INIT(d);
    const size_t row = WIDTH * 4 * sizeof(float);
    float *rgba = malloc(HEIGHT * row);
    pov_job *job;

    assert_non_null(rgba);
    d.width = WIDTH;
    d.height = HEIGHT;
    assert_int_equal(pov_job_create(&job, scene, &d, NULL), POV_OK);
    while (pov_job_step(job) == POV_JOB_RUNNING)
        continue;
    pov_job_read(job, all, POV_PIXELS_LINEAR_FLOAT, rgba, row);
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        rgba[4 * i] *= i % WIDTH < WIDTH / 2 ? 1.0f : 2.0f;
    assert_int_equal(pov_image_write(context, path, WIDTH, HEIGHT, rgba, row, NULL, NULL), POV_OK);
    free(rgba);
    pov_job_destroy(job);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
}

/* A pixel of the sphere in the left half, and one in the right; below the legend. */
static const uint8_t *left_of(const uint8_t *p) { return at(p, WIDTH / 2 - 20, HEIGHT / 2 + 20); }
static const uint8_t *right_of(const uint8_t *p) { return at(p, WIDTH / 2 + 20, HEIGHT / 2 + 20); }

static void pixels_flip_to_the_reference_and_back(void **state)
{
    stage *s;
    uint8_t *before;
    const uint8_t *p;

    (void)state;
    save_reference(good, "reference.png");
    s = begin_as(good, 0, 1, "reference.png");
    before = copy(see(s, ""));
    p = see(s, "b");
    /* What is alike is bit-identical. */
    assert_memory_equal(left_of(p), left_of(before), 3);
    assert_true(right_of(p)[0] > right_of(before)[0] + 20);
    /* Exposure is of both. */
    p = see(s, "]]]");
    assert_true(left_of(p)[0] > left_of(before)[0] + 20);
    see(s, "[[[");
    assert_int_equal(differences(see(s, "b"), before), 0);
    free(before);
    end(s);
}

static void pixels_wipe_at_the_pointer(void **state)
{
    stage *s = begin_as(good, 0, 1, "reference.png");
    uint8_t *before = copy(see(s, ""));
    const int middle = HEIGHT / 2;
    const uint8_t *p = see(s, "l<move 190,40>");

    (void)state;
    assert_true(at(p, 189, middle)[0] > at(before, 189, middle)[0] + 20);
    assert_memory_equal(at(p, 190, middle), at(before, 190, middle), 3);
    p = see(s, "<move 170,40>");
    assert_memory_equal(at(p, 180, middle), at(before, 180, middle), 3);
    assert_true(at(p, 169, middle)[0] > at(before, 169, middle)[0] + 20);
    /* Magnified, the border is where the pointer is too. */
    p = see(s, "<move 180,120>zzz");
    assert_true(at(p, 179, middle)[0] > at(p, 180, middle)[0] + 20);
    free(before);
    end(s);
}

static void pixels_show_the_difference(void **state)
{
    const pov_rect left = { WIDTH / 2 - 20, HEIGHT / 2 + 20, 1, 1 }, right = { WIDTH / 2 + 20, HEIGHT / 2 + 20, 1, 1 };
    stage *s;
    const uint8_t *p;
    float v[3], color;

    (void)state;
    save_reference(good, "reference.pfm");
    s = begin_as(good, 0, 1, "reference.pfm");
    see(s, "");
    session_values(s->v.session, right, v);
    color = v[0];
    p = see(s, "d");
    assert_true(left_of(p)[0] + left_of(p)[1] < 40);
    assert_true(right_of(p)[0] > 150);
    assert_int_equal(session_values(s->v.session, left, v), 3);
    assert_true(v[0] == 0.0f && v[1] == 0.0f && v[2] == 0.0f);
    session_values(s->v.session, right, v);
    assert_true(v[0] == -color && v[1] == 0.0f);
    assert_true(session_reference_rms(s->v.session) > 0.01);
    /* Another view ends it. */
    see(s, "<tab>");
    assert_int_equal(s->v.app.compare, APP_PLAIN);
    end(s);
}

/* The window is resized while the difference is seen: the reference is scaled to it. */
static void pixels_of_another_size_are_compared_with_what_the_reference_has_there(void **state)
{
    const pov_rect left = { 130, 117, 1, 1 }, right = { 170, 117, 1, 1 };
    stage *s = begin_as(good, 0, 1, "reference.pfm");
    float v[3];

    (void)state;
    see(s, "d");
    assert_int_equal(s->v.app.compare, APP_DIFFERENCE);
    shot_play(&s->v, "<size 300,200>");
    shot_settle(&s->v);
    assert_int_equal(s->v.app.compare, APP_DIFFERENCE);
    assert_int_equal(session_values(s->v.session, left, v), 3);
    assert_true(fabsf(v[0]) < 0.02f);
    session_values(s->v.session, right, v);
    assert_true(v[0] < -0.1f && fabsf(v[1]) < 0.02f);
    app_compare_with(&s->v.app, APP_WIPE, 1.0);
    assert_string_equal(s->v.app.note, "the reference, of 320 x 240 pixels, is scaled");
    assert_int_equal(s->v.app.compare, APP_WIPE);
    end(s);
    s = begin(good, 0);
    app_compare_with(&s->v.app, APP_REFERENCE, 1.0);
    assert_string_equal(s->v.app.note, "nothing to compare with: start with --reference FILE");
    end(s);
}

/* The sphere's nearest point has 0.4: two stops and more make it too bright. */
static void pixels_that_are_clipped_are_marked_and_counted(void **state)
{
    stage *s = begin(good, 0);
    uint8_t *before = copy(see(s, "]]]]]]"));
    const uint8_t *p = see(s, "o");
    size_t above, below, magenta = 0, full = 0;

    (void)state;
    for (int i = WIDTH * HEIGHT / 2; i < WIDTH * HEIGHT; i++) {
        magenta += p[4 * i] == 255 && p[4 * i + 1] == 0 && p[4 * i + 2] == 255;
        full += before[4 * i] == 255;
    }
    session_count_clipped(s->v.session, &above, &below);
    assert_int_equal(below, 0);
    assert_true(magenta > 500 && magenta <= full && full - magenta < 100);
    assert_in_range(above, 2 * magenta - 100, 2 * magenta + 100);
    assert_true(at(p, WIDTH / 2, HEIGHT / 2 + 10)[2] == 255);
    /* Less exposure, none. */
    see(s, "[[[[[[");
    session_count_clipped(s->v.session, &above, &below);
    assert_int_equal(above, 0);
    assert_int_equal(differences(see(s, "o]]]]]]"), before), 0);
    free(before);
    end(s);
}

/* Three columns upon two, and one row upon two. */
static void pixels_are_the_mean_of_a_reference_on_their_area(void **state)
{
    float three[12] = { 0.0f, 0.0f, 0.0f, 1.0f, 3.0f, 0.0f, 0.0f, 1.0f, 6.0f, 9.0f, 0.0f, 1.0f };
    reference r = { .image = { sizeof r.image, 3, 1, 32, three } };

    (void)state;
    assert_true(reference_fit(&r, 2, 2));
    assert_true(reference_fits(&r, 2, 2) && !reference_fits(&r, 3, 1));
    for (int y = 0; y < 2; y++) {
        assert_true(reference_color(&r, 0, y)[0] == 1.0f && reference_color(&r, 0, y)[1] == 0.0f);
        assert_true(reference_color(&r, 1, y)[0] == 5.0f && reference_color(&r, 1, y)[1] == 6.0f);
    }
    assert_true(reference_fit(&r, 3, 1));
    assert_true(reference_color(&r, 0, 0) == three && !r.scaled);
    free(r.bytes);
}

/* A file of whole numbers holds nothing above 1: the picture is not blamed for what is. */
static void pixels_above_one_equal_one_of_a_file(void **state)
{
    float one[4] = { 1.0f, 0.0f, 0.5f, 1.0f }, color[4] = { 3.0f, -0.1f, 0.25f, 1.0f }, d[3];
    reference r = { .image = { sizeof r.image, 1, 1, 8, one }, .width = 1, .height = 1, .rgba = one };

    (void)state;
    reference_difference(&r, 0, 0, color, d);
    assert_true(d[0] == 0.0f && d[1] == 0.0f && d[2] == -0.25f);
    assert_true(reference_distance(d) == 0.25f);
    r.image.bits = 32;
    reference_difference(&r, 0, 0, color, d);
    assert_true(d[0] == 2.0f && d[1] == -0.1f && d[2] == -0.25f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pixels_magnify_and_leave_the_camera),
        cmocka_unit_test(pixels_have_numbers_of_six_characters),
        cmocka_unit_test(pixels_show_their_numbers),
        cmocka_unit_test(pixels_flip_to_the_reference_and_back),
        cmocka_unit_test(pixels_wipe_at_the_pointer),
        cmocka_unit_test(pixels_show_the_difference),
        cmocka_unit_test(pixels_of_another_size_are_compared_with_what_the_reference_has_there),
        cmocka_unit_test(pixels_are_the_mean_of_a_reference_on_their_area),
        cmocka_unit_test(pixels_that_are_clipped_are_marked_and_counted),
        cmocka_unit_test(pixels_above_one_equal_one_of_a_file),
    };

    return cmocka_run_group_tests_name("pixels of the viewer", tests, make_folder, remove_folder);
}
