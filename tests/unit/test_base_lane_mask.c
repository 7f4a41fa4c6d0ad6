/* Lanes as bits: what vectors of any width find is what a loop over the lanes finds. */
#include "base/lane_mask.h"
#include "support/check.h"

#include <math.h>

/* Lanes behind the last one are ones that must not count. */
static uint64_t fill(uint32_t of[LANES_MAX], uint32_t n, uint64_t bits)
{
    for (uint32_t i = 0; i < LANES_MAX; i++)
        of[i] = i >= n || (bits >> i & 1);
    return n < LANES_MAX ? bits & (((uint64_t)1 << n) - 1) : bits;
}

static void a_mask_has_the_ones_of_the_first_lanes(void **state)
{
    uint64_t bits = 0x9e3779b97f4a7c15u;
    uint32_t of[LANES_MAX];
    (void)state;

    for (uint32_t n = 0; n <= LANES_MAX; n++, bits = bits * 3 + 1) {
        const uint64_t wanted = fill(of, n, bits);

        assert_true(lane_mask_of(of, n) == wanted);
    }
}

/* No number is below one that is none, or the other way round. */
static void lanes_below_others_are_told(void **state)
{
    static const double some[] = { 0.0, -0.0, 1.0, -1.0, HUGE_VAL, -HUGE_VAL, NAN, 0x1p-1074 };
    double a[LANES_MAX], b[LANES_MAX];
    (void)state;

    for (uint32_t i = 0; i < LANES_MAX; i++) {
        a[i] = some[i % 8];
        b[i] = some[i / 8];
    }
    for (uint32_t n = 0; n <= LANES_MAX; n++) {
        const uint64_t found = lane_mask_below(a, b, n);

        assert_true((found & ~lane_mask_all(n)) == 0);
        for (uint32_t i = 0; i < n; i++)
            assert_int_equal(found >> i & 1, a[i] < b[i]);
    }
}

static void a_list_names_the_lanes_of_a_mask_in_order(void **state)
{
    static const uint64_t masks[] = { 0, 1, 2, 0xff, 0x8000000000000001u, 0x7fffffffffffffffu, ~(uint64_t)0, 0x9e3779b97f4a7c15u };
    (void)state;

    for (size_t k = 0; k < sizeof masks / sizeof *masks; k++) {
        uint8_t list[LANES_MAX];
        const uint32_t n = lane_mask_list(masks[k], list);
        uint64_t found = 0;

        assert_int_equal(n, lane_mask_count(masks[k]));
        for (uint32_t i = 0; i < n; i++) {
            assert_true(i == 0 || list[i] > list[i - 1]);
            found |= (uint64_t)1 << list[i];
        }
        assert_true(found == masks[k]);
    }
}

static void all_lanes_of_none_are_none(void **state)
{
    (void)state;
    assert_true(lane_mask_all(0) == 0);
    assert_true(lane_mask_all(3) == 7);
    assert_true(lane_mask_all(LANES_MAX) == ~(uint64_t)0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_mask_has_the_ones_of_the_first_lanes),
        cmocka_unit_test(lanes_below_others_are_told),
        cmocka_unit_test(a_list_names_the_lanes_of_a_mask_in_order),
        cmocka_unit_test(all_lanes_of_none_are_none),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
