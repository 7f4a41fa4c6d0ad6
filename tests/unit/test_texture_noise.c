/* Noise and turbulence are POV-Ray's, measured, within 1e-12, and a lane's value depends on no other lane. */
#include "support/near.h"
#include "support/samples.h"
#include "texture/noise.h"

static noise_tables *make(void)
{
    env e;

    env_init(&e, NULL, NULL, NULL);
    return noise_create(&e);
}

static void drop(noise_tables *t)
{
    env e;

    env_init(&e, NULL, NULL, NULL);
    env_free_aligned(&e, t);
}

static void fill(const samples *s, vec_lanes *at)
{
    for (uint32_t i = 0; i < lanes_whole(s->count); i++)
        lanes_put(at, i, s->at[i < s->count ? i : 0]);
}

/* vturb.x 2.3 0.6 5: component, lambda, omega, octaves. */
static void find_vector(const noise_tables *t, const samples *s, const vec_lanes *at, double *value)
{
    turbulence of = turbulence_default();
    vec_lanes found;

    of.octaves = 1;
    if (strncmp(s->text, "vturb", 5) == 0)
        assert_int_equal(sscanf(s->text, "vturb.%*c %f %f %u", &of.lambda, &of.omega, &of.octaves), 3);
    noise_vector_turbulence(t, &of, at, s->count, &found);
    switch (strchr(s->text, '.')[1]) {
    case 'x': memcpy(value, found.x, sizeof found.x); break;
    case 'y': memcpy(value, found.y, sizeof found.y); break;
    default: memcpy(value, found.z, sizeof found.z);
    }
}

static void noise_is_as_measured(void **state)
{
    noise_tables *t = make();
    FILE *file = samples_open("samples.txt");
    double value[LANES_MAX];
    uint32_t count = 0;
    vec_lanes at;
    samples s;
    (void)state;

    while (samples_next(file, &s)) {
        fill(&s, &at);
        if (strncmp(s.text, "noise", 5) == 0)
            noise_values(t, s.text[5] - '0', &at, 1.0, s.count, value);
        else if (strncmp(s.text, "dnoise", 6) == 0 || strncmp(s.text, "vturb", 5) == 0)
            find_vector(t, &s, &at, value);
        else
            continue;
        for (uint32_t i = 0; i < s.count; i++, count++)
            assert_near(value[i], s.value[i], 1e-12);
    }
    assert_int_equal(count, 9 * 45);
    fclose(file);
    drop(t);
}

static void tables_are_those_of_the_rules(void **state)
{
    static const uint16_t hash[8] = { 2291, 2574, 3654, 1557, 1196, 3388, 2637, 1820 };
    noise_tables *t = make();
    int zeros = 0;
    (void)state;

    assert_memory_equal(t->hash, hash, sizeof hash);
    assert_int_equal(t->hash[NOISE_HASH], hash[0]);
    assert_near(t->cell[0], 0.81472369, 5e-9);
    assert_near(t->cell[2], 0.90579193, 5e-9);
    for (int i = 0; i < NOISE_GRADIENTS; i++)
        zeros += t->order[i] == 0;
    assert_int_equal(zeros, 2);
    assert_int_equal(t->order[0], 0);
    assert_int_equal(t->order[1017], 0);
    assert_int_equal(noise_hash(t, -4096, 0, 4096), noise_hash(t, 0, 0, 0));
    drop(t);
}

static bool is_same(double a, double b) { return a == b || (isnan(a) && isnan(b)); }

/* The same bits for a point whatever its lane and its neighbours; some of which may be too far away for integers, or in the
 * same cell. */
static void are_alone(const vec_lanes *at)
{
    noise_tables *t = make();
    const turbulence of = turbulence_default();
    double value[LANES_MAX];
    vec_lanes vectors, flat;

    for (int generator = 1; generator <= 3; generator++) {
        noise_turbulence(t, generator, &of, at, LANES_MAX, value);
        for (uint32_t i = 0; i < LANES_MAX; i++)
            assert_near(value[i], noise_turbulence_at(t, generator, &of, lanes_at(at, i)), 0.0);
    }
    noise_vector_turbulence(t, &of, at, LANES_MAX, &vectors);
    noise_flat_turbulence(t, &of, at, LANES_MAX, &flat);
    for (uint32_t i = 0; i < LANES_MAX; i++) {
        const pov_vec3 v = noise_vector_turbulence_at(t, &of, lanes_at(at, i));

        assert_true(is_same(v.x, vectors.x[i]) && is_same(v.y, vectors.y[i]) && is_same(v.z, vectors.z[i]));
        assert_true(is_same(v.x, flat.x[i]) && is_same(v.y, flat.y[i]));
    }
    drop(t);
}

