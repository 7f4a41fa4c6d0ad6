/* Media along a segment: strata, loss, own light, and samples of lights. */
#include "light/reach.h"
#include "media/matter.h"
#include "media/phase.h"
#include "support/check.h"
#include "support/near.h"
#include "support/tiny.h"

#include <string.h>

static const media_segment ahead = { { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 }, 2.0 };

static medium grey_medium(float absorption, float emission, float scattering)
{
    medium m;

    memset(&m, 0, sizeof m);
    m.absorption = colour_of(absorption, absorption, absorption);
    m.emission = colour_of(emission, emission, emission);
    m.scattering = colour_of(scattering, scattering, scattering);
    m.extinction = 1.0f;
    m.type = scattering > 0.0f ? SCATTER_ISOTROPIC : SCATTER_NONE;
    return m;
}

static media_set set_of(const medium *items, uint32_t count)
{
    const media all = { count, items };
    media_set s;

    memset(&s, 0, sizeof s);
    media_set_add(&s, &all, MEDIA_AIR);
    return s;
}

static void begin(media_march *l, const model *m, const media_set *s, const media_segment *on)
{
    l->model = m;
    l->set = s;
    l->on = *on;
    l->scale = 10.0;
    l->weight = 1.0;
    l->random = media_random_of(on);
    media_march_begin(l);
}

/* ---- strata ---- */

static void assert_divides(const media_division *by)
{
    media_strata s;

    media_divide(by, &s);
    assert_true(s.count > 0 && s.count <= MEDIA_STRATA_MAX);
    assert_true(s.edge[0] == by->lo && s.edge[s.count] == by->hi);
    for (uint32_t i = 0; i < s.count; i++)
        assert_true(s.edge[i] <= s.edge[i + 1]);
}

static void strata_cover_the_segment_in_order(void **state)
{
    media_division by = { .lo = 1.0, .hi = 9.0, .scale = 10.0, .wanted = 24 };
    (void)state;

    assert_divides(&by);
    by.loss = 2.0;
    assert_divides(&by);
    by.has_middle = true;
    by.middle = 3.0;
    by.distance = 0.01;
    assert_divides(&by);
    by.middle = -3.0;
    by.hi = 2e10;
    assert_divides(&by);
}

static void strata_are_small_where_much_happens(void **state)
{
    const media_division by = { .lo = 0.0, .hi = 100.0, .scale = 10.0, .wanted = 32, .has_middle = true, .middle = 40.0, .distance = 0.1 };
    uint32_t near = 0;
    media_strata s;
    (void)state;

    media_divide(&by, &s);
    for (uint32_t i = 0; i < s.count; i++)
        near += s.edge[i] > 39.0 && s.edge[i + 1] < 41.0;
    assert_true(near >= 8);
}

static void endless_strata_begin_at_the_scale_of_the_scene(void **state)
{
    const media_division by = { .lo = 0.0, .hi = 2e10, .scale = 10.0, .wanted = 32 };
    media_strata s;
    (void)state;

    media_divide(&by, &s);
    assert_near(s.edge[16], 10.0, 1e-6);
}

static void jitter_of_neighbours_cancels(void **state)
{
    const media_random r = { 17, 0.3 };
    double sum = 0.0;
    (void)state;

    for (uint32_t i = 0; i < 64; i++) {
        const double u = media_jitter(&r, i);

        assert_true(u >= 0.0 && u < 1.0);
        sum += u;
    }
    assert_near(sum, 32.0, 1e-12);
}

/* ---- loss and own light ---- */

static void constant_media_have_closed_forms(void **state)
{
    const medium m = grey_medium(0.8f, 0.5f, 0.0f);
    const media_set s = set_of(&m, 1);
    const double loss = exp(-2.0 * (double)0.8f);
    media_march l;
    model none;
    (void)state;

    memset(&none, 0, sizeof none);
    begin(&l, &none, &s, &ahead);
    assert_near((double)l.through.r, loss, 1e-7);
    assert_near((double)l.given.g, 0.5 / (double)0.8f * (1.0 - loss), 1e-7);
    assert_near((double)media_transmittance(&none, &s, &ahead).b, loss, 1e-7);
}

static void thin_media_lose_no_digits(void **state)
{
    const medium m = grey_medium(1e-7f, 0.25f, 0.0f);
    const media_set s = set_of(&m, 1);
    media_march l;
    model none;
    (void)state;

    memset(&none, 0, sizeof none);
    begin(&l, &none, &s, &ahead);
    assert_near((double)l.given.r, 0.5 * (1.0 - 1e-7), 1e-7);
}

