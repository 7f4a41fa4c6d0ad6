/* Fog on segments side by side. */
#include "support/near.h"

#include "shade/fog.h"

#include <math.h>
#include <string.h>

static const fog ground = { .pigment = { .color = { 0.6f, 0.7f, 0.8f }, .filter = 0.25f }, .distance = 4.0, .layered = true,
                            .up = { 0.0, 1.0, 0.0 }, .offset = 0.2, .alt = 0.3 };

static void find(const fog_segments *s, fog_veils *out)
{
    fog one = ground;
    model m;

    memset(&m, 0, sizeof m);
    m.fogs.items = &one;
    m.fogs.count = 1;
    fog_find(&m, s, out);
}

static void set_segment(fog_segments *s, uint32_t i, double height, double slope, double length)
{
    lanes_put(&s->from, i, pov_vec3_of(0.1 * i, height, -1.0));
    lanes_put(&s->dir, i, pov_vec3_of(sqrt(1.0 - slope * slope), slope, 0.0));
    s->length[i] = length;
}

static double integral(double y) { return y <= 0.0 ? y : atan(y); }

static double passes(double height, double slope, double length)
{
    const double from = (height - ground.offset) / ground.alt, to = (height + slope * length - ground.offset) / ground.alt;
    const double level = from <= 0.0 ? 1.0 : 1.0 / (1.0 + from * from);
    const double course = to == from ? level * length : length * (integral(to) - integral(from)) / (to - from);

    if (length == HUGE_VAL)
        return slope > 0.0 ? exp(-(2.0 * atan(1.0) - integral(from)) / (slope / ground.alt) / ground.distance) : 0.0;
    return exp(-course / ground.distance);
}

/* heights: how many different ones they begin at. */
static void assert_like_alone(double lowest, double apart, uint32_t heights, double end)
{
    fog_segments all, one;
    fog_veils together, alone;

    for (uint32_t i = 0; i < LANES_MAX; i++)
        set_segment(&all, i, lowest + apart * (i % heights), 0.02 * ((double)(i % 21) - 10.0), i % 16 == 7 ? end : 0.5 + 0.1 * i);
    all.count = LANES_MAX;
    find(&all, &together);
    for (uint32_t i = 0; i < LANES_MAX; i++) {
        const double left = passes(all.from.y[i], all.dir.y[i], all.length[i]);

        set_segment(&one, 0, all.from.y[i], all.dir.y[i], all.length[i]);
        one.count = 1;
        fog_fill(&one);
        find(&one, &alone);
        assert_near(together.given[1][i], 0.7 * (1.0 - left), 1e-6);
        for (int k = 0; k < 3; k++) {
            assert_true(together.by[k][i] == alone.by[k][0]);
            assert_true(together.given[k][i] == alone.given[k][0]);
        }
    }
}

static void segments_from_one_height_are_like_each_alone(void **state)
{
    (void)state;
    assert_like_alone(3.0, 0.0, 1, 5.0);
    assert_like_alone(3.0, 0.0, 1, HUGE_VAL);
    assert_like_alone(-9.0, 0.0, 1, 2.0);
}

static void segments_from_many_heights_are_like_each_alone(void **state)
{
    (void)state;
    assert_like_alone(-1.0, 0.125, 13, 5.0);
    assert_like_alone(-1.0, 0.125, 13, HUGE_VAL);
    assert_like_alone(-90.0, 0.125, 13, 2.0);
    assert_like_alone(20.0, 0.125, 13, 2.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(segments_from_one_height_are_like_each_alone),
        cmocka_unit_test(segments_from_many_heights_are_like_each_alone),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
