/* The box that the world has around a sphere in a space of its own: what is drawn in, and where it ends. */
#include "support/check.h"
#include "support/maps.h"

#include "world/instance.h"

#include <povtrace/exact.h>

#include <math.h>
#include <stdlib.h>

enum { MAPS = 100000, BATCH = 1000 };

/* Where the largest sphere about the middle of the box ends on that side of axis i: its centre taken to the world, and
 * on by the radius times the length of the map's row. */
static pov_two ends(const pov_affine *map, const pov_box *own, int i, double side)
{
    const double lo[3] = { own->lo.x, own->lo.y, own->lo.z }, hi[3] = { own->hi.x, own->hi.y, own->hi.z };
    pov_two definite_pair = pov_two_of(2.0 * map->m[i][3], 2.0 * map->m_lo[i][3]), square = pov_two_of(0.0, 0.0);
    pov_two edge = pov_two_of(HUGE_VAL, 0.0);
    int j;

    for (j = 0; j < 3; j++) {
        const pov_two m = pov_two_of(map->m[i][j], map->m_lo[i][j]), e = pov_two_sum(hi[j], -lo[j]);

        definite_pair = pov_two_add(definite_pair, pov_two_mul(m, pov_two_sum(hi[j], lo[j])));
        square = pov_two_add(square, pov_two_mul(m, m));
        edge = pov_two_less(e, edge) ? e : edge;
    }
    definite_pair = pov_two_add(definite_pair, pov_two_scale(pov_two_mul(pov_two_sqrt(square), edge), side));
    return pov_two_scale(definite_pair, 0.5);
}

/* No end is left out, and none is left further than by roundings of the numbers that it comes of. */
static void check_side(const pov_affine *map, const pov_box *own, int i, double side, double drawn, double wide)
{
    const double off = pov_two_sub(pov_two_of(side * drawn, 0.0), pov_two_scale(ends(map, own, i, side), side)).hi;
    const double size = fabs(map->m[i][0]) + fabs(map->m[i][1]) + fabs(map->m[i][2]);

    assert_true(off >= 0.0 && side * drawn <= side * wide);
    assert_true(off <= 0x1p-46 * size * (pov_largest(own->lo) + pov_largest(own->hi)) + 0x1p-50 * fabs(drawn));
}

/* Bounds of a sphere may be wider than it is by eight units in the last place, here on one side. */
static pov_box widened(pov_box b, bool above)
{
    int i;

    for (i = 0; i < 8; i++) {
        if (above)
            b.hi = pov_vec3_of(pov_next(b.hi.x), pov_next(b.hi.y), pov_next(b.hi.z));
        else
            b.lo = pov_vec3_of(-pov_next(-b.lo.x), -pov_next(-b.lo.y), -pov_next(-b.lo.z));
    }
    return b;
}

static void check_drawn(const pov_affine *map, const pov_box *own, bool above)
{
    const pov_box bounds = widened(*own, above);
    pov_box wide, drawn;

    instance_box(map, &bounds, &wide);
    drawn = wide;
    instance_shrink_box(map, &bounds, &drawn);
    check_side(map, own, 0, -1.0, drawn.lo.x, wide.lo.x);
    check_side(map, own, 0, 1.0, drawn.hi.x, wide.hi.x);
    check_side(map, own, 1, -1.0, drawn.lo.y, wide.lo.y);
    check_side(map, own, 1, 1.0, drawn.hi.y, wide.hi.y);
    check_side(map, own, 2, -1.0, drawn.lo.z, wide.lo.z);
    check_side(map, own, 2, 1.0, drawn.hi.z, wide.hi.z);
}

static void the_box_of_a_mapped_sphere_ends_where_it_does(void **state)
{
    test_random r = { 17 };
    pov_affine map;
    int i, j;

    (void)state;
    for (i = 0; i < MAPS; i += BATCH) {
        model m;

        test_model_init(&m, NULL);
        for (j = 0; j < BATCH; j++) {
            const pov_vec3 dir = pov_scale(test_direction(&r), test_power(&r, -2.0, 6.0));
            const pov_box cube = test_random_cube(&r), own = { pov_add(cube.lo, dir), pov_add(cube.hi, dir) };

            assert_true(transform_compose(test_random_map(&m, &r), &map));
            check_drawn(&map, &own, test_below(&r, 2));
        }
        model_free(&m);
    }
}

static void scale_rows(pov_affine *map, double by)
{
    int i, j;

    for (i = 0; i < 3; i++)
        for (j = 0; j < 4; j++)
            map->m[i][j] *= by, map->m_lo[i][j] *= by;
}

/* A size that is a power of two changes nothing else, until squares overflow or vanish; there nothing is drawn in. */
static void spheres_of_any_size_keep_within_their_boxes(void **state)
{
    static const int powers[] = { -900, -600, -480, -400, -100, 100, 400, 600, 900 };
    const pov_box own = { { -1.0, 0.0, 1.0 }, { 1.0, 2.0, 3.0 } };
    pov_affine first;
    size_t i;
    model m;

    (void)state;
    test_model_init(&m, NULL);
    assert_true(transform_compose(test_transform(&m, test_transform(&m, NULL, TRANSFORM_SCALE, 1.0, 2.0, 0.5),
                                                 TRANSFORM_ROTATE, 20.0, 30.0, 50.0), &first));
    for (i = 0; i < sizeof powers / sizeof *powers; i++) {
        const double size = ldexp(1.0, powers[i]);
        const bool far = powers[i] < -465 || powers[i] > 500;
        pov_affine map = first;
        pov_box one, wide, drawn;

        instance_box(&map, &own, &one);
        instance_shrink_box(&map, &own, &one);
        scale_rows(&map, size);
        instance_box(&map, &own, &wide);
        drawn = wide;
        instance_shrink_box(&map, &own, &drawn);
        assert_true(drawn.lo.x == (far ? wide.lo.x : one.lo.x * size));
        assert_true(drawn.hi.y == (far ? wide.hi.y : one.hi.y * size));
        assert_true(far || drawn.hi.y - drawn.lo.y < 0.8 * (wide.hi.y - wide.lo.y));
    }
    model_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_box_of_a_mapped_sphere_ends_where_it_does),
        cmocka_unit_test(spheres_of_any_size_keep_within_their_boxes),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