static void media_that_only_shine_take_no_light(void **state)
{
    const medium bright = grey_medium(0.0f, 0.25f, 0.0f), dense = grey_medium(0.5f, 0.0f, 0.0f);
    const media both = { 1, &bright };
    media_set s = set_of(&bright, 1);
    media_march l;
    model none;
    (void)state;

    memset(&none, 0, sizeof none);
    assert_false(media_dim(&both) || s.dims || !s.shines);
    begin(&l, &none, &s, &ahead);
    assert_true(l.through.r == 1.0f && l.given.g == 0.5f && media_transmittance(&none, &s, &ahead).b == 1.0f);
    s = set_of(&dense, 1);
    assert_true(medium_dims(&dense) && s.dims && !s.shines);
    begin(&l, &none, &s, &ahead);
    assert_true(l.through.r < 1.0f && l.given.g == 0.0f);
}

/* Sets that vary, though their densities here do not: light comes to an end in the second. */
static void segments_together_leave_what_each_leaves(void **state)
{
    const medium thin = grey_medium(0.7f, 0.0f, 0.0f), dense = grey_medium(20.0f, 0.0f, 0.0f);
    media_segment on[MEDIA_TOGETHER];
    media_set sets[2] = { set_of(&thin, 1), set_of(&dense, 1) };
    colour left[MEDIA_TOGETHER];
    model none;
    (void)state;

    memset(&none, 0, sizeof none);
    assert_false(media_set_same(&sets[0], &sets[1]));
    for (uint32_t i = 0; i < MEDIA_TOGETHER; i++)
        on[i] = (media_segment){ { 0.0, (double)i, 0.0 }, { 0.6, 0.0, 0.8 }, i == 2 ? 2e10 : 0.5 * (double)i };
    for (int k = 0; k < 2; k++) {
        sets[k].varies = true;
        for (uint32_t n = 0; n <= MEDIA_TOGETHER; n++) {
            media_transmittances(&none, &sets[k], on, n, left);
            for (uint32_t i = 0; i < n; i++)
                assert_true(left[i].g == media_transmittance(&none, &sets[k], &on[i]).g);
        }
    }
}

static void only_so_many_media_act(void **state)
{
    medium many[MEDIA_SET_MAX + 3];
    media_set s;
    (void)state;

    for (int i = 0; i < MEDIA_SET_MAX + 3; i++)
        many[i] = grey_medium(1.0f, 0.0f, 0.0f);
    s = set_of(many, MEDIA_SET_MAX + 3);
    assert_int_equal(s.count, MEDIA_SET_MAX);
}

/* ---- strata that are split ---- */

enum { FEW = 16 };

/* Sixteen strata; from one of them on there is light. */
static void begin_step(media_march *l, const model *m, const media_set *s, uint32_t from, media_matter *out)
{
    const media_division by = { .lo = 0.0, .hi = ahead.length, .wanted = FEW };

    begin(l, m, s, &ahead);
    media_divide(&by, &l->table.strata);
    matter_find(l, out);
    for (int c = 0; c < 3; c++)
        for (uint32_t i = 0; i < from; i++)
            out->of[0].emitted[c][i] = 0.0;
}

static void strata_are_split_where_those_beside_them_differ(void **state)
{
    const medium bright = grey_medium(0.0f, 8.0f, 0.0f);
    const media_set s = set_of(&bright, 1);
    media_matter at;
    media_march l;
    model none;
    (void)state;

    memset(&none, 0, sizeof none);
    begin_step(&l, &none, &s, 0, &at);
    assert_true(matter_uneven(&l, &at) == 0);
    begin_step(&l, &none, &s, 7, &at);
    assert_true(matter_uneven(&l, &at) == 0x3f0);
    l.weight = 1e-3;
    assert_true(matter_uneven(&l, &at) == 0);
}

static void split_strata_keep_their_points(void **state)
{
    const medium bright = grey_medium(0.0f, 8.0f, 0.0f);
    const media_set s = set_of(&bright, 1);
    media_matter few, more;
    uint32_t kept = 0;
    media_march l;
    model none;
    (void)state;

    memset(&none, 0, sizeof none);
    begin_step(&l, &none, &s, 7, &few);
    matter_split(&l, &few, (uint64_t)1 << 3 | (uint64_t)1 << 15, &more);
    assert_int_equal(l.table.strata.count, FEW + 6);
    assert_true(l.table.strata.edge[FEW + 6] == ahead.length);
    for (uint32_t i = 0; i < FEW + 6; i++) {
        assert_true(l.table.strata.edge[i] <= more.at[i] && more.at[i] <= l.table.strata.edge[i + 1]);
        assert_true(more.of[0].emitted[1][i] == 8.0 || i < 10);
        for (uint32_t k = 0; k < FEW; k++)
            kept += more.at[i] == few.at[k] && more.of[0].emitted[1][i] == few.of[0].emitted[1][k];
    }
    assert_int_equal(kept, FEW);
}

