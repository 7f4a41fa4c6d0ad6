/* shade/photons: caustics against closed forms. A picture's light is the mean over the rays that sample it. */
#include "support/check.h"
#include "support/scenes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A floor that lies across z at 2, seen from 1.5 on; `light` stands behind the sphere of glass at 0. */
#define FLOOR \
    "#version 3.7; global_settings { assumed_gamma 1 photons { max_trace_level 8 } }" \
    "camera { orthographic location <0,0,1.5> direction z right x*4 up y*3 }" \
    "box { <-9,-9,2>, <9,9,3> pigment { rgb 1 } finish { ambient 0 diffuse .8 } }"
#define SPHERE(photons) \
    "sphere { 0, 1 pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { ior 1.5 } photons { " photons " } }"
#define GLASS SPHERE("target refraction on")

enum { WIDTH = 480, HEIGHT = 360 };

static float red_at(const float *pixels, int x, int y) { return pixels[4 * (y * WIDTH + x)]; }

static double x_of(int x) { return (x + 0.5) * 4.0 / WIDTH - 2.0; }

static double y_of(int y) { return 1.5 - (y + 0.5) * 3.0 / HEIGHT; }

/* The mean of the picture's light between two circles around the middle. */
static double ring(const float *pixels, double inner, double outer)
{
    double sum = 0.0, count = 0.0;

    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            const double r = hypot(x_of(x), y_of(y));

            if (r >= inner && r < outer) {
                sum += (double)red_at(pixels, x, y);
                count += 1.0;
            }
        }
    return sum / count;
}

static void assert_ring(const float *pixels, double inner, double outer, double wanted, double tolerance)
{
    const double found = ring(pixels, inner, outer);

    if (!(fabs(found / wanted - 1.0) <= tolerance))
        fail_msg("%g instead of %g between %g and %g", found, wanted, inner, outer);
}

/* ---- the same by Snell's law: rays in a plane through the axis, as a pair of distances from the axis and along it ---- */

typedef struct pair { double y, z; } pair;

static pair refracted(pair d, pair normal, double eta)
{
    const double cosine = -(d.y * normal.y + d.z * normal.z);
    const double by = eta * cosine - sqrt(1.0 - eta * eta * (1.0 - cosine * cosine));
    const pair out = { eta * d.y + by * normal.y, eta * d.z + by * normal.z };

    return out;
}

/* The first distance at which the sphere is met. */
static double meets(pair p, pair d)
{
    const double b = p.y * d.y + p.z * d.z;

    return -b - sqrt(b * b - (p.y * p.y + p.z * p.z - 1.0));
}

static pair along(pair p, pair d, double t)
{
    const pair out = { p.y + t * d.y, p.z + t * d.z };

    return out;
}

/* How far from the axis a ray from p meets the floor, and how long its way was. */
static double land(pair p, pair d, double *way)
{
    const double enter = meets(p, d);
    const pair in = along(p, d, enter), inside = refracted(d, in, 1.0 / 1.5);
    const double across = -2.0 * (in.y * inside.y + in.z * inside.z);
    const pair out = along(in, inside, across), back = { -out.y, -out.z }, on = refracted(inside, back, 1.5);
    const double rest = (2.0 - out.z) / on.z;

    *way = enter + across + rest;
    return fabs(out.y + rest * on.y);
}

/* Light upon the floor between two circles, for a light of strength 1 at -distance on the axis: the mean. */
static double lens(double distance, double inner, double outer)
{
    const int steps = 200000;
    const double widest = asin(1.0 / distance), pi = 3.14159265358979323846;
    const pair from = { 0.0, -distance };
    double sum = 0.0;

    for (int i = 0; i < steps; i++) {
        const double angle = (i + 0.5) / steps * widest;
        const pair d = { sin(angle), cos(angle) };
        double way, r = land(from, d, &way);

        if (r >= inner && r < outer)
            sum += way * way * 2.0 * pi * sin(angle) * widest / steps;
    }
    return sum / (pi * (outer * outer - inner * inner));
}

