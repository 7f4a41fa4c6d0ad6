/* Points side by side on their way to patterns and images: the bits of the general way, one by one. */
#include "support/near.h"
#include "texture/image_sample.h"
#include "texture/points.h"

static uint64_t draw(uint64_t *seed)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return *seed >> 11;
}

static double between(uint64_t *seed, double low, double high) { return low + (high - low) * (double)draw(seed) * 0x1p-53; }

/* ---- the space of a pattern ---- */

/* Is every point the upper part of what double-double arithmetic gives, without a shortcut? */
static void is_as_exact(double (*entry)(int row, int column), double move)
{
    static texture_points in;
    const vec_lanes *const at = &in.at;
    vec_lanes found, exact, exact_lo;
    pov_affine map = { { { 0.0 } }, { { 0.0 } }, { { 0.0 } }, { { 0.0 } } };
    uint64_t seed = 7;
    pattern p = { 0 };
    model m;
    env e;

    env_init(&e, NULL, NULL, NULL);
    model_init(&m, &e);
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 4; k++) {
            map.inv[i][k] = k < 3 ? entry(i, k) : move * (i + 1);
            map.inv_lo[i][k] = map.inv[i][k] * 0x1.3p-54;
        }
    p.map = map_table_add(&m.kept_maps, &e, &map);
    p.class = pattern_find("bozo");
    p.turbulence = turbulence_default();
    for (uint32_t i = 0; i < LANES_MAX; i++) {
        lanes_put(&in.at, i, pov_vec3_of(between(&seed, -9.0, 9.0), between(&seed, -9.0, 9.0), between(&seed, -9.0, 9.0)));
        lanes_put(&in.at_lo, i, pov_scale(lanes_at(at, i), 0x1.7p-55));
    }
    points_place(&m, &p, &in, LANES_MAX, &found, NULL);
    points_place(&m, &p, &in, LANES_MAX, &exact, &exact_lo);
    assert_memory_equal(&found, &exact, sizeof found);
    model_free(&m);
}

static double stretched(int row, int column) { return row == column ? 0.7 + row : 0.0; }
static double turned(int row, int column) { return column == (row + 1) % 3 ? (row == 1 ? -1.3 : 0.9) : 0.0; }
static double tilted(int row, int column) { return (row == 0) == (column == 0) ? 0.6 + 0.3 * row - 0.8 * column : 0.0; }
static double leaning(int row, int column) { return (row + column) % 3 == 1 ? 0.0 : 0.6 + 0.3 * row - 0.8 * column; }
static double any(int row, int column) { return 0.3 + 0.7 * row - 0.9 * column; }

static void points_are_rounded_once(void **state)
{
    (void)state;
    for (int moved = 0; moved < 2; moved++) {
        is_as_exact(stretched, 0.3 * moved);
        is_as_exact(turned, 0.3 * moved);
        is_as_exact(tilted, 0.3 * moved);
        is_as_exact(leaning, 0.3 * moved);
        is_as_exact(any, 0.3 * moved);
    }
}

/* ---- images ---- */

enum { WIDTH = 5, HEIGHT = 3, BYTES = 4 * 3 * WIDTH };

static void is_as_alone(image_map *map)
{
    pigment found[LANES_MAX];
    image_place places[LANES_MAX];
    uint64_t seed = 3;
    vec_lanes at;

    assert_true(image_has_lanes(map));
    for (uint32_t i = 0; i < LANES_MAX; i++)
        lanes_put(&at, i, pov_vec3_of(between(&seed, -1.5, 2.5), between(&seed, -1.5, 2.5), between(&seed, -1.5, 1.5)));
    for (uint32_t i = 0; i < 16; i++)
        lanes_put(&at, i, pov_vec3_of(0.5 * (i / 4) - 0.5, 0.5 * (i % 4) - 0.5, 0.0));
    lanes_put(&at, 16, pov_vec3_of(NAN, 0.4, 0.0));
    lanes_put(&at, 17, pov_vec3_of(0.4, 1e300, 0.0));
    lanes_put(&at, 18, pov_vec3_of(-1e-300, 1.0 - 0x1p-54, 0.0));
    lanes_put(&at, 19, pov_vec3_of(0.0, HUGE_VAL, 0.0));
    lanes_put(&at, 20, pov_vec3_of(0.0, -1.0, 0.0));
    lanes_put(&at, 21, pov_vec3_of(1.0, 0.0, 0.0));
    image_colours(map, &at, LANES_MAX - 1, found);
    image_places(map, &at, LANES_MAX - 1, places);
    for (uint32_t i = 0; i + 1 < LANES_MAX; i++) {
        const image_place place = image_place_at(map, lanes_at(&at, i));
        const pigment alone = image_colour(map, place);

        assert_true(places[i].u == place.u && places[i].v == place.v && places[i].is_outside == place.is_outside);
        assert_memory_equal(&found[i], &alone, sizeof alone);
    }
}

