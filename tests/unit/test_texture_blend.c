/* Entries of maps that values lie between: lanes side by side and long maps, which are not searched from the start, find the same. */
#include "support/check.h"
#include "texture/blend.h"

#include <math.h>

enum { ENTRIES = 70, MAPS = 40 };

static double draw(uint32_t *seed)
{
    *seed = *seed * 1664525u + 1013904223u;
    return (*seed >> 8) * 0x1p-24;
}

/* The first entry that is large enough counts, unless the last one is passed: between it and the one before, or it alone. */
static void is_found(const float *map, uint32_t count, double value, uint32_t low, double between)
{
    uint32_t i = 0;
    bool is_between;

    while (i + 1 < count && value > (double)map[i])
        i++;
    if (!(value < (double)map[count - 1]))
        i = count - 1;
    is_between = i > 0 && value < (double)map[i];
    assert_int_equal(low, is_between ? i - 1 : i);
    assert_true(between == (is_between ? (value - (double)map[i - 1]) / ((double)map[i] - (double)map[i - 1]) : 0.0));
}

/* Entries themselves, what lies beside them, before and behind all, and no number. */
static void fill_values(const float *map, uint32_t count, uint32_t *seed, double value[LANES_MAX])
{
    for (uint32_t i = 0; i < LANES_MAX; i++) {
        const double entry = (double)map[(uint32_t)(draw(seed) * count)];

        value[i] = i % 3 == 0 ? entry : i % 3 == 1 ? entry + 0x1p-40 * (draw(seed) - 0.5) : 1.2 * draw(seed) - 0.1;
    }
    value[7] = HUGE_VAL;
    value[8] = -HUGE_VAL;
    value[9] = NAN;
}

static void are_found(const float *map, uint32_t count, uint32_t *seed)
{
    double value[LANES_MAX];
    blending b;

    fill_values(map, count, seed, value);
    blend_find(&b, BLEND_MAP, map, count, value, LANES_MAX);
    for (uint32_t i = 0; i < LANES_MAX; i++)
        is_found(map, count, value[i], b.low[i], b.between[i]);
}

/* Steps of 0 are colours that change at once. */
static void values_lie_between_entries_that_rise(void **state)
{
    uint32_t seed = 3;
    (void)state;

    for (uint32_t count = 1; count <= ENTRIES; count++)
        for (int k = 0; k < MAPS; k++) {
            float map[ENTRIES] = { 0.05f };

            for (uint32_t i = 1; i < count; i++)
                map[i] = map[i - 1] + (draw(&seed) < 0.3 ? 0.0f : (float)(draw(&seed) * 2.0 / count));
            are_found(map, count, &seed);
        }
}

static void values_lie_between_entries_that_do_not_rise(void **state)
{
    uint32_t seed = 4;
    (void)state;

    for (uint32_t count = 2; count <= ENTRIES; count++)
        for (int k = 0; k < MAPS; k++) {
            float map[ENTRIES];

            for (uint32_t i = 0; i < count; i++)
                map[i] = (float)draw(&seed);
            are_found(map, count, &seed);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(values_lie_between_entries_that_rise),
        cmocka_unit_test(values_lie_between_entries_that_do_not_rise),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