/* ---- tests ---- */

static const double diffuse = 0.8;

static void a_sphere_throws_the_caustic_of_snells_law(void **state)
{
    static const double edges[] = { 0.15, 0.2, 0.25, 0.3, 0.4, 0.5, 0.7, 1.0 };
    float *p = scenes_draw(FLOOR GLASS "light_source { <0,0,-8> rgb .01 }", WIDTH, HEIGHT, 1, 0);

    (void)state;
    for (size_t i = 0; i + 1 < sizeof edges / sizeof *edges; i++)
        assert_ring(p, edges[i], edges[i + 1], diffuse * 0.01 * lens(8.0, edges[i], edges[i + 1]), 0.02);
    free(p);
}

static void the_caustic_holds_the_light_that_met_the_sphere(void **state)
{
    float *p = scenes_draw(FLOOR GLASS "light_source { <0,0,-8> rgb .01 }", WIDTH, HEIGHT, 1, 0);

    (void)state;
    assert_ring(p, 0.0, 1.0, diffuse * 0.01 * lens(8.0, 0.0, 1.0), 0.01);
    free(p);
}

/* The edge of the caustic of a near light, where light has no bound, is blurred. */
static void the_edge_of_a_caustic_is_sharp(void **state)
{
    float *p = scenes_draw(FLOOR GLASS "light_source { <0,0,-3> rgb .003 }", WIDTH, HEIGHT, 2, 0);

    (void)state;
    assert_ring(p, 0.0, 0.1, diffuse * 0.003 * lens(3.0, 0.0, 0.1), 0.03);
    assert_ring(p, 0.1, 0.15, diffuse * 0.003 * lens(3.0, 0.1, 0.15), 0.03);
    assert_ring(p, 0.15, 0.3, diffuse * 0.003 * lens(3.0, 0.15, 0.3), 0.02);
    free(p);
}

/* The lamp at <-2,0,-4> is mirrored at x = 2.2 to 6.4. */
static void a_flat_mirror_is_a_mirrored_lamp(void **state)
{
    static const char *const mirror = "box { <2.2,-3,-3>, <2.3,3,1> pigment { rgb 0 } "
                                      "finish { ambient 0 diffuse 0 reflection .6 } photons { target reflection on } }";
    char text[1024];
    float *p;
    double found = 0.0, wanted = 0.0;

    (void)state;
    snprintf(text, sizeof text, "%s %s light_source { <-2,0,-4> rgb .5 }", FLOOR, mirror);
    p = scenes_draw(text, WIDTH, HEIGHT, 1, 0);
    for (int y = 60; y < HEIGHT - 60; y++)
        for (int x = 0; x < WIDTH / 2; x++) {
            const double dx = x_of(x) + 2.0, far = x_of(x) - 6.4, dy = y_of(y);

            found += (double)red_at(p, x, y);
            wanted += 0.5 * diffuse * 6.0 * (1.0 / sqrt(dx * dx + dy * dy + 36.0) + 0.6 / sqrt(far * far + dy * dy + 36.0));
        }
    free(p);
    assert_true(fabs(found / wanted - 1.0) < 0.002);
}

/* A box of media that light goes straight through, as photons do; `light` comes along z. */
#define BOX(settings, medium) \
    "#version 3.7; global_settings { assumed_gamma 1 photons { " settings " } }" \
    "box { <-1.5,-1.5,-1>, <1.5,1.5,1> hollow pigment { rgbt 1 } finish { ambient 0 diffuse 0 }" \
    "interior { media { " medium " } } photons { target refraction on } }" \
    "box { <-9,-9,2>, <9,9,3> pigment { rgb 1 } finish { ambient 0 diffuse .8 } }"

/* The mean over a small picture, of what the cameras below have in their middle. */
static double middle(const char *text, uint32_t samples)
{
    enum { ACROSS = WIDTH / 4, DOWN = HEIGHT / 4 };
    float *p = scenes_draw(text, ACROSS, DOWN, samples, 0);
    double sum = 0.0;

    for (int i = 0; i < ACROSS * DOWN; i++)
        sum += (double)p[4 * i];
    free(p);
    return sum / (ACROSS * DOWN);
}