/* ---- scattered light ---- */

static void phases_are_those_of_povray(void **state)
{
    medium m = grey_medium(0.0f, 0.0f, 1.0f);
    (void)state;

    assert_near(media_phase(&m, -0.3), 1.0, 0.0);
    m.type = SCATTER_HAZE;
    assert_near(media_phase(&m, 0.0), 0.57666 * (1.0 + 9.0 / 256.0), 1e-12);
    m.type = SCATTER_MURK;
    assert_near(media_phase(&m, 1.0), 0.49574 * 51.0, 1e-12);
    m.type = SCATTER_RAYLEIGH;
    assert_near(media_phase(&m, 0.5), 0.79940 * 1.25, 1e-12);
    m.type = SCATTER_HENYEY;
    m.eccentricity = 0.5f;
    assert_near(media_phase(&m, 0.6), 0.75 / pow(1.25 - 0.6, 1.5), 1e-12);
    assert_true(media_phase(&m, 1.0) > media_phase(&m, -1.0));
}

static light light_at(double x, double y, double z)
{
    light l;

    memset(&l, 0, sizeof l);
    l.position = pov_vec3_of(x, y, z);
    l.color = colour_of(1.0f, 1.0f, 1.0f);
    l.axis = pov_vec3_of(0.0, 0.0, 1.0);
    return l;
}

/* The mean over segments that differ in nothing but their random numbers. */
static double mean_light(const media_set *s, const light *from)
{
    enum { SEGMENTS = 400 };
    media_segment on = ahead;
    media_samples samples;
    double sum = 0.0;
    media_march l;
    model none;

    memset(&none, 0, sizeof none);
    for (uint32_t k = 0; k < SEGMENTS; k++) {
        on.from.x = (double)k * 1e-12;
        begin(&l, &none, s, &on);
        if (media_sample_light(&l, from, light_class_of(from), 0, &samples))
            for (uint32_t i = 0; i < samples.count; i++)
                sum += (double)samples.value[i].r;
    }
    return sum / SEGMENTS;
}

static void samples_of_light_add_up_to_the_integral(void **state)
{
    const medium m = grey_medium(0.0f, 0.0f, 0.6f);
    media_set s = set_of(&m, 1);
    light l = light_at(1.0, 2.0, -3.0);
    const double whole = 1.0 - exp(-2.0 * (double)0.6f);
    double fading = 0.0;
    (void)state;

    assert_near(mean_light(&s, &l), whole, 2e-3 * whole);
    s.strata = 40;
    assert_near(mean_light(&s, &l), whole, 1e-3 * whole);
    l.fade_distance = 0.5;
    l.fade_power = 2.0;
    l.position = pov_vec3_of(0.2, 0.0, 1.0);
    for (int i = 0; i < 100000; i++) {
        const double at = ((double)i + 0.5) * 2e-5, square = 0.04 + (at - 1.0) * (at - 1.0);

        fading += 2e-5 * (double)0.6f * exp(-(double)0.6f * at) * 2.0 / (1.0 + square / 0.25);
    }
    assert_near(mean_light(&s, &l), fading, 2e-3 * fading);
}

static void faint_light_has_few_samples(void **state)
{
    const medium faint = grey_medium(0.0f, 0.0f, 1e-3f), bright = grey_medium(0.0f, 0.0f, 1.0f);
    const media_set dim = set_of(&faint, 1), strong = set_of(&bright, 1);
    const light l = light_at(1.0, 2.0, -3.0);
    media_samples few, many;
    media_march march;
    model none;
    (void)state;

    memset(&none, 0, sizeof none);
    begin(&march, &none, &dim, &ahead);
    assert_true(media_sample_light(&march, &l, light_class_of(&l), 0, &few));
    begin(&march, &none, &strong, &ahead);
    assert_true(media_sample_light(&march, &l, light_class_of(&l), 0, &many));
    assert_true(few.count <= 4 && many.count > 8);
}

