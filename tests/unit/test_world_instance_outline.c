/* The outline of a shape in a space of its own, in the world: a point is within the one as it is within the other. */
#include "support/check.h"
#include "support/maps.h"

#include "world/instance.h"

#include <math.h>

enum { MAPS = 2000, POINTS = 20 };

/* A cone with a slab that is aslant. */
static pov_outline draw_outline(test_random *r, const pov_box *own)
{
    const pov_vec3 half = pov_scale(pov_sub(own->hi, own->lo), 0.5);
    pov_outline o = { .centre = pov_add(own->lo, half), .slabs = 1, .round = true, .constant = -1.0 };

    o.normal[0] = pov_vec3_of(test_uniform(r, 0.1, 1.0) / half.x, test_uniform(r, -1.0, 1.0) / half.y, test_uniform(r, -1.0, 1.0) / half.z);
    o.lo[0] = test_uniform(r, -1.0, 0.0);
    o.hi[0] = test_uniform(r, 0.1, 1.0);
    o.square[0] = 1.0 / (half.x * half.x);
    o.square[1] = 1.0 / (half.y * half.y);
    o.square[2] = -0.25 / (half.z * half.z);
    o.square[3] = 0.3 / (half.x * half.y);
    o.square[4] = 0.2 / (half.x * half.z);
    o.square[5] = -0.4 / (half.y * half.z);
    o.linear = pov_vec3_of(0.1 / half.x, 0.2 / half.y, 0.5 / half.z);
    return o;
}

/* At w from the centre. */
static double slab_at(const pov_outline *o, pov_vec3 w) { return pov_dot(o->normal[0], w); }

static double quadric_at(const pov_outline *o, pov_vec3 w)
{
    const double *s = o->square;

    return s[0] * w.x * w.x + s[1] * w.y * w.y + s[2] * w.z * w.z + 2.0 * (s[3] * w.x * w.y + s[4] * w.x * w.z + s[5] * w.y * w.z + pov_dot(o->linear, w)) +
           o->constant;
}

static double sum_of(pov_vec3 v) { return fabs(v.x) + fabs(v.y) + fabs(v.z); }

/* What the terms of both amount to, before they cancel. */
static double terms_at(const pov_outline *o, pov_vec3 w)
{
    double most = 0.0;

    for (int i = 0; i < 6; i++)
        most = fmax(most, fabs(o->square[i]));
    return most * sum_of(w) * sum_of(w) + sum_of(o->linear) * sum_of(w) + sum_of(o->normal[0]) * sum_of(w);
}

static pov_vec3 anywhere(test_random *r, const pov_box *b)
{
    return pov_vec3_of(test_uniform(r, b->lo.x, b->hi.x), test_uniform(r, b->lo.y, b->hi.y), test_uniform(r, b->lo.z, b->hi.z));
}

static void points_are_within_both_or_neither(void **state)
{
    test_random r = { 5 };
    int moved_count = 0;

    (void)state;
    for (int i = 0; i < MAPS; i++) {
        const pov_box box = test_random_cube(&r);
        const pov_outline own = draw_outline(&r, &box);
        pov_outline moved = own;
        instance_xform p;
        pov_affine map;
        pov_box around;
        model m;

        test_model_init(&m, NULL);
        assert_true(transform_compose(test_random_map(&m, &r), &map));
        instance_box(&map, &box, &around);
        instance_init(&p, &map, &box, &around, 0);
        if (instance_outline(&p, &moved)) {
            moved_count++;
            for (int k = 0; k < POINTS; k++) {
                const pov_vec3 point = anywhere(&r, &box), at = pov_sub(point, own.centre);
                pov_vec3 there, low;
                double off;

                transform_point(&map, point, &there, &low);
                there = pov_add(pov_sub(there, moved.centre), low);
                off = 1e-6 + 1e-13 * terms_at(&moved, there);
                assert_true(fabs((slab_at(&moved, there) - moved.lo[0]) - (slab_at(&own, at) - own.lo[0])) < off);
                assert_true(fabs((slab_at(&moved, there) - moved.hi[0]) - (slab_at(&own, at) - own.hi[0])) < off);
                assert_true(fabs(quadric_at(&moved, there) - quadric_at(&own, at)) < off);
            }
        }
        model_free(&m);
    }
    assert_true(moved_count > MAPS / 2);
}

/* Far from its own origin doubles do not tell what its outline is. */
static void too_small_a_shape_has_none(void **state)
{
    const pov_box near = { { -1.0, -1.0, -1.0 }, { 1.0, 1.0, 1.0 } }, far = { { 1e9, -1.0, -1.0 }, { 1e9 + 2.0, 1.0, 1.0 } };
    test_random r = { 5 };
    pov_outline o = draw_outline(&r, &near), other = draw_outline(&r, &far);
    instance_xform p;
    pov_affine map;
    pov_box around;
    model m;

    (void)state;
    test_model_init(&m, NULL);
    assert_true(transform_compose(test_transform(&m, NULL, TRANSFORM_ROTATE, 10.0, 20.0, 30.0), &map));
    instance_box(&map, &near, &around);
    instance_init(&p, &map, &near, &around, 0);
    assert_true(instance_outline(&p, &o));
    instance_box(&map, &far, &around);
    instance_init(&p, &map, &far, &around, 0);
    assert_false(instance_outline(&p, &other));
    model_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(points_are_within_both_or_neither), cmocka_unit_test(too_small_a_shape_has_none) };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
