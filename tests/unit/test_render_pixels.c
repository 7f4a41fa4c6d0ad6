/* From pixels to rays, samples within them, tiles around them, and the frame that holds them. */
#include "support/near.h"

#include "model/camera_mesh.h"
#include "render/camera.h"
#include "render/framebuffer.h"
#include "render/raygen.h"
#include "render/sample.h"
#include "render/tiles.h"
#include "shade/tracer.h"

#include <stdlib.h>
#include <string.h>

static env libc_env(void)
{
    env e;

    env_init(&e, NULL, NULL, NULL);
    return e;
}

static pov_camera a_camera(void)
{
    pov_camera c = POV_INIT(c);

    c.location = pov_vec3_of(1.0, 2.0, 3.0);
    c.direction = pov_vec3_of(0.0, 0.0, 1.0);
    c.right = pov_vec3_of(2.0, 0.0, 0.0);
    c.up = pov_vec3_of(0.0, 1.5, 0.0);
    return c;
}

/* ---- rays ---- */

static void a_ray_goes_through_the_centre_of_its_pixel(void **state)
{
    pov_camera c = a_camera();
    pov_ray ray = raygen_ray(&c, 4, 3, 0, 0, 0.5, 0.5);
    (void)state;

    assert_near(ray.org.y, 2.0, 0.0);
    assert_near(ray.dir.x, 2.0 * (0.5 / 4 - 0.5), 1e-15);
    assert_near(ray.dir.y, 1.5 * (0.5 - 0.5 / 3), 1e-15);
    assert_near(ray.dir.z, 1.0, 0.0);
    assert_int_equal(ray.origin_surface, POV_NO_OWNER);
    assert_near(ray.org_lo.x + ray.dir_lo.x, 0.0, 0.0);
}

static void rays_are_symmetric_bit_for_bit(void **state)
{
    pov_camera c = a_camera();
    (void)state;

    for (int x = 0; x < 1021; x++) {
        pov_ray a = raygen_ray(&c, 1021, 1021, x, x, 0.5, 0.5);
        pov_ray b = raygen_ray(&c, 1021, 1021, 1020 - x, 1020 - x, 0.5, 0.5);
        assert_near(a.dir.x, -b.dir.x, 0.0);
        assert_near(a.dir.y, -b.dir.y, 0.0);
    }
}

static void orthographic_rays_are_parallel(void **state)
{
    pov_camera c = a_camera();
    pov_ray first, last;
    (void)state;

    c.type = POV_CAMERA_ORTHOGRAPHIC;
    first = raygen_ray(&c, 4, 3, 0, 0, 0.5, 0.5);
    last = raygen_ray(&c, 4, 3, 3, 2, 0.5, 0.5);
    assert_memory_equal(&first.dir, &c.direction, sizeof first.dir);
    assert_memory_equal(&last.dir, &c.direction, sizeof last.dir);
    assert_near(first.org.x, 1.0 + 2.0 * (0.5 / 4 - 0.5), 1e-15);
    assert_near(first.org.y, 2.0 + 1.5 * (0.5 - 0.5 / 3), 1e-15);
    assert_near(last.org.x, 1.0 - 2.0 * (0.5 / 4 - 0.5), 1e-15);
    assert_near(last.org.z, 3.0, 0.0);
    assert_int_equal(last.origin_surface, POV_NO_OWNER);
}

/* Two faces whose surface coordinates fill the square, in the plane z = 0. */
static const camera_uv_face square[2] = {
    { { { 0, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 } }, { { 0, 0, 1 }, { 0, 0, 1 }, { 0, 0, 1 } }, { { 0, 0 }, { 0, 1 }, { 1, 1 } } },
    { { { 0, 0, 0 }, { 1, 1, 0 }, { 1, 0, 0 } }, { { 0, 0, 1 }, { 0, 0, 1 }, { 0, 0, 1 } }, { { 0, 0 }, { 1, 1 }, { 1, 0 } } },
};

