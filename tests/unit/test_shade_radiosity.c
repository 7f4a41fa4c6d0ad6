/* Radiosity: what diffuse surfaces have from each other, against closed forms. */
#include "support/near.h"
#include "support/tiny.h"

static const pov_vec3 origin = { 0.0, 0.0, 0.0 };

/* One bounce by one ray. */
static void begin(tiny *s)
{
    const radiosity_settings plain = { .given = true, .recursion_limit = 1, .draws = 1, .brightness = 1.0f };

    tiny_begin(s, NULL);
    s->model.radiosity = plain;
}

static material diffuse(float d, float emission)
{
    material m = tiny_matt();

    m.finish.diffuse = d;
    m.finish.emission = colour_of(emission, emission, emission);
    return m;
}

static leaf_node *last(tiny *s) { return &s->model.leaves.items[s->model.leaves.count - 1]; }

/* The inside of a sphere around the eye. */
static colour seen_in_a_sphere(tiny *s, float albedo, float emission)
{
    colour c;

    tiny_sphere(s, 0, 0, 0, 2, diffuse(albedo, emission));
    tiny_build(s);
    c = tiny_trace(s, origin, 1, 2, 3);
    tiny_end(s);
    return c;
}

static void each_bounce_in_a_closed_sphere_adds_its_term(void **state)
{
    double wanted = 0.25;
    float power = 1.0f;
    tiny s;

    (void)state;
    for (uint32_t n = 1; n <= 8; n++) {
        begin(&s);
        s.model.radiosity.recursion_limit = n;
        s.model.radiosity.draws = n % 2 ? 1 : 16;
        power *= 0.5f;
        wanted += 0.25 * (double)power;
        assert_colour(seen_in_a_sphere(&s, 0.5f, 0.25f), wanted, wanted, wanted, 1e-6);
    }
}

static void a_white_furnace_has_the_same_light_at_every_bounce(void **state)
{
    tiny s;

    (void)state;
    for (uint32_t n = 1; n <= 20; n += 4) {
        begin(&s);
        s.model.radiosity.recursion_limit = n;
        assert_colour(seen_in_a_sphere(&s, 1.0f, 0.125f), 0.125 * (n + 1), 0.125 * (n + 1), 0.125 * (n + 1), 1e-5);
    }
}

static void settings_change_each_bounce(void **state)
{
    tiny s;

    (void)state;
    begin(&s);
    s.model.radiosity.recursion_limit = 2;
    s.model.radiosity.brightness = 0.5f;
    assert_colour(seen_in_a_sphere(&s, 0.5f, 1.0f), 1.3125, 1.3125, 1.3125, 1e-6);
    begin(&s);
    s.model.radiosity.recursion_limit = 9;
    s.model.radiosity.adc_bailout = 0.2;   /* weights of 1/2 and 1/4 pass */
    assert_colour(seen_in_a_sphere(&s, 0.5f, 1.0f), 1.75, 1.75, 1.75, 1e-6);
    begin(&s);
    s.model.radiosity.max_sample = 0.5f;
    s.model.radiosity.recursion_limit = 3;
    assert_colour(seen_in_a_sphere(&s, 0.5f, 1.0f), 1.25, 1.25, 1.25, 1e-6);
}

static void grey_samples_lose_their_colour(void **state)
{
    tiny s;

    (void)state;
    begin(&s);
    s.model.radiosity.gray_threshold = 0.5f;
    s.model.background = colour_of(1.0f, 0.0f, 0.5f);
    tiny_plane(&s, 0, 0, -1, -4, diffuse(0.5f, 0.0f));
    tiny_build(&s);
    assert_colour(tiny_trace(&s, origin, 0, 0, 1), 0.25 + 0.25 * 0.354, 0.25 * 0.354, 0.125 + 0.25 * 0.354, 1e-6);
    tiny_end(&s);
}