/* Does each of 64 equal strata hold a sample? */
static bool are_spread_evenly(const light *l)
{
    medium m = grey_medium(0.0f, 0.0f, 0.01f);
    media_samples samples;
    media_march march;
    media_set s;
    model none;

    memset(&none, 0, sizeof none);
    m.type = SCATTER_HAZE;
    s = set_of(&m, 1);
    s.strata = LANES_MAX;
    begin(&march, &none, &s, &ahead);
    if (!media_sample_light(&march, l, light_class_of(l), 0, &samples) || samples.count != LANES_MAX)
        return false;
    for (uint32_t i = 0; i < LANES_MAX; i++)
        if ((uint32_t)(samples.at[i] / ahead.length * LANES_MAX) != i)
            return false;
    return true;
}

static void strata_are_equal_where_a_light_is_far(void **state)
{
    const light far = light_at(0.0, 9.0, 1.0), near = light_at(0.0, 0.1, 1.0), behind = light_at(0.0, 0.1, -9.0);
    (void)state;

    assert_true(are_spread_evenly(&far) && are_spread_evenly(&behind));
    assert_false(are_spread_evenly(&near));
}

/* ---- where lights reach ---- */

static bool is_lit(const light *l, pov_vec3 at)
{
    const pov_vec3 v = pov_sub(at, l->position), off = pov_cross_product(v, l->axis);

    if (l->type == LIGHT_CYLINDER)
        return pov_dot(off, off) < l->falloff * l->falloff;
    return pov_dot(pov_unit(v), l->axis) > l->falloff;
}

/* Of many points on many lines those that are lit lie within the reach, and the reach begins and ends near one of them. */
static void assert_reach(const light *l)
{
    enum { POINTS = 2000 };
    uint32_t lit_lines = 0;

    for (int k = 0; k < 60; k++) {
        const pov_vec3 from = pov_vec3_of(3.0 * sin(k * 1.7), 2.0 * sin(k * 0.9), 3.0 * sin(k * 2.3));
        const pov_vec3 dir = pov_unit(pov_vec3_of(sin(k * 0.7), sin(k * 1.3 + 1.0), sin(k * 2.9 + 2.0)));
        double lo = 0.0, hi = 10.0, first = HUGE_VAL, last = -HUGE_VAL;
        bool reaches;

        for (int i = 0; i < POINTS; i++) {
            const double t = 10.0 * ((double)i + 0.5) / POINTS;

            if (is_lit(l, pov_add(from, pov_scale(dir, t)))) {
                first = fmin(first, t);
                last = t;
            }
        }
        reaches = light_reach(l, from, dir, &lo, &hi);
        if (first > last)
            continue;
        lit_lines++;
        assert_true(reaches);
        assert_near(lo, first, 10.0 / POINTS);
        assert_near(hi, last, 10.0 / POINTS);
    }
    assert_true(lit_lines > 5);
}

static void a_light_reaches_what_its_cone_holds(void **state)
{
    light l = light_at(0.0, 0.5, -1.0);
    (void)state;

    l.axis = pov_unit(pov_vec3_of(0.2, -0.5, 1.0));
    l.type = LIGHT_SPOT;
    l.radius = 0.9;
    l.falloff = 0.8;
    assert_reach(&l);
    l.type = LIGHT_CYLINDER;
    l.radius = 0.5;
    l.falloff = 0.9;
    assert_reach(&l);
}

static void points_of_light_reach_everywhere(void **state)
{
    const light l = light_at(0.0, 0.0, 0.0);
    double lo = 0.25, hi = 3.0;
    (void)state;

    assert_true(light_reach(&l, pov_vec3_of(1.0, 0.0, 0.0), pov_vec3_of(0.0, 0.0, 1.0), &lo, &hi));
    assert_true(lo == 0.25 && hi == 3.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(strata_cover_the_segment_in_order),
        cmocka_unit_test(strata_are_small_where_much_happens),
        cmocka_unit_test(endless_strata_begin_at_the_scale_of_the_scene),
        cmocka_unit_test(jitter_of_neighbours_cancels),
        cmocka_unit_test(constant_media_have_closed_forms),
        cmocka_unit_test(thin_media_lose_no_digits),
        cmocka_unit_test(media_that_only_shine_take_no_light),
        cmocka_unit_test(segments_together_leave_what_each_leaves),
        cmocka_unit_test(only_so_many_media_act),
        cmocka_unit_test(strata_are_split_where_those_beside_them_differ),
        cmocka_unit_test(split_strata_keep_their_points),
        cmocka_unit_test(phases_are_those_of_povray),
        cmocka_unit_test(samples_of_light_add_up_to_the_integral),
        cmocka_unit_test(faint_light_has_few_samples),
        cmocka_unit_test(strata_are_equal_where_a_light_is_far),
        cmocka_unit_test(a_light_reaches_what_its_cone_holds),
        cmocka_unit_test(points_of_light_reach_everywhere),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