static void faces_with_uv_begin_at_the_first_column(void **state)
{
    const uint32_t first[2] = { 0, 2 }, numbers[2] = { 0, 1 };
    const camera_mesh m = { .distribution = 3, .rays = 1, .mesh_count = 1, .atlas = { square, 1, first, numbers } };
    const pov_camera c = POV_INIT(c);
    (void)state;

    for (int size = 2; size < 400; size++) {
        const raygen_screen through = { .u = { raygen_u(0, 0.5, size) }, .v = { raygen_v(size - 1, 0.5, size) },
                                        .width = size, .height = size };
        pov_ray ray = { .org = { HUGE_VAL, HUGE_VAL, HUGE_VAL } };

        camera_mesh_cast(&m, &c, &through, 1, &ray);
        assert_near(ray.org.x, 0.0, 0.0);
        assert_near(ray.org.y, 1.0 / size, 1e-15);
    }
}

static void assert_many_are_single(const pov_camera *c, unsigned known)
{
    pov_ray rays[RAYGEN_MANY];
    raygen_places places;
    raygen_screen through;

    for (int i = 0; i < RAYGEN_MANY; i++) {
        sample at = sample_at(7, i, 3 * i, i & 1, (uint32_t)i);

        places.x[i] = i;
        places.y[i] = 3 * i;
        places.dx[i] = at.x;
        places.dy[i] = at.y;
    }
    raygen_begin(c, rays, RAYGEN_MANY);
    raygen_place(&places, 83, 211, RAYGEN_MANY, &through);
    assert_int_equal(raygen_aim(c, &through, RAYGEN_MANY, rays), known);
    for (int i = 0; i < RAYGEN_MANY; i++) {
        pov_ray one = raygen_ray(c, 83, 211, places.x[i], places.y[i], places.dx[i], places.dy[i]);

        assert_memory_equal(&one.org, &rays[i].org, sizeof one.org);
        assert_memory_equal(&one.org_lo, &rays[i].org_lo, sizeof one.org_lo);
        assert_memory_equal(&one.dir, &rays[i].dir, sizeof one.dir);
        assert_memory_equal(&one.dir_lo, &rays[i].dir_lo, sizeof one.dir_lo);
        assert_int_equal(rays[i].origin_surface, POV_NO_OWNER);
    }
}

static void many_rays_are_single_ones_bit_for_bit(void **state)
{
    pov_camera c = a_camera();
    (void)state;

    assert_many_are_single(&c, TRACER_SOUND | TRACER_ONE_START);
    c.type = POV_CAMERA_ORTHOGRAPHIC;
    assert_many_are_single(&c, TRACER_SOUND);
    c.location.x = HUGE_VAL;
    assert_many_are_single(&c, 0);
}

/* ---- samples ---- */

/* One in each of 32 rows and columns, and in each cell of 4 x 8 and of 8 x 4, for both halves of any pixel: random
 * places would not do that. */
static void assert_spread(sample (*place)(uint32_t seed, int x, int y, int half, uint32_t index))
{
    for (int pixel = 0; pixel < 20; pixel++) {
        int columns[32] = { 0 }, rows[32] = { 0 }, high[4][8] = { { 0 } }, wide[8][4] = { { 0 } };

        for (uint32_t i = 0; i < 32; i++) {
            sample s = place(3, 7 * pixel, 1000 - pixel, pixel % 2, i);

            assert_true(s.x > 0.0 && s.x < 1.0 && s.y > 0.0 && s.y < 1.0);
            columns[(int)(32.0 * s.x)]++;
            rows[(int)(32.0 * s.y)]++;
            high[(int)(4.0 * s.x)][(int)(8.0 * s.y)]++;
            wide[(int)(8.0 * s.x)][(int)(4.0 * s.y)]++;
        }
        for (int i = 0; i < 32; i++)
            assert_true(columns[i] == 1 && rows[i] == 1 && high[i / 8][i % 8] == 1 && wide[i / 4][i % 4] == 1);
    }
}

static void samples_of_a_half_spread_evenly(void **state)
{
    (void)state;
    assert_spread(sample_at);
    assert_spread(sample_on_lens);
}

