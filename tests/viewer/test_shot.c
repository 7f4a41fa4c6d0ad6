/* The whole viewer on OSMesa, without a display: what it draws, pixel by pixel. */
#include "maps.h"
#include "stage.h"

#include <povtrace/image.h>

#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

static const char wrong[] = "#version 3.7; global_settings { assumed_gamma 1 }\n"
                            "camera { location <0, 0, -5> look_at 0 }\n"
                            "sphere { 0, 1 pigmnet { rgb <1, 0, 0> } }\n";
static const char green[] = "#version 3.7; global_settings { assumed_gamma 1 }\n"
                            "camera { location <0, 0, -9> look_at 0 }\n"
                            "light_source { <0, 0, -50> rgb 1 }\n"
                            "sphere { 0, 1 pigment { rgb <0, 1, 0> } finish { ambient 0 diffuse .4 } }\n";

/* The picture as a program that has no viewer gets it. */
static uint8_t *plain_picture(const char *text)
{
    pov_context *context = scenes_context();
    pov_scene *scene = scenes_text(context, text);
    pov_render_desc d = POV_INIT(d);
    pov_rect all = { 0, 0, WIDTH, HEIGHT };
    uint8_t *pixels = malloc(WIDTH * HEIGHT * 4);
    pov_job *job;

    assert_non_null(pixels);
    d.width = WIDTH;
    d.height = HEIGHT;
    assert_int_equal(pov_job_create(&job, scene, &d, NULL), POV_OK);
    while (pov_job_step(job) == POV_JOB_RUNNING)
        continue;
    pov_job_read(job, all, POV_PIXELS_DISPLAY8, pixels, WIDTH * 4);
    pov_job_destroy(job);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
    return pixels;
}

static void shot_is_the_plain_picture_bit_for_bit(void **state)
{
    uint8_t *plain = plain_picture(good);
    stage *s = begin(good, 0);

    (void)state;
    assert_int_equal(differences(see(s, ""), plain), 0);
    assert_true(at(plain, WIDTH / 2, HEIGHT / 2)[0] > 100);
    free(plain);
    end(s);
}

static void shot_after_one_pass_is_squares_of_sixteen(void **state)
{
    stage *s = begin(good, 1);
    const uint8_t *p = see(s, "");

    (void)state;
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            assert_memory_equal(at(p, x, y), at(p, x - x % 16, y - y % 16), 4);
    assert_true(at(p, WIDTH / 2, HEIGHT / 2)[0] > 100);
    end(s);
}

static void shot_after_five_passes_is_the_whole_picture(void **state)
{
    uint8_t *plain = plain_picture(good);
    stage *s = begin(good, 5);

    (void)state;
    assert_int_equal(differences(see(s, ""), plain), 0);
    free(plain);
    end(s);
}

static void shot_shows_help_over_the_picture_and_takes_it_away(void **state)
{
    stage *s = begin(good, 0);
    uint8_t *before = copy(see(s, ""));
    const uint8_t *p = see(s, "h");
    int bright = 0;

    (void)state;
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        bright += p[4 * i] > 180 && p[4 * i + 1] > 180 && p[4 * i + 2] > 180;
    assert_true(bright > 300);
    assert_int_equal(differences(see(s, "h"), before), 0);
    free(before);
    end(s);
}

/* The last rows of a help that is taller than the window come into it, and the panel stays inside. */
static void shot_scrolls_a_help_that_does_not_fit(void **state)
{
    stage *s = begin(good, 0);
    uint8_t *first = copy(see(s, "h"));

    (void)state;
    assert_true(overlay_help_below(&s->v.overlay) > HEIGHT);
    assert_color(at(first, 2, 2), 0, 0, 0, 0);
    assert_color(at(first, 2, HEIGHT - 3), 0, 0, 0, 0);
    assert_true(differences(first, see(s, "<wheel -1>")) > 500);
    see(s, "<wheel -1000>");
    assert_true(s->v.app.help_from == (double)overlay_help_below(&s->v.overlay));
    assert_true(differences(first, see(s, "<wheel 1000>")) == 0);
    free(first);
    end(s);
}

