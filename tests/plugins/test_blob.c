/* test_blob.c - a blob of many components is the same in whatever order they are written, and however many rays are asked at once. */
#include "base/mix.h"
#include "plug/shape_class.h"

#include "support/check.h"
#include "support/fake_reader.h"

#include <math.h>
#include <string.h>

/* SAME are in one place, more than a point keeps apart. */
enum { COMPONENTS = 400, SAME = 60, RAYS = 4000, MOST = 64, PACKET = 8 };

static const shape_class *blob;
static uint64_t state = 20261126;

static double uniform(void)
{
    state += 0x9e3779b97f4a7c15u;
    return (double)(mix_bits(state) >> 11) * 0x1p-53;
}

static pov_vec3 somewhere(double size)
{
    const double x = uniform(), y = uniform(), z = uniform();

    return pov_vec3_of(size * (2.0 * x - 1.0), size * (2.0 * y - 1.0), size * (2.0 * z - 1.0));
}

/* A sphere if both ends are one. */
typedef struct written { pov_vec3 from, to; double radius, strength; } written;

static void put_vector(pov_reader *in, pov_vec3 v)
{
    fake_reader_text(in, "<");
    fake_reader_number(in, v.x);
    fake_reader_text(in, ",");
    fake_reader_number(in, v.y);
    fake_reader_text(in, ",");
    fake_reader_number(in, v.z);
    fake_reader_text(in, ">,");
}

static void *make(pov_reader *in, const written *all, const uint32_t *order)
{
    fake_reader_text(in, "threshold .4");
    for (uint32_t i = 0; i < COMPONENTS; i++) {
        const written *w = &all[order[i]];
        const bool is_sphere = w->from.x == w->to.x;

        fake_reader_text(in, is_sphere ? "sphere {" : "cylinder {");
        put_vector(in, w->from);
        if (!is_sphere)
            put_vector(in, w->to);
        fake_reader_number(in, w->radius);
        fake_reader_text(in, ",");
        fake_reader_number(in, w->strength);
        fake_reader_text(in, "}");
    }
    return fake_reader_parse(in, blob);
}

static void write_all(written *all)
{
    for (uint32_t i = 0; i < COMPONENTS; i++) {
        written *w = &all[i];

        w->from = w->to = i < SAME ? pov_vec3_of(0.2, 0.3, 0.1) : somewhere(1.0);
        if (i % 3 == 0)
            w->to = pov_add(w->from, somewhere(0.2));
        w->radius = i < SAME ? 0.4 : 0.1 + 0.1 * uniform();
        w->strength = i < SAME ? 0.02 : uniform() < 0.2 ? -0.5 : 1.0;
    }
}

static void mix_order(uint32_t *order)
{
    for (uint32_t i = 0; i < COMPONENTS; i++) {
        const uint32_t k = (uint32_t)((i + 1) * uniform());

        order[i] = order[k];
        order[k] = i;
    }
}

static uint32_t cross(void *self, const pov_ray *ray, pov_crossing *at)
{
    static double scratch[COMPONENTS * 3 * 16];
    pov_hits hits = { .tmax = HUGE_VAL, .want = POV_WANT_ALL, .at = at, .capacity = MOST, .owner = 0, .scratch = scratch };

    assert_true(blob->scratch(self) <= sizeof scratch);
    blob->intersect(self, ray, &hits);
    return hits.count;
}

/* Sums of many are rounded otherwise. */
static void compare(void *one, void *other, const pov_ray *ray)
{
    pov_crossing at[MOST], again[MOST];
    const uint32_t n = cross(one, ray, at);

    assert_int_equal(n, cross(other, ray, again));
    for (uint32_t i = 0; i < n; i++) {
        pov_vec3 a, b;

        assert_true(fabs(at[i].t - again[i].t) <= 1e-9);
        blob->normal(one, ray, &at[i], &a);
        blob->normal(other, ray, &again[i], &b);
        assert_true(pov_largest(pov_sub(a, b)) <= 1e-6);
    }
}