/* Of 256 samples of a half each of 256 boxes has one, whatever powers of four divide the four edges; so it is of each 16 and of
 * each 64 and their boxes. */
static void assert_boxes(double places[256][4], int first, int count, const int *edges)
{
    int boxes[256] = { 0 };

    for (int i = first; i < first + count; i++) {
        int box = 0;

        for (int k = 0; k < 4; k++)
            box = box * edges[k] + (int)(edges[k] * places[i][k]);
        assert_int_equal(boxes[box]++, 0);
    }
}

static void places_in_pixel_and_lens_fill_four_dimensions(void **state)
{
    double places[256][4];
    (void)state;

    for (int i = 0; i < 256; i++) {
        const sample a = sample_at(5, 31, 41, 1, (uint32_t)i), b = sample_on_lens(5, 31, 41, 1, (uint32_t)i);

        memcpy(places[i], (double[4]){ a.x, a.y, b.x, b.y }, sizeof places[i]);
    }
    for (int count = 4; count <= 256; count *= 4)
        for (int code = 0; code < 625; code++) {
            const int edges[4] = { 1 << 2 * (code % 5), 1 << 2 * (code / 5 % 5), 1 << 2 * (code / 25 % 5), 1 << 2 * (code / 125) };

            for (int first = 0; edges[0] * edges[1] * edges[2] * edges[3] == count && first < 256; first += count)
                assert_boxes(places, first, count, edges);
        }
}

/* Of a disc divided by rings and sectors of one area each part has its share. */
static void assert_disc_is_even(sample (*disc)(sample))
{
    enum { EDGE = 240, RINGS = 4, SECTORS = 6 };
    int parts[RINGS][SECTORS] = { { 0 } };

    for (int i = 0; i < EDGE * EDGE; i++) {
        const sample at = disc((sample){ (i % EDGE + 0.5) / EDGE, (i / EDGE + 0.4) / EDGE });
        const double ring = at.x * at.x + at.y * at.y, turn = (atan2(at.y, at.x) / 3.141592653589793 + 1.0) / 2.0;

        assert_true(ring <= 1.0);
        parts[(int)fmin(RINGS * ring, RINGS - 1)][(int)fmin(SECTORS * turn, SECTORS - 1)]++;
    }
    for (int i = 0; i < RINGS * SECTORS; i++)
        assert_near(parts[i / SECTORS][i % SECTORS], EDGE * EDGE / (RINGS * SECTORS), 0.03 * EDGE * EDGE / (RINGS * SECTORS));
}

static void places_on_the_lens_are_those_of_a_disc(void **state)
{
    (void)state;
    assert_disc_is_even(sample_of_disc);
    assert_disc_is_even(sample_of_disc_alone);
}

static void places_on_the_lens_know_nothing_of_those_in_the_pixel(void **state)
{
    enum { PIXELS = 400, N = 16 * PIXELS };
    double both[4] = { 0.0 };
    (void)state;

    for (int k = 0; k < N; k++) {
        const sample a = sample_at(0, k / 16, 7, 0, (uint32_t)k % 16), b = sample_on_lens(0, k / 16, 7, 0, (uint32_t)k % 16);

        both[0] += 12.0 * (a.x - 0.5) * (b.x - 0.5) / N;
        both[1] += 12.0 * (a.x - 0.5) * (b.y - 0.5) / N;
        both[2] += 12.0 * (a.y - 0.5) * (b.x - 0.5) / N;
        both[3] += 12.0 * (a.y - 0.5) * (b.y - 0.5) / N;
    }
    for (int i = 0; i < 4; i++)
        assert_true(fabs(both[i]) < 0.05);
}