/* The scene's file is another: the clock goes on, so that it is looked at. */
static void save(stage *s, const char *text)
{
    static time_t second = 1000000;
    struct timespec times[2] = { { 0, 0 }, { 0, 0 } };

    /* A file that is written twice within the clock's grain would look the same. */
    write_scene(text);
    times[0].tv_sec = times[1].tv_sec = second++;
    assert_int_equal(utimensat(AT_FDCWD, scene_path, times, 0), 0);
    for (int i = 0; i < 3; i++) {
        s->v.fixed_clock += 1.0;
        viewer_step(&s->v);
    }
    shot_settle(&s->v);
}

static void shot_keeps_the_last_good_picture_under_the_message(void **state)
{
    stage *s = begin(good, 0);
    uint8_t *before = copy(see(s, ""));
    const uint8_t *p;

    (void)state;
    save(s, wrong);
    assert_non_null(session_error(s->v.session));
    assert_int_equal(session_error(s->v.session)->line, 3);
    p = see(s, "");
    assert_memory_equal(p, before, WIDTH * 60 * 4);
    assert_true(differences(p, before) > 3000);
    save(s, good);
    assert_null(session_error(s->v.session));
    assert_int_equal(differences(see(s, ""), before), 0);
    free(before);
    end(s);
}

static void shot_follows_the_file_and_its_camera_until_the_user_moves(void **state)
{
    stage *s = begin(good, 0);
    double distance;

    (void)state;
    see(s, "");
    save(s, green);
    assert_true(at(see(s, ""), WIDTH / 2, HEIGHT / 2)[1] > 100);
    assert_true(app_camera(&s->v.app).location.z == -9.0);
    see(s, "<drag 40,0>");
    distance = app_camera(&s->v.app).location.x;
    save(s, good);
    assert_true(at(see(s, ""), WIDTH / 2, HEIGHT / 2)[0] > 100);
    assert_true(app_camera(&s->v.app).location.x == distance && distance < 0.0);
    see(s, "r");
    assert_true(app_camera(&s->v.app).location.z == -5.0);
    end(s);
}

static void write_as(const char *name, const char *text)
{
    FILE *f = fopen(name, "w");

    assert_non_null(f);
    assert_true(fputs(text, f) >= 0);
    assert_int_equal(fclose(f), 0);
}

static void shot_goes_over_to_another_scene_and_its_camera(void **state)
{
    stage *s = begin(good, 0);

    (void)state;
    see(s, "<drag 100,0>");
    write_as("other.pov", green);
    session_open_scene(s->v.session, "other.pov");
    assert_color(at(see(s, ""), WIDTH / 2, HEIGHT / 2), 0, 170, 0, 40);
    see(s, "");
    assert_string_equal(s->v.title, "other.pov: done in 0.0 s");
    /* The last one that was asked for counts, whatever was on its way. */
    session_load(s->v.session, scene_path);
    session_open_scene(s->v.session, "nowhere.pov");
    session_open_scene(s->v.session, scene_path);
    assert_color(at(see(s, ""), WIDTH / 2, HEIGHT / 2), 170, 0, 0, 40);
    assert_null(session_error(s->v.session));
    end(s);
}

static void shot_keeps_the_picture_when_another_scene_cannot_be_read(void **state)
{
    stage *s = begin(good, 0);
    uint8_t *before = copy(see(s, ""));

    (void)state;
    session_open_scene(s->v.session, "nowhere.pov");
    assert_color(at(see(s, ""), WIDTH / 2, HEIGHT / 2), before[4 * (HEIGHT / 2 * WIDTH + WIDTH / 2)], 0, 0, 2);
    assert_non_null(session_error(s->v.session));
    write_as("other.pov", green);
    session_open_scene(s->v.session, "other.pov");
    see(s, "");
    assert_null(session_error(s->v.session));
    free(before);
    end(s);
}