static void assert_middle(const char *text, double wanted, double tolerance)
{
    const double found = middle(text, 1);

    if (!(fabs(found / wanted - 1.0) <= tolerance))
        fail_msg("%g instead of %g", found, wanted);
}

#define ABOVE "camera { orthographic location <0,0,1.5> direction z right x up y*.75 }"
#define BESIDE "camera { orthographic location <0,-9,0> direction y right x up z*.75 }"

/* Media dim photons on each way to a surface, whether they light the media or not. */
static void media_dim_photons(void **state)
{
    (void)state;
    assert_middle(BOX("", "absorption .3") ABOVE "light_source { <0,0,-8> rgb .5 parallel point_at 0 }", 0.4 * exp(-0.6), 0.01);
    assert_middle(BOX("media 1", "scattering { 1, .3 }") ABOVE "light_source { <0,0,-8> rgb .5 parallel point_at 0 }",
                  0.4 * exp(-0.6), 0.01);
}

/* Three units of the box across the light; the last one fades on its way in, and is dimmed on its way out. */
static void photons_light_media(void **state)
{
    (void)state;
    assert_middle(BOX("media 1", "scattering { 1, .1 extinction 0 }") BESIDE "light_source { <0,0,-8> rgb .5 parallel point_at 0 }",
                  0.15, 0.02);
    assert_middle(BOX("media 1", "scattering { 1, .1 extinction 0 }") BESIDE "light_source { <0,0,-4> rgb .5 }", 0.15, 0.03);
    assert_middle(BOX("media 1", "scattering { 4, .1 extinction 0 }") BESIDE "light_source { <0,0,-8> rgb .5 parallel point_at 0 }",
                  0.15 * 0.7994, 0.02);
    assert_middle(BOX("media 1", "scattering { 1, .2 extinction .5 }") BESIDE "light_source { <0,0,-8> rgb .5 parallel point_at 0 }",
                  (exp(-0.0625) - exp(-0.1375)) / 0.075 * (1.0 - exp(-0.3)), 0.02);
}

static void without_the_setting_media_behind_a_target_are_dark(void **state)
{
    (void)state;
    assert_true(middle(BOX("", "scattering { 1, .1 extinction 0 }") BESIDE "light_source { <0,0,-8> rgb .5 parallel point_at 0 }", 1) == 0.0);
    assert_true(middle(BOX("media 0", "scattering { 1, .1 }") BESIDE "light_source { <0,0,-8> rgb .5 parallel point_at 0 }", 1) == 0.0);
}

/* What arrives at the inside of glass does not light what lies close to the glass. */
static void photons_within_a_solid_light_it_alone(void **state)
{
    (void)state;
    assert_middle("#version 3.7; global_settings { assumed_gamma 1 photons { } }"
                  "box { <-1.5,-1.5,-1>, <1.5,1.5,1.9998> pigment { rgbt 1 } finish { ambient 0 diffuse .5 } photons { target refraction on } }"
                  "box { <-9,-9,2>, <9,9,3> pigment { rgb 1 } finish { ambient 0 diffuse .8 } }"
                  "camera { orthographic location <0,0,1.9999> direction z right x up y*.75 }"
                  "light_source { <0,0,-8> rgb .5 parallel point_at 0 }", 0.4, 0.01);
}

static void assert_alike(const char *a, const char *b)
{
    float *one = scenes_draw(a, WIDTH, HEIGHT, 1, 0), *other = scenes_draw(b, WIDTH, HEIGHT, 1, 0);

    assert_memory_equal(one, other, 4 * sizeof(float) * WIDTH * HEIGHT);
    free(one);
    free(other);
}