/* The first places of many pixels and halves are as even as chance makes them, and know nothing of each other. */
static void every_pixel_and_half_has_places_of_its_own(void **state)
{
    enum { EDGE = 100, N = EDGE * EDGE };
    double mean[2] = { 0.0, 0.0 }, halves = 0.0, neighbours = 0.0, axes = 0.0;
    (void)state;

    for (int i = 0; i < N; i++) {
        sample a = sample_at(0, i % EDGE, i / EDGE, 0, 0), b = sample_at(0, i % EDGE, i / EDGE, 1, 0);
        sample next = sample_at(0, i % EDGE + 1, i / EDGE, 0, 0);

        mean[0] += a.x / N;
        mean[1] += a.y / N;
        halves += 12.0 * (a.x - 0.5) * (b.x - 0.5) / N;
        neighbours += 12.0 * (a.x - 0.5) * (next.x - 0.5) / N;
        axes += 12.0 * (a.x - 0.5) * (a.y - 0.5) / N;
    }
    /* Five standard deviations of what independent places would give. */
    assert_near(mean[0], 0.5, 5.0 * 0.2887 / EDGE);
    assert_near(mean[1], 0.5, 5.0 * 0.2887 / EDGE);
    assert_near(halves, 0.0, 5.0 / EDGE);
    assert_near(neighbours, 0.0, 5.0 / EDGE);
    assert_near(axes, 0.0, 5.0 / EDGE);
}

/* ---- tiles ---- */

static void tiles_cover_every_pixel_once(void **state)
{
    static const int sizes[][2] = { { 1, 1 }, { 16, 16 }, { 17, 33 }, { 320, 240 }, { 1000, 3 }, { 3, 1000 } };
    env e = libc_env();
    (void)state;

    for (int i = 0; i < 6; i++) {
        int width = sizes[i][0], height = sizes[i][1];
        unsigned char *seen = calloc((size_t)width * (size_t)height, 1);
        tiles t;

        tiles_make(&t, width, height, 4, false);
        assert_true(tiles_sort(&t, &e));
        for (size_t k = 0; k < t.count; k++) {
            pov_rect r = tiles_rect(&t, t.order[k]);
            for (int y = r.y; y < r.y + r.height; y++)
                for (int x = r.x; x < r.x + r.width; x++)
                    assert_int_equal(seen[y * width + x]++, 0);
        }
        for (int k = 0; k < width * height; k++)
            assert_int_equal(seen[k], 1);
        tiles_free(&t, &e);
        free(seen);
    }
}

static void tiles_come_from_the_middle_outwards(void **state)
{
    env e = libc_env();
    tiles t;
    int last = 0;
    (void)state;

    tiles_make(&t, 500, 300, 1, false);
    assert_true(tiles_sort(&t, &e));
    for (size_t k = 0; k < t.count; k++) {
        pov_rect r = tiles_rect(&t, t.order[k]);
        int x = abs(2 * r.x + t.edge - t.columns * t.edge), y = abs(2 * r.y + t.edge - t.rows * t.edge);
        assert_true((x > y ? x : y) >= last);
        last = x > y ? x : y;
    }
    tiles_free(&t, &e);
}

/* What lies around a tile is traced for it, too. Each thread has four tiles at least. */
static void tiles_of_pixels_that_lend_are_wide(void **state)
{
    tiles one, many, plain;
    (void)state;

    tiles_make(&one, 512, 256, 2, true);
    tiles_make(&many, 512, 256, 3, true);
    tiles_make(&plain, 5120, 2560, 2, false);
    assert_int_equal(one.edge, 128);
    assert_int_equal(many.edge, 64);
    assert_int_equal(plain.edge, 64);
}

static void passes_have_every_pixel_of_a_tile_once(void **state)
{
    (void)state;

    for (int width = 1; width <= 33; width += 4)
        for (int height = 1; height <= 33; height += 3) {
            unsigned char seen[33][33] = { { 0 } };
            for (int step = 16; step > 0; step /= 2) {
                lattice l = { step, step < 16, false };
                size_t count = 0;
                for (int y = 0; y < height; y++)
                    for (int x = 0; x < width; x++)
                        if (lattice_has(l, x, y)) {
                            assert_int_equal(seen[y][x]++, 0);
                            count++;
                        }
                assert_int_equal(count, lattice_pixels(l, width, height));
            }
            for (int y = 0; y < height; y++)
                for (int x = 0; x < width; x++)
                    assert_int_equal(seen[y][x], 1);
        }
}

/* ---- the frame ---- */