static void images_are_as_alone(void **state)
{
    static const image_map_type types[] = { IMAGE_PLANAR, IMAGE_SPHERICAL, IMAGE_CYLINDRICAL, IMAGE_TOROIDAL };
    static const uint32_t bits[] = { 8, 16, 32 };
    unsigned char bytes[HEIGHT * BYTES];
    float *const decoded = test_malloc(65536 * sizeof *decoded);
    uint64_t seed = 11;
    (void)state;

    for (uint32_t i = 0; i < 65536; i++)
        decoded[i] = (float)(i / 65535.0 * (i / 65535.0));
    for (int kind = 0; kind < 4 * 2 * 3 * 2 * 2 * 2; kind++) {
        image of = { .width = WIDTH, .height = HEIGHT, .channels = kind & 1 ? 1 : 3, .bits = bits[kind / 8 % 3], .stride = BYTES, .samples = bytes };
        image_map map = { .image = &of, .interpolation = kind / 24 % 2 ? IMAGE_NORMALISED : IMAGE_BILINEAR, .type = types[kind / 48],
                          .once = kind & 2, .filter = 0.1f, .transmit = 0.3f };

        for (uint32_t i = 0; i < sizeof bytes; i++)
            bytes[i] = (unsigned char)draw(&seed);
        for (uint32_t i = 0; of.bits == 32 && i < sizeof bytes / sizeof(float); i++)
            memcpy(bytes + i * sizeof(float), &decoded[draw(&seed) % 65536], sizeof(float));
        map.decoded = kind & 4 && of.bits < 32 ? decoded : NULL;
        is_as_alone(&map);
    }
    test_free(decoded);
}

static void images_with_a_palette_are_as_alone(void **state)
{
    unsigned char bytes[HEIGHT * WIDTH];
    pigment palette[256];
    uint64_t seed = 12;
    (void)state;

    for (uint32_t i = 0; i < sizeof bytes; i++)
        bytes[i] = (unsigned char)draw(&seed);
    for (int i = 0; i < 256; i++)
        palette[i] = (pigment){ { (float)between(&seed, 0.0, 1.0), (float)between(&seed, 0.0, 1.0), (float)between(&seed, 0.0, 1.0) },
                                (float)between(&seed, 0.0, 1.0), (float)between(&seed, 0.0, 1.0) };
    for (int kind = 0; kind < 4; kind++) {
        image of = { .width = WIDTH, .height = HEIGHT, .channels = 1, .bits = 8, .stride = WIDTH, .samples = bytes, .colours = 256 };
        image_map map = { .image = &of, .interpolation = kind & 1 ? IMAGE_NORMALISED : IMAGE_BILINEAR, .once = kind & 2, .palette = palette };

        is_as_alone(&map);
    }
}

/* ---- volumes ---- */

/* Cubic, along x: the voxel before the first is 2^64 - 1 modulo their number, as in POV-Ray; those behind the last are the
 * first. */
static void voxels_before_the_first_are_as_in_pov_ray(void **state)
{
    static const uint32_t before[] = { 5, 0, 6, 3, 7, 1, 11, 4, 4, 3 };
    const double t = 0.3, weight = 0.5 * t * (-1.0 + t * (2.0 - t));

    (void)state;
    for (size_t i = 0; i < sizeof before / sizeof *before; i += 2) {
        unsigned char samples[11] = { 0 };
        const density_file volume = { { before[i], 1, 1 }, 1, 2, samples };
        const pattern p = { .class = &pattern_density_file, .self = &volume };
        vec_lanes at;
        double value[LANES_MAX] = { 0.0 };
        const pattern_input in = { .at = &at, .n = 1, .of = &p };

        memset(&at, 0, sizeof at);
        memset(samples, 200, before[i]);
        samples[before[i + 1]] = 100;
        at.x[0] = t / before[i];
        p.class->evaluate(&in, value);
        if (before[i + 1] > 2)
            assert_near(value[0], (200.0 - 100.0 * weight) / 255.0, 1e-12);
        samples[before[i + 1]] = 200;
        samples[before[i] - 1] = 100;
        at.x[0] = 1.0 - (1.0 - t) / before[i];
        p.class->evaluate(&in, value);
        assert_near(value[0], (200.0 - 100.0 * (1.0 + 0.5 * t * t * (-5.0 + 3.0 * t))) / 255.0, 1e-12);
    }
}

/* ---- tilings ---- */

/* In tiling 22 values fall by the distance itself from three sides of the twelve-gons, as in POV-Ray, and faster from the others. */
static void twelve_gons_are_less_steep_from_three_sides(void **state)
{
    static const struct { double x, z, value; } samples[] = {
        { 0.31693, 2.05219, 0.68307 }, { -1.88244, -0.92664, 0.98359 }, { 2.16017, 0.23299, 0.76701 },
        { 1.866025403784439, 3.632050807568877, 1.0 - 0.1 * 1.1547005383792515 },
    };
    const int32_t number = 22;
    const pattern p = { .class = pattern_find("tiling"), .self = &number };

    (void)state;
    for (size_t i = 0; i < sizeof samples / sizeof *samples; i++) {
        vec_lanes at;
        double value[LANES_MAX] = { 0.0 };
        const pattern_input in = { .at = &at, .n = 1, .of = &p };

        memset(&at, 0, sizeof at);
        at.x[0] = samples[i].x;
        at.z[0] = samples[i].z;
        p.class->evaluate(&in, value);
        assert_near(value[0], samples[i].value, 1e-5);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points_are_rounded_once),
        cmocka_unit_test(images_are_as_alone),
        cmocka_unit_test(images_with_a_palette_are_as_alone),
        cmocka_unit_test(voxels_before_the_first_are_as_in_pov_ray),
        cmocka_unit_test(twelve_gons_are_less_steep_from_three_sides),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
