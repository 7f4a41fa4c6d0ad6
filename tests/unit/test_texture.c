/* What varying textures are at points: patterns, their lists, and the spaces that they stand in. */
#include "support/near.h"
#include "support/squares.h"
#include "support/tiny.h"
#include "texture/pattern.h"
#include "texture/texture.h"

#include <math.h>
#include <string.h>

static const pov_vec3 zero = { 0.0, 0.0, 0.0 };

/* ---- patterns ---- */

static double value_at(const char *keyword, double x, double y, double z)
{
    const pattern_class *class = pattern_find(keyword);
    double values[LANES_MAX];
    vec_lanes at;
    const pattern_input in = { .at = &at, .n = 3 };

    memset(&at, 0, sizeof at);
    lanes_put(&at, 2, pov_vec3_of(x, y, z));
    assert_non_null(class);
    class->evaluate(&in, values);
    return values[2];
}

static void square_counts_four_squares_about_a_corner(void **state)
{
    (void)state;
    for (double y = -1.5; y < 2.0; y += 1.0) {
        assert_near(value_at("square", 0.5, y, 0.5), 0.0, 0.0);
        assert_near(value_at("square", 0.5, y, 1.5), 1.0, 0.0);
        assert_near(value_at("square", 1.5, y, 1.5), 2.0, 0.0);
        assert_near(value_at("square", 1.5, y, 0.5), 3.0, 0.0);
        assert_near(value_at("square", -0.5, y, -0.5), 2.0, 0.0);
        assert_near(value_at("square", -1.5, y, -0.5), 1.0, 0.0);
        assert_near(value_at("square", 1e15 + 1.0, y, -0.5), 2.0, 0.0);
    }
}

static void checker_takes_turns_in_three_directions(void **state)
{
    (void)state;
    for (int i = -3; i <= 3; i++)
        for (int j = -3; j <= 3; j++)
            for (int k = -3; k <= 3; k++) {
                const double wanted = (i + j + k) & 1;

                assert_near(value_at("checker", i + 0.5, j + 0.5, k + 0.5), wanted, 0.0);
                assert_near(value_at("checker", i, j, k), wanted, 0.0);
                assert_near(value_at("checker", i - 0.99e-10, j - 0.99e-10, k), wanted, 0.0);
                assert_near(value_at("checker", i - 1.01e-10, j, k), 1.0 - wanted, 0.0);
            }
    assert_near(value_at("checker", 1e17, 0.5, 0.5), 0.0, 0.0);
}

static void a_keyword_of_no_pattern_has_no_class(void **state)
{
    (void)state;
    assert_null(pattern_find("sphere"));
    assert_null(pattern_find(""));
}

/* ---- spaces ---- */

/* The map of translate <x, 0, 0> behind scale s. */
static pov_affine scaled_and_moved(double s, double x)
{
    pov_affine map;

    memset(&map, 0, sizeof map);
    for (int i = 0; i < 3; i++) {
        map.m[i][i] = s;
        map.inv[i][i] = 1.0 / s;
    }
    map.m[0][3] = x;
    map.inv[0][3] = -x / s;
    return map;
}

static void maps_are_kept_once(void **state)
{
    map_table t = { 0 };
    env e;
    (void)state;

    env_init(&e, NULL, NULL, NULL);
    for (int round = 0; round < 3; round++)
        for (uint32_t i = 0; i < 1000; i++) {
            const pov_affine map = scaled_and_moved(1.0, i);

            assert_int_equal(map_table_add(&t, &e, &map), i + 1);
        }
    assert_int_equal(t.count, 1000);
    assert_int_equal(t.linear_count, 1);   /* they only move */
    assert_near(map_table_at(&t, 8)->move[0], -7.0, 0.0);
    assert_null(map_table_at(&t, 0));
    map_table_free(&t, &e);
}