typedef struct board { env env; tiles tiles; framebuffer framebuffer; float *pixels; } board;

/* A picture of 32 x 16 in two tiles of 16, coarsest pixel 4. */
static void setup(board *b)
{
    b->env = libc_env();
    tiles_make(&b->tiles, 32, 16, 1, false);
    assert_int_equal(b->tiles.edge, 16);
    assert_true(framebuffer_make(&b->framebuffer, &b->env, &b->tiles, 4));
    b->pixels = calloc(16 * 16 * 4, sizeof *b->pixels);
}

static void teardown(board *b)
{
    framebuffer_free(&b->framebuffer, &b->env);
    tiles_free(&b->tiles, &b->env);
    free(b->pixels);
}

static void fill(board *b, float value)
{
    for (int i = 0; i < 16 * 16 * 4; i++)
        b->pixels[i] = value;
}

static float read_at(const board *b, int x, int y)
{
    float rgba[4];

    framebuffer_row(&b->framebuffer, (size_t)(x / 16), x, y, 1, rgba);
    return rgba[0];
}

static void a_missing_pixel_shows_its_nearest_coarser_one(void **state)
{
    board b;
    (void)state;
    setup(&b);

    for (int i = 0; i < 16 * 16; i++)
        b.pixels[4 * i] = (float)i;
    framebuffer_put(&b.framebuffer, 1, 0, b.pixels);
    assert_near(read_at(&b, 3, 3), 0.0, 0.0);
    assert_near(read_at(&b, 16 + 3, 3), 0.0, 0.0);
    assert_near(read_at(&b, 16 + 5, 11), 8 * 16 + 4, 0.0);
    framebuffer_put(&b.framebuffer, 1, 1, b.pixels);
    assert_near(read_at(&b, 16 + 7, 11), 10 * 16 + 6, 0.0);
    framebuffer_put(&b.framebuffer, 1, 2, b.pixels);
    assert_near(read_at(&b, 16 + 7, 11), 11 * 16 + 7, 0.0);
    teardown(&b);
}

/* Threads may hand in a finer pass before a coarser one. */
static void a_finer_pass_shows_only_when_the_coarser_ones_are_in(void **state)
{
    board b;
    (void)state;
    setup(&b);

    fill(&b, 1.0f);
    framebuffer_put(&b.framebuffer, 0, 0, b.pixels);
    fill(&b, 3.0f);
    framebuffer_put(&b.framebuffer, 0, 2, b.pixels);
    assert_near(read_at(&b, 1, 1), 1.0, 0.0);
    fill(&b, 2.0f);
    framebuffer_put(&b.framebuffer, 0, 1, b.pixels);
    assert_near(read_at(&b, 1, 1), 3.0, 0.0);
    assert_near(read_at(&b, 2, 2), 2.0, 0.0);
    assert_near(read_at(&b, 4, 4), 1.0, 0.0);
    teardown(&b);
}

static void a_coarse_pass_that_is_late_changes_nothing_of_a_last_one_that_draws_all(void **state)
{
    board b;

    (void)state;
    setup(&b);
    b.framebuffer.again = true;
    fill(&b, 2.0f);
    framebuffer_put(&b.framebuffer, 0, 2, b.pixels);
    fill(&b, 1.0f);
    framebuffer_put(&b.framebuffer, 0, 1, b.pixels);
    framebuffer_put(&b.framebuffer, 0, 0, b.pixels);
    assert_true(framebuffer_has(&b.framebuffer, 0));
    for (int y = 0; y < 16; y++)
        for (int x = 0; x < 16; x++)
            assert_float_equal(framebuffer_pixels(&b.framebuffer, x, y)[0], 2.0f, 0.0f);
    teardown(&b);
}

static void a_cleared_framebuffer_shows_nothing(void **state)
{
    board b;
    (void)state;
    setup(&b);

    fill(&b, 1.0f);
    framebuffer_put(&b.framebuffer, 0, 0, b.pixels);
    framebuffer_clear(&b.framebuffer);
    assert_near(read_at(&b, 0, 0), 0.0, 0.0);
    teardown(&b);
}