/* A floor below a ceiling of emission 1, which hides from the gather or not, under a sky of 1/4. */
static colour seen_of_floor(uint32_t flags, material floor)
{
    colour c;
    tiny s;

    begin(&s);
    s.model.background = colour_of(0.25f, 0.25f, 0.25f);
    tiny_plane(&s, 0, 1, 0, -1, floor);
    tiny_plane(&s, 0, 1, 0, 3, diffuse(0.0f, 1.0f));
    last(&s)->flags |= flags;
    tiny_build(&s);
    c = tiny_trace(&s, origin, 0.1, -1, 0.2);
    tiny_end(&s);
    return c;
}

static void objects_can_be_hidden_from_it(void **state)
{
    (void)state;
    assert_colour(seen_of_floor(0, diffuse(0.5f, 0.0f)), 0.5, 0.5, 0.5, 1e-6);
    assert_colour(seen_of_floor(LEAF_NO_RADIOSITY, diffuse(0.5f, 0.0f)), 0.125, 0.125, 0.125, 1e-6);
    assert_colour(seen_of_floor(LEAF_NO_IMAGE, diffuse(0.5f, 0.0f)), 0.5, 0.5, 0.5, 1e-6);
    assert_colour(seen_of_floor(LEAF_NO_REFLECTION, diffuse(0.5f, 0.0f)), 0.5, 0.5, 0.5, 1e-6);
}

static void the_back_gathers_by_its_own_share(void **state)
{
    material floor = diffuse(0.5f, 0.0f);

    (void)state;
    floor.finish.diffuse_back = 0.25f;   /* it sees the sky below */
    assert_colour(seen_of_floor(0, floor), 0.5625, 0.5625, 0.5625, 1e-6);
    floor.finish.written = 0.5f;
    assert_colour(seen_of_floor(0, floor), 0.28125, 0.28125, 0.28125, 1e-6);
}

static void lights_count_where_it_hits_and_highlights_do_not(void **state)
{
    material ceiling = diffuse(0.5f, 0.0f);
    colour c;
    tiny s;

    (void)state;
    ceiling.finish.phong = 8.0f;
    ceiling.finish.phong_size = 1.0f;
    begin(&s);
    tiny_plane(&s, 0, 1, 0, -1, diffuse(0.5f, 0.0f));
    last(&s)->flags |= LEAF_NO_SHADOW;
    tiny_plane(&s, 0, 1, 0, 3, ceiling);
    tiny_light(&s, 0, -1e6, 0, 0.5f, 0.5f, 0.5f);   /* from below: the floor's upper side has none */
    tiny_light(&s, 1, -1e6, 0, 0.25f, 0.25f, 0.25f);
    tiny_light(&s, 0, -1e6, 1, 0.25f, 0.25f, 0.25f);
    tiny_build(&s);
    c = tiny_trace(&s, origin, 0, -1, 0);
    assert_colour(c, 0.25, 0.25, 0.25, 1e-5);
    tiny_end(&s);
}

/* Mean over many samples of what a floor has from a sphere of radius 1 and emission 4 at height 4: a share of 1/16. */
static void rays_that_aim_at_a_lamp_count_as_much_as_they_should(void **state)
{
    enum { ROUNDS = 256 };
    double sum = 0.0, squares = 0.0;
    tiny s;

    (void)state;
    begin(&s);
    tiny_plane(&s, 0, 1, 0, -1, diffuse(1.0f, 0.0f));
    tiny_sphere(&s, 0, 3, 0, 1, diffuse(0.0f, 4.0f));
    tiny_build(&s);
    assert_int_equal(world_get_lamps(s.world)->count, 1);
    for (uint32_t k = 0; k < ROUNDS; k++) {
        const pov_ray ray = { .dir = { 0, -1, 0 }, .origin_surface = POV_NO_OWNER };
        const sample_id id = sample_id_of(3, 1, 1, 2 * k);
        colour c;

        tracer_colors(s.tracer, &ray, 1, 0, &id, &c, NULL);
        sum += (double)c.g;
        squares += (double)c.g * (double)c.g;
    }
    assert_near(sum / ROUNDS, 0.25, 0.01);
    assert_true(squares / ROUNDS - 0.0625 < 0.2);   /* by the cosine alone it is 0.94 */
    tiny_end(&s);
}