/* Of `count` objects: bytes of the records, and that each is read as it was written. */
static size_t bytes_of_moves(double (*place)(uint32_t i, int axis), uint32_t count)
{
    map_table t = { 0 };
    size_t bytes;
    env e;

    env_init(&e, NULL, NULL, NULL);
    for (uint32_t i = 0; i < count; i++) {
        pov_affine map = scaled_and_moved(1.0, 0.0);
        inverse_map space;
        const inverse_map *back;

        for (int k = 0; k < 3; k++)
            map.inv[k][3] = place(i, k);
        back = map_table_read(&t, map_table_add_own(&t, &e, &map), &space);
        assert_non_null(back);
        assert_memory_equal(back->linear->m, t.linear[0]->m, sizeof back->linear->m);
        for (int k = 0; k < 3; k++) {
            assert_memory_equal(&back->move[k], &map.inv[k][3], sizeof(double));
            assert_true(back->move_lo[k] == 0.0);
        }
    }
    bytes = t.count * sizeof *t.items + t.moved.count * sizeof *t.moved.items + t.brief.count * sizeof *t.brief.items;
    map_table_free(&t, &e);
    return bytes;
}

static double decimal_place(uint32_t i, int axis)
{
    return ((int32_t)(i * 7919 + (uint32_t)axis * 104729) % 200000 - 100000) / 1e4;
}

static double binary_place(uint32_t i, int axis)
{
    return ((int32_t)i - 500) * 0.0625 + axis * 0.00390625;
}

static double any_place(uint32_t i, int axis)
{
    return sin(i + 0.1) * (axis + 1);
}

static void maps_of_objects_that_only_move_are_short(void **state)
{
    (void)state;
    assert_true(bytes_of_moves(decimal_place, 1000) <= 12 * 1000);
    assert_true(bytes_of_moves(binary_place, 1000) <= 12 * 1000);
    assert_true(bytes_of_moves(any_place, 1000) <= 28 * 1000);
}

/* Squares far out are as sharp as near the origin: a point 2^-60 off a border stays on its side. */
static void points_are_taken_to_a_texture_in_two_parts(void **state)
{
    static const double places[] = { 0.0, 1.0, 1e9, 1e15 }, scales[] = { 1.0, 0x1p-300, 0x1p200 };
    (void)state;

    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 3; k++) {
            const double s = scales[k];
            const pov_affine affine = scaled_and_moved(s, places[i] * s);
            const pigment *list = pattern_find("square")->list;
            texture_points points;
            texture_term out[2];
            material of;
            squares p;
            model m;
            env e;

            env_init(&e, NULL, NULL, NULL);
            model_init(&m, &e);
            material_init(&of);
            squares_set(&p, list, &of);
            p.pattern.map = map_table_add(&m.kept_maps, &e, &affine);
            points.has_surface = false;
            texture_point(&points, 0, pov_vec3_of(places[i] * s, 0, 0), pov_vec3_of(0x1p-60 * s, 0, 0));
            texture_point(&points, 1, pov_vec3_of(places[i] * s, 0, 0), pov_vec3_of(-0x1p-60 * s, 0, 0));
            assert_int_equal(texture_eval(&m, of.texture, &points, 2, out), 2);
            assert_memory_equal(&out[0].pigment, &list[0], sizeof(pigment));
            assert_memory_equal(&out[1].pigment, &list[3], sizeof(pigment));
            model_free(&m);
        }
}

/* An object that was turned about y by a quarter after its texture was written, and then moved. */
static void an_object_takes_its_texture_along(void **state)
{
    const linear_map turn = { .m = { { 0, 0, -1 }, { 0, 1, 0 }, { 1, 0, 0 } } };
    inverse_map map = { &turn, { 0, 0, -3 }, { 0, 0, 0 } };
    texture_points points;
    (void)state;

    for (uint32_t i = 0; i < 7; i++)
        texture_point(&points, i, pov_vec3_of(3.5, 2, -1 - (double)i), zero);
    texture_points_map(&map, 2, 6, &points);
    for (uint32_t i = 0; i < 7; i++) {
        const bool taken = i >= 2 && i < 6;

        assert_near(points.at.x[i], taken ? 1.0 + i : 3.5, 0.0);
        assert_near(points.at.y[i], 2.0, 0.0);
        assert_near(points.at.z[i], taken ? 0.5 : -1.0 - i, 0.0);
    }
}

/* ---- surfaces ---- */