static void shot_of_a_wrong_scene_shows_why_and_waits_for_a_better_one(void **state)
{
    stage *s = begin(wrong, 0);

    (void)state;
    assert_false(s->v.app.has_scene);
    assert_non_null(session_error(s->v.session));
    see(s, "h");
    save(s, good);
    assert_true(at(see(s, "h"), WIDTH / 2, HEIGHT / 2)[0] > 100);
    end(s);
}

static void shot_shows_normals_and_depth(void **state)
{
    stage *s = begin(good, 0);
    uint8_t *picture = copy(see(s, ""));
    const uint8_t *p = see(s, "<tab>");

    (void)state;
    /* The sphere's nearest point looks along -z, its left side along -x. */
    assert_color(at(p, WIDTH / 2, HEIGHT / 2), 128, 128, 0, 3);
    assert_true(at(p, WIDTH / 2 - 40, HEIGHT / 2)[0] < 60);
    assert_color(at(p, 5, 5), 0, 0, 0, 0);
    p = see(s, "<tab>");
    /* The middle is at the pivot's depth. */
    assert_color(at(p, WIDTH / 2, HEIGHT / 2), 128, 128, 128, 2);
    assert_true(at(p, WIDTH / 2 - 40, HEIGHT / 2)[0] < 128);
    assert_int_equal(differences(see(s, "<tab><tab><tab><tab><tab>"), picture), 0);
    free(picture);
    end(s);
}

static int brightness(const uint8_t *pixel)
{
    return pixel[0] + pixel[1] + pixel[2];
}

static void shot_shows_where_the_samples_and_the_error_are(void **state)
{
    stage *s = begin_with(good, 0, 16);
    const uint8_t *p = see(s, "<tab><tab><tab>");
    char title[200];
    int most = 0;

    (void)state;
    /* The sphere's edge, right of the middle by a fifth of the height and some, against the ground below. */
    assert_int_equal(s->v.app.view, APP_SAMPLES);
    assert_true(brightness(at(p, 160 + 48, 120)) > brightness(at(p, 40, 200)) + 50);
    p = see(s, "<tab><tab>");
    assert_int_equal(s->v.app.view, APP_ERROR);
    /* Below the legend: of the cells at the sphere's edge some differ from what half of the samples say, some by chance
     * do not. */
    for (int i = WIDTH * 90; i < WIDTH * HEIGHT; i++)
        most = brightness(at(p, i % WIDTH, i / WIDTH)) > most ? brightness(at(p, i % WIDTH, i / WIDTH)) : most;
    assert_true(most > brightness(at(p, 40, 200)) + 50);
    session_title(s->v.session, title, sizeof title);
    assert_non_null(strstr(title, "done"));
    assert_non_null(strstr(title, "16.0 samples, error "));
    end(s);
}

/* The mean brightness of a square of pixels. */
static double brightness_of(const uint8_t *pixels, int left, int top)
{
    enum { EDGE = 32 };
    double sum = 0.0;

    for (int i = 0; i < EDGE * EDGE; i++)
        sum += brightness(at(pixels, left + i % EDGE, top + i / EDGE));
    return sum / (EDGE * EDGE);
}

/* The least of squares at the left and right edges, where nothing is: a thread that had to wait makes some of them bright. */
static double least_brightness_of_nothing(const uint8_t *pixels)
{
    double least = 1e9;

    for (int top = 8; top + 32 < HEIGHT; top += 32)
        least = fmin(least, fmin(brightness_of(pixels, 8, top), brightness_of(pixels, WIDTH - 40, top)));
    return least;
}

