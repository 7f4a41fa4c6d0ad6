/* world/transform_approx: boxes, of spheres too, hold those of the composed maps, and what is said of shapes is so. */
#include "support/check.h"
#include "support/maps.h"

#include "world/transform_approx.h"
#include "world/instance.h"

#include <math.h>
#include <string.h>

enum { BATCHES = 4000 };

/* An angle, now and then of whole quarters or of many turns. */
static double angle(test_random *r)
{
    if (!test_below(r, 4))
        return 90.0 * ((double)test_below(r, 12) - 6.0);
    return test_uniform(r, -360.0, 360.0) * (test_below(r, 4) ? 1.0 : test_power(r, 0.0, 5.0));
}

static const transform *random_step(model *m, test_random *r, const transform *before, transform_kind kind)
{
    const double size = test_power(r, -3.0, 3.0);

    if (kind == TRANSFORM_ROTATE)
        return test_transform(m, before, kind, angle(r), angle(r), angle(r) + 1e-3);
    return test_transform(m, before, kind, test_factor(r, size, 2.0), test_factor(r, size, 2.0),
                          test_factor(r, size, 2.0));
}

static pov_box random_box(test_random *r)
{
    const double size = test_power(r, -3.0, 3.0);
    const pov_vec3 far = pov_scale(test_direction(r), test_below(r, 2) ? 0.0 : 100.0 * size);
    pov_box b;

    b.lo = pov_sub(far, pov_vec3_of(size, size * test_power(r, -9.0, 0.0), size));
    b.hi = pov_add(far, pov_vec3_of(size, size, size));
    return b;
}

static bool holds(const pov_box *a, const pov_box *b)
{
    return a->lo.x <= b->lo.x && a->lo.y <= b->lo.y && a->lo.z <= b->lo.z && a->hi.x >= b->hi.x && a->hi.y >= b->hi.y &&
           a->hi.z >= b->hi.z;
}

/* By how much more than what it holds, against how far all of it may be. */
static double slack(const pov_box *a, const pov_box *b, const approx_maps *maps, int lane, const pov_box *own)
{
    const pov_vec3 more = pov_add(pov_sub(b->lo, a->lo), pov_sub(a->hi, b->hi));
    const double far = 3.0 * (pov_largest(own->lo) + pov_largest(own->hi));

    return pov_largest(more) / (maps->excluded[lane] + maps->size[lane] * far);
}

static void approx_boxes_hold_the_true_ones(void **state)
{
    test_random r = { 5 };
    double worst = 0.0;
    int i, j, k;

    (void)state;
    for (i = 0; i < BATCHES; i++) {
        const transform *lists[APPROX_MANY] = { NULL };
        const int n = 1 + (int)test_below(&r, APPROX_MANY), steps = 1 + (int)test_below(&r, 6);
        approx_maps maps;
        model m;

        test_model_init(&m, NULL);
        for (j = 0; j < steps; j++) {
            const transform_kind kind = (transform_kind)test_below(&r, 3);
            for (k = 0; k < n; k++)
                lists[k] = random_step(&m, &r, lists[k], kind);
        }
        assert_int_equal(transform_approx(lists, n, &maps), (1 << n) - 1);
        for (k = 0; k < n; k++) {
            const pov_box own = random_box(&r), cube = test_random_cube(&r);
            pov_box rough, around;
            pov_affine map;

            assert_true(transform_compose(lists[k], &map));
            instance_box(&map, &own, &around);
            assert_true(transform_approx_box(&maps, k, &own, false, &rough));
            assert_true(holds(&rough, &around));
            worst = fmax(worst, slack(&rough, &around, &maps, k, &own));
            instance_box(&map, &cube, &around);
            instance_shrink_box(&map, &cube, &around);
            assert_true(transform_approx_box(&maps, k, &cube, true, &rough));
            assert_true(holds(&rough, &around));
            worst = fmax(worst, slack(&rough, &around, &maps, k, &cube));
        }
        model_free(&m);
    }
    print_message("widest by 2^%.1f of all sizes\n", log2(worst));
    assert_true(worst < ldexp(1.0, -41));
}