static void is_alone(double step, pov_vec3 last)
{
    vec_lanes at;

    for (uint32_t i = 0; i < LANES_MAX; i++)
        lanes_put(&at, i, pov_vec3_of(0.37 * step * i - 9.0, 1.7 - 0.91 * step * i, 0.013 * step * i * i));
    lanes_put(&at, LANES_MAX - 1, last);
    are_alone(&at);
}

/* On floors at height 0 and in images half of the corners have no weight, and may be left out. Bit i: point i is above it. */
static void is_alone_on_floors(double step, uint64_t above)
{
    vec_lanes floor, image;

    for (uint32_t i = 0; i < LANES_MAX; i++) {
        const double x = 0.37 * step * i - 9.0, y = above >> i & 1 ? 0.7 : 0.0, z = 0.013 * step * i * i - 0.3;

        lanes_put(&floor, i, pov_vec3_of(x, y, z));
        lanes_put(&image, i, pov_vec3_of(x, z, y));
    }
    are_alone(&floor);
    are_alone(&image);
}

static void a_lane_is_alone(void **state)
{
    (void)state;
    for (double step = 1.0; step > 0.001; step *= 0.3) {
        is_alone(step, pov_vec3_of(3.5, -4095.75, 1e5));
        is_alone(step, pov_vec3_of(3.5, -1e8, 0.5));
        is_alone(step, pov_vec3_of(1e12, 0.0, 0.5));
        is_alone(step, pov_vec3_of(0.25, 0.5, -1e300));
        is_alone(step, pov_vec3_of(-1e300, 0.0, 0.5));
        is_alone(step, pov_vec3_of(-1e140, 0.0, 0.25));
        is_alone_on_floors(step, 0);
        is_alone_on_floors(step, 0x8888f0f000ff0010u);
        is_alone_on_floors(step, 0x8000000100000001u);
    }
}

/* Beyond 2^31 POV-Ray's conversion to integers ends; what has no place has a value all the same. */
static void far_points_have_values(void **state)
{
    noise_tables *t = make();
    static const double places[] = { 2147483648.3, 1e10, -1e10, 1e300, -1e300, HUGE_VAL, NAN };
    (void)state;

    for (size_t i = 0; i < sizeof places / sizeof places[0]; i++)
        for (int generator = 1; generator <= 3; generator++) {
            const double v = noise_value_at(t, generator, pov_vec3_of(places[i], 0.2, 0.4));

            assert_true(v >= 0.0 && v <= 1.0);
        }
    drop(t);
}

static void more_waves_have_the_same_first_ten(void **state)
{
    noise_tables *t = make();
    noise_wave first[NOISE_WAVES];
    arena memory;
    env e;
    (void)state;

    env_init(&e, NULL, NULL, NULL);
    arena_init(&memory, &e);
    assert_int_equal(t->waves, NOISE_WAVES);
    assert_near(t->wave[0].frequency, 0.919115878780, 1e-12);
    for (int i = 0; i < NOISE_WAVES; i++)
        assert_near(pov_dot(t->wave[i].source, t->wave[i].source), 1.0, 1e-15);
    memcpy(first, t->wave, sizeof first);
    assert_true(noise_want_waves(t, &memory, 5) && t->waves == NOISE_WAVES);
    assert_true(noise_want_waves(t, &memory, 500) && t->waves == 500);
    assert_memory_equal(t->wave, first, sizeof first);
    arena_free(&memory);
    drop(t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(noise_is_as_measured),
        cmocka_unit_test(tables_are_those_of_the_rules),
        cmocka_unit_test(a_lane_is_alone),
        cmocka_unit_test(far_points_have_values),
        cmocka_unit_test(more_waves_have_the_same_first_ten),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