/* Pixels of a sphere with light and shadow take more of the processor than those of nothing. */
static void shot_shows_where_the_time_went(void **state)
{
    stage *s = begin_with(good, 0, 16);
    const uint8_t *p = see(s, "<tab><tab><tab><tab>");
    session_place place;
    char text[1000];

    (void)state;
    assert_int_equal(s->v.app.view, APP_TIME);
    assert_true(brightness_of(p, WIDTH / 2 - 16, HEIGHT / 2 - 16) > least_brightness_of_nothing(p) + 30.0);
    see(s, "<move 160,120>");
    assert_true(session_inspect(s->v.session, &place));
    assert_true(place.seconds > 1e-7f && place.seconds < 0.1f);
    overlay_write_place(&place, text, sizeof text);
    assert_non_null(strstr(text, "|time\t"));
    end(s);
}

static void shot_shows_the_curve_of_error_against_time(void **state)
{
    stage *s = begin_with(good, 0, 16);
    uint8_t *before = copy(see(s, ""));
    const uint8_t *p = see(s, "g");
    int orange = 0;

    (void)state;
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        orange += p[4 * i] > 200 && p[4 * i + 1] > 120 && p[4 * i + 1] < 220 && p[4 * i + 2] < 120;
    assert_true(orange > 30);
    assert_int_equal(differences(see(s, "g"), before), 0);
    free(before);
    end(s);
}

static bool panels_are_apart(const overlay *o)
{
    for (int i = 1; i < PRESENT_PANELS; i++)
        for (int j = i + 1; j < PRESENT_PANELS; j++)
            if (o->panels[i].pixels && o->panels[j].pixels && o->x[i] < o->x[j] + o->panels[j].width && o->x[j] < o->x[i] + o->panels[i].width
                && o->y[i] < o->y[j] + o->panels[j].height && o->y[j] < o->y[i] + o->panels[i].height)
                return false;
    return true;
}

/* The inspector lay upon the curve where the pointer was in the curve's corner. */
static void defect_8_panels_lie_apart(void **state)
{
    static const char *const pointers[] = { "<move 700,400>", "<move 780,590>", "<move 20,20>", "<move 790,10>", "<move 10,590>" };
    stage *s = begin_with(good, 0, 16);

    (void)state;
    see(s, "<size 800,600>gi");
    for (size_t i = 0; i < sizeof pointers / sizeof *pointers; i++) {
        see(s, pointers[i]);
        if (!panels_are_apart(&s->v.overlay))
            fail_msg("%s", pointers[i]);
    }
    end(s);
}

static void shot_shows_what_double_decided(void **state)
{
    stage *s = begin(good, 0);
    const uint8_t *p = see(s, "<tab><tab><tab><tab><tab><tab>");
    size_t certain, uncertain, seen = 0;
    pov_hit hit = POV_INIT(hit);
    maps_request request = { .kind = MAPS_CERTAINTY };
    uint8_t color[4];

    (void)state;
    assert_int_equal(s->v.app.view, APP_CERTAINTY);
    assert_color(at(p, WIDTH / 2, HEIGHT / 2), 90, 130, 220, 1);
    assert_color(at(p, 5, 5), 0, 0, 0, 0);
    /* The shape is seen: darker to its edge. Pixels are counted; those of the sphere's lower half lie below the legend. */
    assert_true(at(p, WIDTH / 2, HEIGHT / 2 + 44)[2] < 160);
    session_count_certain(s->v.session, &certain, &uncertain);
    assert_int_equal(uncertain, 0);
    for (int i = WIDTH * HEIGHT / 2; i < WIDTH * HEIGHT; i++)
        seen += p[4 * i + 2] > 0;
    assert_in_range(2 * seen, certain - 100, certain + 100);
    hit.normal = pov_vec3_of(0, 0, -3);
    maps_color(&request, pov_vec3_of(0, 0, 2), &hit, color);
    assert_true(color[0] == 255 && color[1] == 150 && color[2] == 30);
    maps_color(&request, pov_vec3_of(2, 0, 0), &hit, color);
    assert_true(color[0] == 77 && color[1] == 45 && color[2] == 9);
    end(s);
}

