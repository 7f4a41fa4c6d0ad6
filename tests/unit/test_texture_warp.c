/* Warps and wave forms at points whose images were measured from POV-Ray, or follow from a line of arithmetic. */
#include "support/near.h"
#include "texture/warp.h"
#include "texture/wave.h"

static pov_vec3 warped(const warp *w, double x, double y, double z)
{
    vec_lanes at;

    for (uint32_t i = 0; i < lanes_whole(1); i++)
        lanes_put(&at, i, pov_vec3_of(x, y, z));
    warp_apply(w, NULL, &at, 1);
    return lanes_at(&at, 0);
}

static void assert_warped(const warp *w, pov_vec3 from, double x, double y, double z)
{
    const pov_vec3 found = warped(w, from.x, from.y, from.z);

    assert_near(found.x, x, 1e-11);
    assert_near(found.y, y, 1e-11);
    assert_near(found.z, z, 1e-11);
}

static warp mapping(warp_kind kind, double x, double y, double z)
{
    warp w = { .kind = kind };

    w.as.mapping.orientation = pov_unit(pov_vec3_of(x, y, z));
    w.as.mapping.major_radius = 1.0;
    return w;
}

static void cells_repeat_and_flip(void **state)
{
    warp w = { .kind = WARP_REPEAT, .as.repeat = { .axis = 0, .width = 1.0 } };
    (void)state;

    assert_warped(&w, pov_vec3_of(2.25, 0.5, -3.5), 0.25, 0.5, -3.5);
    assert_warped(&w, pov_vec3_of(-0.25, 0.5, -3.5), 0.75, 0.5, -3.5);
    w.as.repeat.flip[0] = w.as.repeat.flip[1] = true;
    assert_warped(&w, pov_vec3_of(1.25, 0.5, -3.5), 0.75, -0.5, -3.5);
    assert_warped(&w, pov_vec3_of(2.25, 0.5, -3.5), 0.25, 0.5, -3.5);
    w.as.repeat.offset = pov_vec3_of(0.0, 0.5, 1.0);
    assert_warped(&w, pov_vec3_of(-0.25, 0.5, 0.0), 0.25, -1.0, -1.0);
    w = (warp){ .kind = WARP_REPEAT, .as.repeat = { .axis = 2, .width = -2.0 } };
    assert_warped(&w, pov_vec3_of(0.0, 0.0, 3.0), 0.0, 0.0, -1.0);
}

static void a_hole_attracts_what_is_near(void **state)
{
    warp w = { .kind = WARP_BLACK_HOLE, .as.black_hole = { .radius = 1.0, .strength = 1.0, .falloff = 2.0 } };
    (void)state;

    assert_warped(&w, pov_vec3_of(0.5, 0.0, 0.0), 0.625, 0.0, 0.0);
    assert_warped(&w, pov_vec3_of(1.5, 0.0, 0.0), 1.5, 0.0, 0.0);
    w.as.black_hole.is_inverse = true;
    assert_warped(&w, pov_vec3_of(0.5, 0.0, 0.0), 0.375, 0.0, 0.0);
    w.as.black_hole.repeat = pov_vec3_of(2.0, 0.0, 0.0);   /* the centre is moved into the cell: to 1 */
    assert_warped(&w, pov_vec3_of(-0.5, 0.0, 0.0), -0.625, 0.0, 0.0);
}

static void mappings_are_as_measured(void **state)
{
    const pov_vec3 p = { 0.3, 0.7, -0.2 };
    warp w = mapping(WARP_SPHERICAL, 0, 0, -1);
    (void)state;

    assert_warped(&w, p, 0.093583520905 - 1.0, 0.151400187083 - 1.0, 0.212599212599 - 1.0);
    w = mapping(WARP_SPHERICAL, 0, 2, 0);
    assert_warped(&w, p, 0.906416479095, 0.212599212599 - 1.0, 0.848599812917);
    w = mapping(WARP_SPHERICAL, 1, 1, 0);
    assert_warped(&w, p, 1.197709675230, 0.043274245945, 0.959117443281 - 1.0);
    w = mapping(WARP_TOROIDAL, 0, 0, 1);
    w.as.mapping.major_radius = 0.0;
    assert_warped(&w, p, 0.906416479095, 0.674299906459, 0.787400787401);
    w = mapping(WARP_TOROIDAL, 1, 0, 0);
    w.as.mapping.major_radius = 2.0;
    w.as.mapping.dist_exp = 1.0;
    assert_warped(&w, p, 1.782632741148, 1.668142102125, 0.384192307250 - 2.0);
    w = mapping(WARP_PLANAR, 0, 1, 1);
    w.as.mapping.distance = 0.5;
    assert_warped(&w, p, 0.424264068712, 0.141421356237, 0.848528137424);
}