/* ---- what is read ---- */

static int byte_of(const encoding *e, float value)
{
    float rgba[4] = { value, value, value, 1.0f };
    unsigned char bytes[4];

    encoding_display(e, rgba, bytes, 1);
    assert_int_equal(bytes[3], 255);
    assert_int_equal(bytes[0], bytes[2]);
    return bytes[0];
}

static double curve(double v)
{
    return v <= 0.0031308 ? 12.92 * v : 1.055 * pow(v, 1.0 / 2.4) - 0.055;
}

static void display_bytes_are_rounded_on_the_scene_s_curve(void **state)
{
    gamma plain = { false, 1.0, POV_TRANSFER_LINEAR }, srgb = { false, 2.2, POV_TRANSFER_SRGB };
    encoding a, b;
    (void)state;

    encoding_make(&a, &plain);
    encoding_make(&b, &srgb);
    for (int i = -100; i < 2000; i++) {
        float v = (float)i / 1777.0f;
        double clamped = v < 0.0f ? 0.0 : v > 1.0f ? 1.0 : v;
        assert_int_equal(byte_of(&a, v), (int)floor(255.0 * clamped + 0.5));
        assert_int_equal(byte_of(&b, v), (int)floor(255.0 * curve(pow(clamped, 2.2)) + 0.5));
    }
    assert_int_equal(byte_of(&a, NAN), 0);
}

static void linear_values_are_decoded_and_unclamped(void **state)
{
    gamma g = { false, 2.0, POV_TRANSFER_SRGB };
    float rgba[4] = { 0.5f, -0.5f, 3.0f, 1.0f };
    encoding e;
    (void)state;

    encoding_make(&e, &g);
    encoding_linear(&e, rgba, 1);
    assert_near(rgba[0], 0.25, 1e-7);
    assert_near(rgba[1], -0.25, 1e-7);
    assert_near(rgba[2], 9.0, 1e-6);
    assert_near(rgba[3], 1.0, 0.0);
}

static void what_is_not_known_yet_is_transparent(void **state)
{
    gamma g = { false, 1.0, POV_TRANSFER_LINEAR };
    float rgba[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
    unsigned char bytes[4];
    encoding e;
    (void)state;

    encoding_make(&e, &g);
    encoding_display(&e, rgba, bytes, 1);
    assert_int_equal(bytes[3], 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_ray_goes_through_the_centre_of_its_pixel),
        cmocka_unit_test(rays_are_symmetric_bit_for_bit),
        cmocka_unit_test(orthographic_rays_are_parallel),
        cmocka_unit_test(faces_with_uv_begin_at_the_first_column),
        cmocka_unit_test(many_rays_are_single_ones_bit_for_bit),
        cmocka_unit_test(samples_of_a_half_spread_evenly),
        cmocka_unit_test(places_in_pixel_and_lens_fill_four_dimensions),
        cmocka_unit_test(places_on_the_lens_are_those_of_a_disc),
        cmocka_unit_test(places_on_the_lens_know_nothing_of_those_in_the_pixel),
        cmocka_unit_test(every_pixel_and_half_has_places_of_its_own),
        cmocka_unit_test(tiles_cover_every_pixel_once),
        cmocka_unit_test(tiles_come_from_the_middle_outwards),
        cmocka_unit_test(tiles_of_pixels_that_lend_are_wide),
        cmocka_unit_test(passes_have_every_pixel_of_a_tile_once),
        cmocka_unit_test(a_missing_pixel_shows_its_nearest_coarser_one),
        cmocka_unit_test(a_finer_pass_shows_only_when_the_coarser_ones_are_in),
        cmocka_unit_test(a_coarse_pass_that_is_late_changes_nothing_of_a_last_one_that_draws_all),
        cmocka_unit_test(a_cleared_framebuffer_shows_nothing),
        cmocka_unit_test(display_bytes_are_rounded_on_the_scene_s_curve),
        cmocka_unit_test(linear_values_are_decoded_and_unclamped),
        cmocka_unit_test(what_is_not_known_yet_is_transparent),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
