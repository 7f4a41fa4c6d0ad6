/* test_watertight.c - polygons that share edges and corners leave no gap between them, and do not overlap.
 *
 * Fans of triangles about a corner, flat ones and bent ones, seen from near and far: a ray at the corner, at an edge or
 * beside one meets exactly one of them. test_watertight RAYS for a long run. */
#include "numerics/families.h"

#include "support/check.h"
#include "support/fake_reader.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LEAST = 4, MOST = 9 };   /* three could stand with one of them turned over */

static long rays = 100000;

#define U families_uniform

static void feed(pov_reader *in, pov_vec3 v)
{
    fake_reader_word(in, "<");
    fake_reader_number(in, v.x);
    fake_reader_number(in, v.y);
    fake_reader_number(in, v.z);
    fake_reader_word(in, ">");
}

typedef struct fan {
    pov_vec3 middle, rim[MOST];
    int count;
    void *triangle[MOST];
} fan;

static void make_fan(fan *f, const shape_class *shape, pov_reader *in)
{
    const double place = U() < 0.3 ? 1e6 : 2.0, bend = U() < 0.5 ? 0.0 : 0.05;
    const pov_vec3 axis = families_direction();
    const pov_vec3 e = pov_unit(pov_cross_product(axis, families_direction())), g = pov_cross_product(axis, e);
    int i;

    f->middle = pov_scale(families_direction(), place * U());
    f->count = LEAST + (int)((MOST - LEAST + 1) * U());
    for (i = 0; i < f->count; i++) {
        const double angle = 6.283185307179586 * (i + 0.5 * U()) / f->count, r = 0.5 + U();

        f->rim[i] = pov_add(pov_add(f->middle, pov_scale(axis, bend * (2.0 * U() - 1.0))),
                            pov_add(pov_scale(e, r * cos(angle)), pov_scale(g, r * sin(angle))));
    }
    for (i = 0; i < f->count; i++) {
        fake_reader_clear(in);
        fake_reader_number(in, 4.0);
        /* Neighbours go along a shared edge in either sense. */
        if (U() < 0.5) {
            feed(in, f->middle);
            feed(in, f->rim[i]);
            feed(in, f->rim[(i + 1) % f->count]);
            feed(in, f->middle);
        } else {
            feed(in, f->rim[(i + 1) % f->count]);
            feed(in, f->rim[i]);
            feed(in, f->middle);
            feed(in, f->rim[(i + 1) % f->count]);
        }
        f->triangle[i] = fake_reader_parse(in, shape);
        assert_non_null(f->triangle[i]);
    }
}

/* Well inside the fan, whatever its shape: on a spoke's inner part, on the middle, or beside these. */
static pov_vec3 target_in(const fan *f)
{
    const pov_vec3 spoke = pov_sub(f->rim[(int)(f->count * U())], f->middle);
    const double along = U() < 0.2 ? 0.0 : 0.1 * U(), beside = U() < 0.5 ? 0.0 : pow(10.0, -16.0 * U() - 2.0);

    return pov_add(pov_add(f->middle, pov_scale(spoke, along)), pov_scale(families_direction(), beside));
}

static int count_hits(const fan *f, const shape_class *shape, const pov_ray *ray, bool always_exact)
{
    int i, hits_found = 0;

    for (i = 0; i < f->count; i++) {
        pov_crossing at[2];
        pov_hits hits = { -HUGE_VAL, HUGE_VAL, POV_WANT_ALL, always_exact, false, 0, 0, 2, 0, at, NULL, NULL, false, NULL, 0.0, false, always_exact };

        shape->intersect(f->triangle[i], ray, &hits);
        hits_found += (int)hits.count;
    }
    return hits_found;
}

/* From the side where a bent fan is seen as one sheet. */
static pov_ray ray_at(const fan *f, pov_vec3 target)
{
    const pov_vec3 normal = pov_unit(pov_cross_product(pov_sub(f->rim[0], f->middle), pov_sub(f->rim[1], f->middle)));
    const double distance = pow(10.0, 9.0 * U());
    pov_vec3 d = families_direction();
    pov_ray ray;

    d = pov_unit(pov_add(pov_scale(normal, U() < 0.5 ? 2.0 : -2.0), d));
    if (U() < 0.1)
        d = pov_vec3_of(floor(3.0 * d.x), floor(3.0 * d.y), floor(3.0 * d.z) + 0.5);
    memset(&ray, 0, sizeof ray);
    ray.org = pov_sub(target, pov_scale(d, distance));
    ray.dir = d;
    if (U() < 0.5)
        ray.dir = pov_sub(target, ray.org);
    ray.origin_surface = POV_NO_OWNER;
    return ray;
}

static bool aims_well(const pov_ray *ray, pov_vec3 target)
{
    /* A far origin is rounded: the ray still has to come within the fan. */
    const pov_vec3 to = pov_sub(target, ray->org);
    const double t = pov_dot(to, ray->dir) / pov_dot(ray->dir, ray->dir);

    return pov_largest(pov_sub(to, pov_scale(ray->dir, t))) < 0.02;
}

