/* The box of what half-spaces have in common holds it, and is tight; nothing infinite gets one. */
#include "support/check.h"

#include "base/mix.h"
#include "world/half_space.h"

#include <string.h>

static void add(half_spaces *all, double x, double y, double z, double distance)
{
    const pov_vec3 normal = { x, y, z };
    const double length = sqrt(pov_dot(normal, normal));
    const pov_half_space h = { pov_scale(normal, 1.0 / length), distance / length };

    half_spaces_add(all, &h, false, all->count);
}

static double random_in(uint64_t *state, double lo, double hi)
{
    *state += 0x9e3779b97f4a7c15u;
    return lo + (hi - lo) * (double)(mix_bits(*state) >> 11) * 0x1p-53;
}

static bool holds(const half_spaces *all, pov_vec3 p)
{
    for (uint32_t i = 0; i < all->count; i++)
        if (pov_dot(all->of[i].normal, p) > all->of[i].distance)
            return false;
    return true;
}

static void an_octahedron_has_the_box_of_its_corners(void **state)
{
    half_spaces all = { 0 };
    pov_box b;

    (void)state;
    for (int i = 0; i < 8; i++)
        add(&all, i & 1 ? 1.0 : -1.0, i & 2 ? 2.0 : -2.0, i & 4 ? 4.0 : -4.0, 8.0);
    assert_true(half_spaces_bound(&all, &b));
    assert_true(b.hi.x >= 8.0 && b.hi.y >= 4.0 && b.hi.z >= 2.0 && b.lo.x <= -8.0 && b.lo.y <= -4.0 && b.lo.z <= -2.0);
    assert_true(b.hi.x < 8.0 + 1e-9 && b.lo.z > -2.0 - 1e-9);
}

static void boxes_hold_random_polyhedra(void **state)
{
    uint64_t seed = 7;
    int bounded = 0;

    (void)state;
    for (int turn = 0; turn < 300; turn++) {
        half_spaces all = { 0 };
        pov_box b;

        for (int i = 0; i < 5 + turn % 9; i++)
            add(&all, random_in(&seed, -1.0, 1.0), random_in(&seed, -1.0, 1.0), random_in(&seed, -1.0, 1.0),
                random_in(&seed, 0.05, 1.0));
        if (!half_spaces_bound(&all, &b))
            continue;
        bounded++;
        for (int i = 0; i < 500; i++) {
            const pov_vec3 p = { random_in(&seed, -9.0, 9.0), random_in(&seed, -9.0, 9.0), random_in(&seed, -9.0, 9.0) };

            assert_true(!holds(&all, p) || (p.x >= b.lo.x && p.x <= b.hi.x && p.y >= b.lo.y && p.y <= b.hi.y &&
                                            p.z >= b.lo.z && p.z <= b.hi.z));
        }
    }
    assert_true(bounded > 100);
}

static void infinite_ones_have_no_box(void **state)
{
    half_spaces slab = { 0 }, tube = { 0 }, corner = { 0 };
    pov_box b;

    (void)state;
    add(&slab, 1.0, 2.0, 3.0, 1.0);
    assert_false(half_spaces_bound(&slab, &b));
    add(&slab, -1.0, -2.0, -3.0, 1.0);
    assert_false(half_spaces_bound(&slab, &b));
    for (int i = 0; i < 7; i++)
        add(&tube, cos(0.9 * i), sin(0.9 * i), 0.0, 1.0);
    assert_false(half_spaces_bound(&tube, &b));
    add(&corner, 1.0, 0.1, 0.0, 1.0);
    add(&corner, 0.0, 1.0, 0.1, 1.0);
    add(&corner, 0.1, 0.0, 1.0, 1.0);
    assert_false(half_spaces_bound(&corner, &b));
    add(&corner, -1.0, -1.0, -1.0, 5.0);
    assert_true(half_spaces_bound(&corner, &b));
}

static void those_left_out_only_make_it_larger(void **state)
{
    half_spaces all = { 0 };
    pov_box b;

    (void)state;
    for (int i = 0; i < 40; i++)
        add(&all, cos(1.0 + i), sin(1.0 + i), 0.3 * (i % 5 - 2), 1.0);
    assert_int_equal(all.count, HALF_SPACES_MAX);
    assert_true(half_spaces_bound(&all, &b));
    assert_true(b.hi.x >= 0.9 && b.lo.y <= -0.9);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_octahedron_has_the_box_of_its_corners), cmocka_unit_test(boxes_hold_random_polyhedra),
        cmocka_unit_test(infinite_ones_have_no_box), cmocka_unit_test(those_left_out_only_make_it_larger),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