static void without_targets_light_passes_as_ever(void **state)
{
    static const char *const lamp = "light_source { <0,1,-8> rgb .5 }";
    char a[1024], b[1024];

    (void)state;
    snprintf(a, sizeof a, "%s%s%s", FLOOR, SPHERE("refraction on"), lamp);
    snprintf(b, sizeof b, "%s%s%s", FLOOR, SPHERE(""), lamp);
    assert_alike(a, b);
    snprintf(a, sizeof a, "%s%s light_source { <0,1,-8> rgb .5 photons { refraction off } }", FLOOR, GLASS);
    assert_alike(a, b);
}

static void where_no_photons_are_collected_light_comes_straight(void **state)
{
    static const char *const floor = "#version 3.7; global_settings { assumed_gamma 1 photons { } }"
        "camera { orthographic location <0,0,1.5> direction z right x*4 up y*3 }"
        "box { <-9,-9,2>, <9,9,3> pigment { rgb 1 } finish { ambient 0 diffuse .8 } photons { collect off } }";
    static const char *const lamp = "light_source { <0,1,-8> rgb .5 }";
    char a[1024], b[1024];

    (void)state;
    snprintf(a, sizeof a, "%s%s%s", floor, GLASS, lamp);
    snprintf(b, sizeof b, "%s%s%s", FLOOR, SPHERE(""), lamp);
    assert_alike(a, b);
}

static void photons_that_cannot_leave_the_target_leave_it_dark(void **state)
{
    static const char *const floor = "#version 3.7; global_settings { assumed_gamma 1 photons { max_trace_level 2 } }"
        "camera { orthographic location <0,0,1.5> direction z right x*4 up y*3 }"
        "box { <-9,-9,2>, <9,9,3> pigment { rgb 1 } finish { ambient 0 diffuse .8 } }";
    char text[1024];
    float *p;

    (void)state;
    snprintf(text, sizeof text, "%s%s light_source { <0,0,-8> rgb .5 }", floor, GLASS);
    p = scenes_draw(text, WIDTH, HEIGHT, 1, 0);
    assert_true(ring(p, 0.0, 1.0) == 0.0);
    free(p);
}

/* As many maps as there are halves and levels of three samples. */
static void the_number_of_threads_changes_no_bit(void **state)
{
    static const char *const text = FLOOR GLASS "light_source { <0,0,-8> rgb .01 }";
    float *one = scenes_draw(text, 40, 30, 5, 1);

    (void)state;
    for (int threads = 2; threads <= 4; threads++) {
        float *many = scenes_draw(text, 40, 30, 5, threads);

        assert_memory_equal(one, many, 4 * sizeof(float) * 40 * 30);
        free(many);
    }
    free(one);
}

/* ---- errors ---- */

/* A piece of the caustic that is a few discs wide, where light is smooth. */
#define PIECE \
    "#version 3.7; global_settings { assumed_gamma 1 photons { max_trace_level 8 } }" \
    "camera { orthographic location <.6,0,1.5> direction z right x*.1 up y*.075 }" \
    "box { <-9,-9,2>, <9,9,3> pigment { rgb 1 } finish { ambient 0 diffuse .8 } }" GLASS "light_source { <0,0,-8> rgb 1 }"

enum { SEEDS = 12, COLUMNS = 32, ROWS = 24, PIECES = COLUMNS * ROWS };

/* The red of a picture of so many samples a pixel; returns the error that is told. */
static double draw_piece(const pov_scene *scene, int samples, uint32_t seed, double *red)
{
    pov_render_desc desc = POV_INIT(desc);
    pov_pass row = POV_INIT(row);
    pov_job *job;
    static float rgba[4 * PIECES];
    const pov_rect all = { 0, 0, COLUMNS, ROWS };

    desc.width = COLUMNS;
    desc.height = ROWS;
    desc.samples = samples;
    desc.seed = seed;
    assert_int_equal(pov_job_create(&job, scene, &desc, NULL), POV_OK);
    assert_int_equal(pov_job_start(job, NULL), POV_OK);
    while (pov_job_wait(job, 10.0) == POV_JOB_RUNNING)
        continue;
    for (size_t i = 0; pov_job_get_pass(job, i, &row); i++)
        continue;
    pov_job_read(job, all, POV_PIXELS_LINEAR_FLOAT, rgba, 4 * COLUMNS * sizeof *rgba);
    pov_job_destroy(job);
    for (int i = 0; i < PIECES; i++)
        red[i] = (double)rgba[4 * i];
    return row.est_rmse;
}