static pigment pigment_of(float r, float g, float b, float filter, float transmit)
{
    const pigment p = { { r, g, b }, filter, transmit };

    return p;
}

static material panes(const pigment *list, squares *memory)
{
    material m = tiny_emitted(0.0f, 0.0f, 0.0f);

    squares_set(memory, list, &m);
    return m;
}

static void a_surface_shows_the_pigment_of_each_point(void **state)
{
    const pigment list[4] = { pigment_of(1, 0, 0, 0, 0), pigment_of(0, 1, 0, 0, 0), pigment_of(0.5f, 1, 1, 0.5f, 0),
                              pigment_of(0, 0, 0, 0, 0.75f) };
    squares p;
    tiny s;
    (void)state;
    tiny_begin(&s, NULL);

    s.model.background = colour_of(0.25f, 0.25f, 0.25f);
    tiny_plane(&s, 0, 1, 0, -1, panes(list, &p));
    tiny_build(&s);
    assert_true(world_plan(s.world)->textures);
    assert_colour(tiny_trace(&s, zero, 0.5, -1, 0.5), 1.0, 0.0, 0.0, 0.0);
    assert_colour(tiny_trace(&s, zero, 0.5, -1, 1.5), 0.0, 1.0, 0.0, 0.0);
    /* Half of its own colour, and half of the background through its colour. */
    assert_colour(tiny_trace(&s, zero, 1.5, -1, 1.5), 0.25 + 0.0625, 0.5 + 0.125, 0.5 + 0.125, 1e-7);
    assert_colour(tiny_trace(&s, zero, 1.5, -1, 0.5), 0.1875, 0.1875, 0.1875, 1e-7);
    /* The opaque ones sent no ray on. */
    assert_int_equal(s.tracer->context.counts.transmitted, 2);
    tiny_end(&s);
}

/* Lanes of several materials and of constant ones in one batch get what they would alone. */
static void a_batch_of_several_textures_is_evaluated_as_single_rays_are(void **state)
{
    const pigment list[4] = { pigment_of(1, 0.5f, 0, 0, 0), pigment_of(0, 1, 0, 0, 0), pigment_of(0.5f, 1, 1, 0, 0),
                              pigment_of(0, 0, 0.25f, 0, 0) };
    const pigment other[4] = { list[3], list[2], list[1], list[0] };
    pov_ray rays[BATCH_MAX];
    colour many[BATCH_MAX];
    squares p, q;
    tiny s;
    (void)state;
    tiny_begin(&s, NULL);

    tiny_plane(&s, 0, 1, 0, -3, panes(list, &p));
    tiny_sphere(&s, 3, -2, 0, 2, panes(other, &q));
    tiny_sphere(&s, -3, -2, 0, 2, tiny_matt());
    tiny_light(&s, 0, 10, 0, 1.0f, 1.0f, 1.0f);
    tiny_build(&s);
    for (uint32_t i = 0; i < BATCH_MAX; i++) {
        const pov_ray ray = { .dir = { i % 8 - 3.5, -2.0, i / 8 - 3.5 }, .origin_surface = POV_NO_OWNER };

        rays[i] = ray;
    }
    tracer_colors(s.tracer, rays, BATCH_MAX, 0, NULL, many, NULL);
    for (uint32_t i = 0; i < BATCH_MAX; i++) {
        const colour one = tracer_color(s.tracer, &rays[i]);

        assert_memory_equal(&many[i], &one, sizeof one);
    }
    tiny_end(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(square_counts_four_squares_about_a_corner),
        cmocka_unit_test(checker_takes_turns_in_three_directions),
        cmocka_unit_test(a_keyword_of_no_pattern_has_no_class),
        cmocka_unit_test(maps_are_kept_once),
        cmocka_unit_test(maps_of_objects_that_only_move_are_short),
        cmocka_unit_test(points_are_taken_to_a_texture_in_two_parts),
        cmocka_unit_test(an_object_takes_its_texture_along),
        cmocka_unit_test(a_surface_shows_the_pigment_of_each_point),
        cmocka_unit_test(a_batch_of_several_textures_is_evaluated_as_single_rays_are),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