/* Points of an ellipsoid stay in its box, and come near to each of its sides. */
static void round_boxes_hold_ellipsoids(void **state)
{
    test_random r = { 7 };
    int i, j, k;

    (void)state;
    for (i = 0; i < 200; i++) {
        const transform *list = NULL;
        const pov_box own = random_box(&r);
        const pov_vec3 c = pov_scale(pov_add(own.lo, own.hi), 0.5), half = pov_scale(pov_sub(own.hi, own.lo), 0.5);
        double most = -HUGE_VAL;
        approx_maps maps;
        pov_affine map;
        pov_box box, whole;
        model m;

        test_model_init(&m, NULL);
        list = random_step(&m, &r, list, TRANSFORM_SCALE);
        list = random_step(&m, &r, list, TRANSFORM_ROTATE);
        list = random_step(&m, &r, list, TRANSFORM_TRANSLATE);
        assert_int_equal(transform_approx(&list, 1, &maps), 1);
        assert_true(transform_approx_box(&maps, 0, &own, true, &box));
        assert_true(transform_approx_box(&maps, 0, &own, false, &whole));
        assert_true(holds(&whole, &box));
        assert_true(transform_compose(list, &map));
        for (j = 0; j < 200; j++) {
            const pov_vec3 dir = test_direction(&r);
            const pov_vec3 p = pov_add(c, pov_vec3_of(dir.x * half.x, dir.y * half.y, dir.z * half.z));
            const pov_vec3 at = pov_affine_point(&map, p);
            const double reach = maps.excluded[0] + maps.size[0] * 3.0 * (pov_largest(own.lo) + pov_largest(own.hi));
            const double on[3] = { at.x, at.y, at.z }, lo[3] = { box.lo.x, box.lo.y, box.lo.z };
            const double hi[3] = { box.hi.x, box.hi.y, box.hi.z };

            for (k = 0; k < 3; k++) {
                const double error = 0x1p-48 * reach;   /* of the point itself */
                assert_true(on[k] >= lo[k] - error && on[k] <= hi[k] + error);
                most = fmax(most, hi[k] - lo[k] > 0x1p-30 * reach ? (on[k] - lo[k]) / (hi[k] - lo[k]) : -HUGE_VAL);
            }
        }
        assert_true(most > 0.9 || most == -HUGE_VAL);
        model_free(&m);
    }
}

/* Too small for squares, they are as wide as boxes. */
static void tiny_ellipsoids_have_boxes_too(void **state)
{
    const pov_box own = { { -1e-90, -1e-90, -1e-90 }, { 1e-90, 1e-90, 1e-90 } };
    const transform *list;
    approx_maps maps;
    pov_box box;
    model m;

    (void)state;
    test_model_init(&m, NULL);
    list = test_transform(&m, NULL, TRANSFORM_SCALE, 1e-90, 2e-90, 1e-90);
    assert_int_equal(transform_approx(&list, 1, &maps), 1);
    assert_true(transform_approx_box(&maps, 0, &own, true, &box));
    assert_true(box.hi.x >= 1e-180 && box.hi.y >= 2e-180 && box.lo.z <= -1e-180);
    model_free(&m);
}

static void what_is_not_moderate_is_not_known(void **state)
{
    static const double matrix[12] = { 1, 2, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0 };
    const transform *list;
    approx_maps maps;
    model m;

    (void)state;
    test_model_init(&m, NULL);
    list = test_transform(&m, NULL, TRANSFORM_SCALE, 1e60, 1.0, 1.0);
    list = test_transform(&m, list, TRANSFORM_SCALE, 1e60, 1.0, 1.0);
    assert_int_equal(transform_approx(&list, 1, &maps), 0);
    list = test_transform(&m, NULL, TRANSFORM_SCALE, 1e-60, 1.0, 1.0);
    list = test_transform(&m, list, TRANSFORM_SCALE, 1.0, 1e-60, 1.0);
    assert_int_equal(transform_approx(&list, 1, &maps), 0);
    list = test_transform(&m, NULL, TRANSFORM_ROTATE, HUGE_VAL, 1.0, 1.0);
    assert_int_equal(transform_approx(&list, 1, &maps), 0);
    list = transform_append(&m.maps, NULL, TRANSFORM_MATRIX, matrix);
    assert_int_equal(transform_approx(&list, 1, &maps), 0);
    model_free(&m);
}