static void each_seed_has_photons_of_its_own_and_the_error_tells_it(void **state)
{
    static double red[SEEDS][PIECES];
    pov_context *context = scenes_context();
    pov_scene *scene = scenes_text(context, PIECE);
    double told = 0.0, square = 0.0;

    (void)state;
    for (int k = 0; k < SEEDS; k++)
        told += pow(draw_piece(scene, 2, (uint32_t)k, red[k]), 2.0) / SEEDS;
    for (int i = 0; i < PIECES; i++) {
        double mean = 0.0;

        for (int k = 0; k < SEEDS; k++)
            mean += red[k][i] / SEEDS;
        for (int k = 0; k < SEEDS; k++)
            square += pow(red[k][i] - mean, 2.0) / ((SEEDS - 1.0) * PIECES);
    }
    pov_scene_destroy(scene);
    pov_context_destroy(context);
    if (!(told > 0.64 * square && told < 1.5625 * square))
        fail_msg("told %g, found %g", sqrt(told), sqrt(square));
}

/* The middle of the caustic, where the light of a ring gathers in a point within a pixel, and its square has no finite mean. */
#define MIDDLE \
    "#version 3.7; global_settings { assumed_gamma 1 photons { max_trace_level 8 } }" \
    "camera { %s z right x*1.9 up y*1.425 }" \
    "box { <-9,-9,2>, <9,9,3> pigment { rgb 1 } finish { ambient 0 diffuse .8 } }" GLASS "light_source { <0,0,-8> rgb .01 }"

static void no_chance_decides_where_light_gathers(const char *camera)
{
    static double red[SEEDS][PIECES];
    pov_context *context = scenes_context();
    pov_scene *scene;
    double mean = 0.0;
    char text[2000];
    size_t brightest = 0;

    snprintf(text, sizeof text, MIDDLE, camera);
    scene = scenes_text(context, text);
    for (int k = 0; k < 4; k++)
        draw_piece(scene, 2, (uint32_t)k, red[k]);
    for (size_t i = 0; i < PIECES; i++)
        brightest = red[0][i] > red[0][brightest] ? i : brightest;
    for (int k = 0; k < 4; k++)
        mean += red[k][brightest] / 4;
    for (int k = 0; k < 4; k++)
        if (!(fabs(red[k][brightest] - mean) < 0.02 * mean))
            fail_msg("%s: seed %d has %g where the mean is %g", camera, k, red[k][brightest], mean);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
}

static void where_light_gathers_in_a_point_a_pixel_counts_photons(void **state)
{
    (void)state;
    no_chance_decides_where_light_gathers("orthographic location <.017,.023,1.5> direction");
    no_chance_decides_where_light_gathers("location <.017,.023,1.1> direction");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_sphere_throws_the_caustic_of_snells_law),
        cmocka_unit_test(the_caustic_holds_the_light_that_met_the_sphere),
        cmocka_unit_test(the_edge_of_a_caustic_is_sharp),
        cmocka_unit_test(a_flat_mirror_is_a_mirrored_lamp),
        cmocka_unit_test(without_targets_light_passes_as_ever),
        cmocka_unit_test(where_no_photons_are_collected_light_comes_straight),
        cmocka_unit_test(photons_that_cannot_leave_the_target_leave_it_dark),
        cmocka_unit_test(media_dim_photons),
        cmocka_unit_test(photons_light_media),
        cmocka_unit_test(photons_within_a_solid_light_it_alone),
        cmocka_unit_test(without_the_setting_media_behind_a_target_are_dark),
        cmocka_unit_test(the_number_of_threads_changes_no_bit),
        cmocka_unit_test(each_seed_has_photons_of_its_own_and_the_error_tells_it),
        cmocka_unit_test(where_light_gathers_in_a_point_a_pixel_counts_photons),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