/* A wall of albedo .5 around a lamp of 50, of which it sees a hundredth of its directions: each bounce adds .495 of the one before
 * to what the lamp gives, .5. */
static void each_bounce_around_a_lamp_adds_its_term(void **state)
{
    enum { ROUNDS = 16384 };
    double wanted = 0.0;

    (void)state;
    for (uint32_t n = 1; n <= 4; n++) {
        double sum = 0.0, squares = 0.0;
        tiny s;

        begin(&s);
        s.model.radiosity.recursion_limit = n;
        s.model.radiosity.draws = 16;
        tiny_sphere(&s, 0, 0, 0, 2, diffuse(0.5f, 0.0f));
        tiny_sphere(&s, 0, 0, 0, 0.2, diffuse(0.0f, 50.0f));
        tiny_build(&s);
        wanted = 0.5 + 0.495 * wanted;
        for (uint32_t k = 0; k < ROUNDS; k++) {
            const pov_ray ray = { .org = { 0, 1, 0 }, .dir = { 0, 1, 0 }, .origin_surface = POV_NO_OWNER };
            const sample_id id = sample_id_of(3, 1, 1, 2 * k);
            colour c;

            tracer_colors(s.tracer, &ray, 1, 0, &id, &c, NULL);
            sum += (double)c.g;
            squares += (double)c.g * (double)c.g;
        }
        assert_near(sum / ROUNDS, 0.5 * wanted, 0.0025);
        assert_true(squares / ROUNDS - sum / ROUNDS * sum / ROUNDS < 0.022);   /* 0.032 if deeper rays chose between lamp and wall */
        tiny_end(&s);
    }
}

static void a_ray_sees_the_same_alone_and_among_others(void **state)
{
    sample_id ids[BATCH_MAX];
    pov_ray rays[BATCH_MAX];
    colour many[BATCH_MAX], one;
    tiny s;

    (void)state;
    begin(&s);
    s.model.radiosity.recursion_limit = 3;
    s.model.radiosity.draws = 8;
    s.model.background = colour_of(0.25f, 0.5f, 1.0f);
    tiny_plane(&s, 0, 1, 0, -1, diffuse(0.75f, 0.0f));
    for (int i = 0; i < 9; i++)
        tiny_sphere(&s, i - 4.0, 0, 5, 0.4, i % 3 ? diffuse(0.75f, i == 4 ? 4.0f : 0.0f) : tiny_glass(1.5));
    tiny_build(&s);
    for (uint32_t i = 0; i < BATCH_MAX; i++) {
        const pov_ray ray = { .dir = { 0.15 * (i % 16) - 1.1, -0.1 * (i / 16) + 0.05, 1 }, .origin_surface = POV_NO_OWNER };

        rays[i] = ray;
        ids[i] = sample_id_of(5, (int)i % 16, (int)i / 16, i % 3);
    }
    tracer_colors(s.tracer, rays, BATCH_MAX, TRACER_SOUND, ids, many, NULL);
    for (uint32_t i = 0; i < BATCH_MAX; i++) {
        tracer_colors(s.tracer, &rays[i], 1, TRACER_SOUND, &ids[i], &one, NULL);
        assert_memory_equal(&many[i], &one, sizeof one);
    }
    tiny_end(&s);
}

/* ---- sets of rays, which use what others of them find ---- */

enum { SET = 16 };

/* A corner of floor and wall with a lamp before it, a sphere in its light, and the sky. */
static void build_corner(tiny *s)
{
    begin(s);
    s->model.radiosity.recursion_limit = 2;
    s->model.radiosity.draws = 4;
    s->model.background = colour_of(0.1f, 0.1f, 0.1f);
    tiny_plane(s, 0, 1, 0, -1, diffuse(0.75f, 0.0f));
    tiny_plane(s, 0, 0, -1, -5, diffuse(0.5f, 0.0f));
    tiny_sphere(s, 0, 0.5, 3.5, 0.4, diffuse(0.0f, 4.0f));
    tiny_sphere(s, 0.3, -0.3, 4, 0.3, diffuse(0.5f, 0.0f));
    tiny_build(s);
}