static void shot_exposes_by_thirds_of_a_stop(void **state)
{
    stage *s = begin(good, 0);
    uint8_t *before = copy(see(s, ""));
    double linear = 0.4 * 2.0, stored = 255.0 * (1.055 * pow(linear, 1.0 / 2.4) - 0.055);

    (void)state;
    assert_color(at(see(s, "]]]"), WIDTH / 2, HEIGHT / 2), (int)(stored + 0.5), 0, 0, 1);
    assert_int_equal(differences(see(s, "[[["), before), 0);
    free(before);
    end(s);
}

/* A camera that sees a small part of the sphere: A shows it whole, as high as the margin leaves, and F too. */
static void shot_frames_all_and_what_is_under_the_pointer(void **state)
{
    static const char near[] = "#version 3.7; global_settings { assumed_gamma 1 }\n"
                               "camera { location <0.3, 0.2, -1.2> direction z right x*4/3 up y }\n"
                               "light_source { <0, 0, -50> rgb 1 }\n"
                               "sphere { 0, 1 pigment { rgb <1, 0, 0> } finish { ambient 1 diffuse 0 } }\n"
                               "sphere { <30, 0, 40>, 1 pigment { rgb <0, 1, 0> } }\n";
    stage *s = begin(near, 0);
    const uint8_t *p = see(s, "<move 160,120>f");

    (void)state;
    assert_color(at(p, WIDTH / 2, HEIGHT / 2), 255, 0, 0, 0);
    assert_color(at(p, WIDTH / 2, 3), 0, 0, 0, 0);
    assert_color(at(p, 3, HEIGHT / 2), 0, 0, 0, 0);
    /* The margin is a twentieth of what is seen; two are left for what a grid of rays misses. */
    assert_color(at(p, WIDTH / 2, HEIGHT / 5), 255, 0, 0, 0);
    p = see(s, "a");
    assert_color(at(p, WIDTH / 2, 3), 0, 0, 0, 0);
    assert_true(s->v.app.orbit.camera.location.z < -20.0);
    end(s);
}

static void shot_drag_shows_another_side(void **state)
{
    stage *s = begin(good, 0);
    uint8_t *before = copy(see(s, ""));

    (void)state;
    /* The light stays where it is, so the sphere's shadow side comes round; the sphere keeps its place. */
    assert_true(differences(see(s, "<drag 80,0>"), before) > 1000);
    assert_int_equal(differences(see(s, "<enter>"), before), 0);
    free(before);
    end(s);
}

static void shot_takes_another_size(void **state)
{
    stage *s = begin(good, 0);
    const uint8_t *p;

    (void)state;
    see(s, "");
    p = see(s, "<size 200,240>");
    assert_int_equal(s->v.app.width, 200);
    /* As high as before, and round still: the sphere's edge is as far from the middle across as down. */
    for (int r = 1; r < 90; r++)
        assert_true(abs(p[4 * (120 * 200 + 100 + r)] - p[4 * ((120 + r) * 200 + 100)]) < 60);
    assert_true(p[4 * (120 * 200 + 100)] > 100);
    end(s);
}

static void shot_inspects_what_is_under_the_pointer(void **state)
{
    stage *s = begin(good, 0);
    uint8_t *before = copy(see(s, ""));
    session_place place;
    char text[1000];

    (void)state;
    assert_true(differences(see(s, "<move 160,120>i"), before) > 3000);
    assert_true(session_inspect(s->v.session, &place));
    assert_true(place.hit && place.line == 4);
    assert_string_equal(place.keyword, "sphere");
    assert_true(fabs(place.distance - 4.0) < 0.01 && fabs(place.normal.z + 1.0) < 0.01);
    assert_true(fabs((double)place.color[0] - 0.4) < 0.01);
    overlay_write_place(&place, text, sizeof text);
    assert_non_null(strstr(text, "#sphere, line 4\n"));
    assert_int_equal(place.hits, 2);
    assert_non_null(strstr(text, "|hits\t2 on the way\n"));
    see(s, "<move 2,2>");
    assert_true(session_inspect(s->v.session, &place));
    assert_false(place.hit);
    free(before);
    end(s);
}