static void a_ray_at_a_shared_edge_or_corner_hits_exactly_one(void **state)
{
    const shape_class *shape = fake_reader_shape("polygon");
    long done = 0, wrong = 0;

    (void)state;
    assert_non_null(shape);
    families_seed(5);
    while (done < rays) {
        pov_reader *in = fake_reader_create();
        fan f;
        int i;

        make_fan(&f, shape, in);
        for (i = 0; i < 50; i++) {
            const pov_vec3 target = target_in(&f);
            const pov_ray ray = ray_at(&f, target);
            int found;

            if (!aims_well(&ray, target))
                continue;
            done++;
            found = count_hits(&f, shape, &ray, i % 16 == 0);
            if (found == 1)
                continue;
            if (wrong++ < 8)
                print_error("%d hits of %d: from <%a, %a, %a> along <%a, %a, %a>\n", found, f.count, ray.org.x, ray.org.y,
                            ray.org.z, ray.dir.x, ray.dir.y, ray.dir.z);
        }
        fake_reader_destroy(in);
    }
    assert_int_equal(wrong, 0);
}

/* ---- exactly on an edge ---- */

enum { GRID = 4 };

/* A unit square of whole corners; from (i, j, 0) along two of the axes. */
static void *make_square(const shape_class *shape, pov_reader *in, pov_vec3 corner, pov_vec3 e, pov_vec3 g)
{
    fake_reader_clear(in);
    fake_reader_number(in, 5.0);
    feed(in, corner);
    feed(in, pov_add(corner, e));
    feed(in, pov_add(pov_add(corner, e), g));
    feed(in, pov_add(corner, g));
    feed(in, corner);
    return fake_reader_parse(in, shape);
}

/* As a pixel's centre may: all numbers are small multiples of 1/4, so the ray meets edge and corner without any error. */
static pov_ray exact_ray(double x, double y, int number)
{
    pov_ray ray;

    memset(&ray, 0, sizeof ray);
    ray.dir = pov_vec3_of((number % 5 - 2) * 0.25, (number / 5 % 5 - 2) * 0.25, number / 25 % 2 ? 1.0 : -1.0);
    ray.org = pov_sub(pov_vec3_of(x, y, 0.0), pov_scale(ray.dir, 4.0));
    ray.origin_surface = POV_NO_OWNER;
    return ray;
}

static int hits_of(const shape_class *shape, void *const *squares, int count, const pov_ray *ray)
{
    int i, found = 0;

    for (i = 0; i < count; i++) {
        pov_crossing at[2];
        pov_hits hits = { 0.0, HUGE_VAL, POV_WANT_ALL, false, false, 0, 0, 2, 0, at, NULL, NULL, false, NULL, 0.0, false, false };

        shape->intersect(squares[i], ray, &hits);
        found += (int)hits.count;
    }
    return found;
}

static void a_ray_exactly_on_an_edge_of_two_polygons_hits_one_of_them(void **state)
{
    const shape_class *shape = fake_reader_shape("polygon");
    const pov_vec3 e = { 1.0, 0.0, 0.0 }, g = { 0.0, 1.0, 0.0 };
    pov_reader *in = fake_reader_create();
    void *squares[GRID * GRID];
    int i, j, number;

    (void)state;
    assert_non_null(shape);
    for (i = 0; i < GRID * GRID; i++)
        squares[i] = make_square(shape, in, pov_vec3_of(i % GRID, i / GRID, 0.0), e, g);
    for (number = 0; number < 50; number++) {
        for (i = 1; i < 2 * GRID; i++) {
            for (j = 1; j < 2 * GRID; j++) {
                const pov_ray ray = exact_ray(0.5 * i, 0.5 * j, number);
                assert_int_equal(hits_of(shape, squares, GRID * GRID, &ray), 1);
            }
        }
    }
    fake_reader_destroy(in);
}

/* Seen from where both polygons of an edge lie to the same side of it, as at the ridge of a roof: both or none. */
static void a_ray_exactly_on_the_outline_of_a_fold_hits_both_or_none(void **state)
{
    const shape_class *shape = fake_reader_shape("polygon");
    const pov_vec3 corner = { 0.0, 0.0, 0.0 }, edge = { 0.0, 4.0, 0.0 };
    pov_reader *in = fake_reader_create();
    void *fold[2];
    int j, number;

    (void)state;
    assert_non_null(shape);
    fold[0] = make_square(shape, in, corner, pov_vec3_of(4.0, 0.0, 2.0), edge);
    fold[1] = make_square(shape, in, corner, pov_vec3_of(4.0, 0.0, -2.0), edge);
    for (number = 0; number < 50; number++) {
        for (j = 1; j < 8; j++) {
            const pov_ray ray = exact_ray(0.0, 0.5 * j, number);
            assert_int_equal(hits_of(shape, fold, 2, &ray) % 2, 0);
        }
    }
    fake_reader_destroy(in);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_ray_at_a_shared_edge_or_corner_hits_exactly_one),
        cmocka_unit_test(a_ray_exactly_on_an_edge_of_two_polygons_hits_one_of_them),
        cmocka_unit_test(a_ray_exactly_on_the_outline_of_a_fold_hits_both_or_none),
    };

    if (argc > 1)
        rays = strtol(argv[1], NULL, 10);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