static void the_order_of_components_does_not_matter(void **user)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    pov_reader *in = fake_reader_create();
    written all[COMPONENTS];
    uint32_t order[COMPONENTS], mixed[COMPONENTS];
    void *one, *other;
    int within = 0;

    (void)user;
    write_all(all);
    for (uint32_t i = 0; i < COMPONENTS; i++)
        order[i] = i;
    mix_order(mixed);
    one = make(in, all, order);
    fake_reader_clear(in);
    other = make(in, all, mixed);
    assert_true(one && other);
    for (int i = 0; i < RAYS; i++) {
        const pov_vec3 p = somewhere(1.1);
        const pov_ray ray = { .org = somewhere(3.0), .dir = pov_sub(p, somewhere(0.1)), .origin_surface = POV_NO_OWNER };

        compare(one, other, &ray);
        assert_int_equal(blob->inside(one, p, zero), blob->inside(other, p, zero));
        within += blob->inside(one, p, zero);
    }
    assert_true(within > RAYS / 50 && within < RAYS - RAYS / 50);
    fake_reader_destroy(in);
}

/* Rays side by side from one place, every other one going on from where it meets the blob. */
static void set_off(void *self, pov_ray *ray, const pov_ray **rays)
{
    const pov_vec3 from = somewhere(2.0);
    pov_crossing at[MOST];

    for (int i = 0; i < PACKET; i++) {
        ray[i] = (pov_ray){ .org = from, .dir = pov_sub(somewhere(0.9), from), .origin_surface = POV_NO_OWNER };
        rays[i] = &ray[i];
        if (i % 2 == 0 || cross(self, &ray[i], at) == 0)
            continue;
        ray[i].org = pov_add(from, pov_scale(ray[i].dir, at[0].t));
        ray[i].dir = somewhere(1.0);
        ray[i].origin_surface = 0;
        ray[i].origin_mark = at[0].mark;
    }
}

static void rays_side_by_side_meet_it_as_each_alone(void **user)
{
    static double scratch[COMPONENTS * 3 * 16];
    pov_reader *in = fake_reader_create();
    written all[COMPONENTS];
    uint32_t order[COMPONENTS], crossed = 0;
    void *self;

    (void)user;
    write_all(all);
    for (uint32_t i = 0; i < COMPONENTS; i++)
        order[i] = i;
    self = make(in, all, order);
    assert_non_null(self);
    for (int k = 0; k < RAYS / PACKET; k++) {
        const void *selves[PACKET];
        const pov_ray *rays[PACKET];
        pov_ray ray[PACKET];
        pov_crossing at[PACKET];
        pov_hits hits[PACKET], *asked[PACKET];

        set_off(self, ray, rays);
        memset(at, 0, sizeof at);
        for (int i = 0; i < PACKET; i++) {
            selves[i] = self;
            hits[i] = (pov_hits){ .tmax = HUGE_VAL, .want = POV_WANT_NEAREST, .at = &at[i], .capacity = 1, .owner = 0, .scratch = scratch };
            asked[i] = &hits[i];
        }
        blob->intersect_many(selves, rays, asked, PACKET);
        for (int i = 0; i < PACKET; i++) {
            pov_crossing one;
            pov_hits alone = { .tmax = HUGE_VAL, .want = POV_WANT_NEAREST, .at = &one, .capacity = 1, .owner = 0, .scratch = scratch };

            blob->intersect(self, rays[i], &alone);
            assert_int_equal(hits[i].count, alone.count);
            assert_true(alone.count == 0 || (at[i].t == one.t && at[i].t_lo == one.t_lo));
            crossed += alone.count;
        }
    }
    assert_true(crossed > RAYS / 10);
    fake_reader_destroy(in);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_order_of_components_does_not_matter),
        cmocka_unit_test(rays_side_by_side_meet_it_as_each_alone),
    };

    blob = fake_reader_shape("blob");
    return blob ? cmocka_run_group_tests(tests, NULL, NULL) : 1;
}