static void a_cube_is_unfolded(void **state)
{
    const warp w = mapping(WARP_CUBIC, 0, 0, 1);
    (void)state;

    assert_warped(&w, pov_vec3_of(0.3, 0.7, -1.2), 0.84375, 0.597222222222, 1.2);
    assert_warped(&w, pov_vec3_of(1.2, 0.3, -0.7), 0.697916666667, 0.541666666667, 1.2);
    assert_warped(&w, pov_vec3_of(-1.2, 0.3, 0.7), 0.197916666667, 0.541666666667, 1.2);
    assert_warped(&w, pov_vec3_of(0.3, 1.2, 0.7), 0.40625, 0.736111111111, 1.2);
    assert_warped(&w, pov_vec3_of(-0.3, -1.2, -0.7), 0.34375, 0.069444444444, 1.2);
    assert_warped(&w, pov_vec3_of(1.0, 1.0, 0.5), 0.5625, 0.666666666667, 1.0);
    assert_warped(&w, pov_vec3_of(-1.0, -1.0, -1.0), 0.0, 0.333333333333, 1.0);
    assert_true(warped(&w, 0.0, 0.0, 0.0).z == 0.0);
}

/* The first of the list comes first, then the transformations behind it. */
static void warps_follow_each_other(void **state)
{
    warp second = { .kind = WARP_REPEAT, .as.repeat = { .axis = 0, .width = 1.0 } }, first = second;
    (void)state;

    first.as.repeat.width = 4.0;
    first.next = &second;
    first.has_map = true;
    first.map[0][0] = first.map[1][1] = first.map[2][2] = 0.5;
    first.map[0][3] = 0.25;
    assert_warped(&first, pov_vec3_of(7.0, 2.0, 2.0), 0.75, 1.0, 1.0);
    assert_false(warp_needs_noise(&first));
    second.kind = WARP_TURBULENCE;
    assert_true(warp_needs_noise(&first));
}

/* ---- waves ---- */

static double shaped(wave w, double v)
{
    double value[LANES_MAX] = { v, v, v, v };

    wave_shape(&w, 1, value);
    return value[0];
}

static void the_period_is_a_little_more_than_one(void **state)
{
    static const double values[] = { 0.0, 0.3, 1.0, 1.00001, 1.5, 7.7, -0.2, -3.4, 1234.567, -99999.25, 2e6, -3e9, 1e18 };
    (void)state;

    for (size_t i = 0; i < sizeof values / sizeof values[0]; i++) {
        const double rest = fmod(values[i], 1.00001);

        assert_true(shaped(wave_default(WAVE_RAMP), values[i]) == (rest < 0.0 ? rest + 1.0 : rest));
    }
    for (int i = -300000; i < 300000; i++) {   /* at and beside whole numbers of periods too */
        const double v = i * 1.00001 * (1.0 + (i % 3 - 1) * 0x1p-52), rest = fmod(v, 1.00001);

        assert_true(shaped(wave_default(WAVE_RAMP), v) == (rest < 0.0 ? rest + 1.0 : rest));
    }
}

static void frequency_and_phase_come_first(void **state)
{
    const wave w = { WAVE_RAMP, 2.0f, 0.25f, 1.0f }, none = { WAVE_RAMP, 0.0f, 0.25f, 1.0f };
    (void)state;

    assert_near(shaped(w, 0.3), 0.85, 1e-15);
    assert_near(shaped(none, -2.3), 0.7, 1e-15);
    assert_near(shaped(none, 0.3), 0.3, 0.0);
}

static void forms_are_their_formulas(void **state)
{
    wave poly = wave_default(WAVE_POLY);
    (void)state;

    poly.exponent = 2.5f;
    for (double v = 0.0; v <= 1.0; v += 0.03125) {
        assert_near(shaped(wave_default(WAVE_TRIANGLE), v), v < 0.5 ? 2.0 * v : v < 1.0 ? 2.0 - 2.0 * v : 0.0, 1e-15);
        assert_near(shaped(wave_default(WAVE_SINE), v), 0.5 + 0.5 * sin(6.283185307179586 * v), 1e-15);
        assert_near(shaped(wave_default(WAVE_SCALLOP), v), sin(3.141592653589793 * v), 1e-15);
        assert_near(shaped(wave_default(WAVE_CUBIC), v), v * v * (3.0 - 2.0 * v), 1e-15);
        assert_near(shaped(poly, v), pow(v, 2.5), 1e-15);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cells_repeat_and_flip),
        cmocka_unit_test(a_hole_attracts_what_is_near),
        cmocka_unit_test(mappings_are_as_measured),
        cmocka_unit_test(a_cube_is_unfolded),
        cmocka_unit_test(warps_follow_each_other),
        cmocka_unit_test(the_period_is_a_little_more_than_one),
        cmocka_unit_test(frequency_and_phase_come_first),
        cmocka_unit_test(forms_are_their_formulas),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