static double row_product(const pov_affine *f, int i, int j)
{
    return f->m[i][0] * f->m[j][0] + f->m[i][1] * f->m[j][1] + f->m[i][2] * f->m[j][2];
}

/* How far rows are from being of one length and at right angles. */
static double unevenness(const pov_affine *f)
{
    const double first = row_product(f, 0, 0);

    return fmax(fmax(fabs(row_product(f, 1, 1) - first), fabs(row_product(f, 2, 2) - first)),
                fmax(fmax(fabs(row_product(f, 0, 1)), fabs(row_product(f, 0, 2))), fabs(row_product(f, 1, 2)))) / first;
}

static bool has_two_in_a_row(const pov_affine *f)
{
    int i;

    for (i = 0; i < 3; i++)
        if ((f->m[i][0] != 0.0) + (f->m[i][1] != 0.0) + (f->m[i][2] != 0.0) > 1)
            return true;
    return false;
}

static void what_is_uneven_or_turned_is_so(void **state)
{
    test_random r = { 6 };
    int i, j, uneven = 0, turned = 0;

    (void)state;
    for (i = 0; i < BATCHES; i++) {
        const transform *list = NULL;
        const int steps = 1 + (int)test_below(&r, 4);
        pov_affine map;
        model m;

        test_model_init(&m, NULL);
        for (j = 0; j < steps; j++) {
            const transform_kind kind = (transform_kind)test_below(&r, 3);
            if (kind == TRANSFORM_ROTATE)
                list = test_transform(&m, list, kind, angle(&r), angle(&r), angle(&r));
            else
                list = random_step(&m, &r, list, kind);
        }
        assert_true(transform_compose(list, &map));
        assert_true(!transform_is_uneven(list) || unevenness(&map) > 1e-12);
        assert_true(!transform_is_turned(list) || has_two_in_a_row(&map));
        uneven += transform_is_uneven(list);
        turned += transform_is_turned(list);
        model_free(&m);
    }
    assert_true(uneven > BATCHES / 10 && turned > BATCHES / 10);
}

static void what_may_cancel_is_not_told(void **state)
{
    const transform *list;
    model m;

    (void)state;
    test_model_init(&m, NULL);
    list = test_transform(&m, NULL, TRANSFORM_SCALE, 2.0, -2.0, 2.0);
    assert_false(transform_is_uneven(list));
    list = test_transform(&m, NULL, TRANSFORM_SCALE, 2.0, 1.0, 1.0);
    assert_true(transform_is_uneven(list));
    assert_false(transform_is_uneven(test_transform(&m, list, TRANSFORM_SCALE, 0.5, 1.0, 1.0)));
    assert_false(transform_is_turned(test_transform(&m, NULL, TRANSFORM_ROTATE, 45.0, 90.0, -45.0)));
    assert_false(transform_is_turned(test_transform(&m, NULL, TRANSFORM_ROTATE, 90.0, 180.0, -270.0)));
    list = test_transform(&m, NULL, TRANSFORM_ROTATE, 0.0, 45.0, 0.0);
    assert_true(transform_is_turned(list));
    assert_false(transform_is_turned(test_transform(&m, list, TRANSFORM_ROTATE, 0.0, -45.0, 0.0)));
    model_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(approx_boxes_hold_the_true_ones),
        cmocka_unit_test(round_boxes_hold_ellipsoids),
        cmocka_unit_test(tiny_ellipsoids_have_boxes_too),
        cmocka_unit_test(what_is_not_moderate_is_not_known),
        cmocka_unit_test(what_is_uneven_or_turned_is_so),
        cmocka_unit_test(what_may_cancel_is_not_told),
    };

    return cmocka_run_group_tests_name("rough", tests, NULL, NULL);
}