static char *read_file(const char *path, size_t *size)
{
    FILE *f = fopen(path, "rb");
    char *bytes = malloc(1 << 20);

    if (!f || !bytes)
        fail_msg("there is no %s", path);
    *size = fread(bytes, 1, 1 << 20, f);
    fclose(f);
    return bytes;
}

static void shot_snapshot_is_the_file_that_povc_writes(void **state)
{
    pov_context *context = scenes_context();
    pov_scene *scene = scenes_text(context, good);
    stage *s = begin(good, 0);
    pov_render_desc d = POV_INIT(d);
    pov_image_options options = POV_INIT(options);
    float *rgba;
    char *saved, *wanted;
    size_t saved_size, wanted_size;

    (void)state;
    d.width = WIDTH;
    d.height = HEIGHT;
    options.transfer = POV_TRANSFER_SRGB;
    rgba = scenes_render(scene, &d);
    assert_int_equal(pov_image_write(context, "wanted.png", WIDTH, HEIGHT, rgba, WIDTH * 4 * sizeof *rgba, &options,
                                     NULL), POV_OK);
    see(s, "s");
    wanted = read_file("wanted.png", &wanted_size);
    saved = read_file("scene-001.png", &saved_size);
    assert_int_equal(saved_size, wanted_size);
    assert_memory_equal(saved, wanted, wanted_size);
    free(saved);
    /* The next one takes the next number. */
    see(s, "s");
    saved = read_file("scene-002.png", &saved_size);
    assert_memory_equal(saved, wanted, wanted_size);
    free(saved);
    free(wanted);
    free(rgba);
    end(s);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
}

static void shot_pause_stops_the_picture_and_lets_it_go_on(void **state)
{
    stage *s = begin(good, 0);
    uint8_t *before = copy(see(s, ""));

    (void)state;
    /* Paused, a restart shows nothing of the new side; unpaused it does. */
    assert_int_equal(differences(see(s, "p<drag 80,0>"), before), 0);
    assert_true(differences(see(s, "p"), before) > 1000);
    free(before);
    end(s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shot_is_the_plain_picture_bit_for_bit),
        cmocka_unit_test(shot_after_one_pass_is_squares_of_sixteen),
        cmocka_unit_test(shot_after_five_passes_is_the_whole_picture),
        cmocka_unit_test(shot_shows_help_over_the_picture_and_takes_it_away),
        cmocka_unit_test(shot_scrolls_a_help_that_does_not_fit),
        cmocka_unit_test(shot_keeps_the_last_good_picture_under_the_message),
        cmocka_unit_test(shot_follows_the_file_and_its_camera_until_the_user_moves),
        cmocka_unit_test(shot_goes_over_to_another_scene_and_its_camera),
        cmocka_unit_test(shot_keeps_the_picture_when_another_scene_cannot_be_read),
        cmocka_unit_test(shot_of_a_wrong_scene_shows_why_and_waits_for_a_better_one),
        cmocka_unit_test(shot_shows_normals_and_depth),
        cmocka_unit_test(shot_shows_where_the_samples_and_the_error_are),
        cmocka_unit_test(shot_shows_where_the_time_went),
        cmocka_unit_test(shot_shows_the_curve_of_error_against_time),
        cmocka_unit_test(defect_8_panels_lie_apart),
        cmocka_unit_test(shot_shows_what_double_decided),
        cmocka_unit_test(shot_exposes_by_thirds_of_a_stop),
        cmocka_unit_test(shot_frames_all_and_what_is_under_the_pointer),
        cmocka_unit_test(shot_drag_shows_another_side),
        cmocka_unit_test(shot_takes_another_size),
        cmocka_unit_test(shot_inspects_what_is_under_the_pointer),
        cmocka_unit_test(shot_snapshot_is_the_file_that_povc_writes),
        cmocka_unit_test(shot_pause_stops_the_picture_and_lets_it_go_on),
    };

    return cmocka_run_group_tests_name("the viewer without a display", tests, make_folder, remove_folder);
}