/* Rays to both sides of the corner, and past it to the sphere. */
static pov_ray ray_to_corner(uint32_t i)
{
    const pov_ray ray = { .dir = { 0.1 * (i % 4) - 0.15, -0.16 - 0.04 * (i / 4), 1 }, .origin_surface = POV_NO_OWNER };

    return ray;
}

static void number_set(sample_id *ids, uint32_t number, uint64_t set)
{
    for (uint32_t i = 0; i < SET; i++) {
        ids[i] = sample_id_of(5, (int)i, 1, number);
        ids[i].set = set;
        ids[i].place = i;
    }
}

/* Means and variances by ray. */
static void trace_corner(tiny *s, uint64_t set, uint32_t rounds, double mean[SET], double *variance)
{
    double squares[SET] = { 0 };
    pov_ray rays[SET];
    colour seen[SET];
    sample_id ids[SET];

    *variance = 0.0;
    for (uint32_t i = 0; i < SET; i++) {
        rays[i] = ray_to_corner(i);
        mean[i] = 0.0;
    }
    for (uint32_t k = 0; k < rounds; k++) {
        number_set(ids, 2 * k, set);
        tracer_colors(s->tracer, rays, SET, TRACER_SOUND, ids, seen, NULL);
        for (uint32_t i = 0; i < SET; i++) {
            mean[i] += (double)seen[i].g / rounds;
            squares[i] += (double)seen[i].g * (double)seen[i].g / rounds;
        }
    }
    for (uint32_t i = 0; i < SET; i++)
        *variance += (squares[i] - mean[i] * mean[i]) / SET;
}

static void what_neighbours_find_keeps_the_mean_and_lowers_the_noise(void **state)
{
    enum { ROUNDS = 16384 };
    double alone[SET], together[SET], noise_alone, noise_together;
    tiny s;

    (void)state;
    build_corner(&s);
    trace_corner(&s, 0, ROUNDS, alone, &noise_alone);
    trace_corner(&s, 1000, ROUNDS, together, &noise_together);
    for (uint32_t i = 0; i < SET; i++)
        assert_near(together[i], alone[i], 0.01 * alone[i] + 0.0015);
    assert_true(noise_together < noise_alone);   /* with a quarter of the rays that gather */
    tiny_end(&s);
}

static void a_set_sees_the_same_alone_and_among_others(void **state)
{
    pov_ray rays[3 * SET];
    sample_id ids[3 * SET];
    colour many[3 * SET], some[SET];
    tiny s;

    (void)state;
    build_corner(&s);
    for (uint32_t k = 0; k < 3; k++) {
        number_set(ids + SET * k, k, 100 + k);
        for (uint32_t i = 0; i < SET; i++)
            rays[SET * k + i] = ray_to_corner(i);
    }
    tracer_colors(s.tracer, rays, 3 * SET, TRACER_SOUND, ids, many, NULL);
    for (uint32_t k = 0; k < 3; k++) {
        tracer_colors(s.tracer, rays + SET * k, SET, TRACER_SOUND, ids + SET * k, some, NULL);
        assert_memory_equal(many + SET * k, some, sizeof some);
    }
    tiny_end(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_bounce_in_a_closed_sphere_adds_its_term),
        cmocka_unit_test(a_white_furnace_has_the_same_light_at_every_bounce),
        cmocka_unit_test(settings_change_each_bounce),
        cmocka_unit_test(grey_samples_lose_their_colour),
        cmocka_unit_test(objects_can_be_hidden_from_it),
        cmocka_unit_test(the_back_gathers_by_its_own_share),
        cmocka_unit_test(lights_count_where_it_hits_and_highlights_do_not),
        cmocka_unit_test(rays_that_aim_at_a_lamp_count_as_much_as_they_should),
        cmocka_unit_test(each_bounce_around_a_lamp_adds_its_term),
        cmocka_unit_test(a_ray_sees_the_same_alone_and_among_others),
        cmocka_unit_test(what_neighbours_find_keeps_the_mean_and_lowers_the_noise),
        cmocka_unit_test(a_set_sees_the_same_alone_and_among_others),
    };

    return cmocka_run_group_tests_name("radiosity", tests, NULL, NULL);
}
