/* test_torus_filter.c - tori that are turned, stretched and moved, their rays in packets: what the filter leaves out, lets light
 * end at or bounds must be what each ray finds by itself without filters, bit for bit. Rays start far away, near the tori and on them.
 * Without arguments a short run; test_torus_filter RAYS for a long one. */
#include "query/context.h"   /* before probe.h, whose name for a kind it uses for a parameter */

#include "numerics/families.h"

#include "support/check.h"
#include "support/fake_reader.h"
#include "support/shapes.h"

#include <stdlib.h>
#include <string.h>

enum { TORI = 4, RAYS_OF_A_SCENE = 1024 };

#define U families_uniform

static long rays = 40000;

typedef struct side { world *world; query_context *context; } side;
typedef struct kept { uint32_t count; pov_ray rays[WORLD_MANY]; hit truth[WORLD_MANY]; } kept;
typedef struct scene {
    model model;
    side filtered, plain;
    double size;
    kept of[8];                  /* rays by octant */
} scene;
typedef struct tally { long rays, hits, dark; } tally;

static pov_vec3 anywhere(double size) { return pov_vec3_of(size * (2.0 * U() - 1.0), size * (2.0 * U() - 1.0), size * (2.0 * U() - 1.0)); }

static void add_torus(scene *s, pov_reader *in)
{
    const shape_class *shape = fake_reader_shape("torus");
    void *self = fake_reader_memory(in, shape->instance_size);
    const double major = s->size * (0.1 + U()), minor = U() < 0.2 ? s->size * (0.1 + U()) : major * (U() < 0.2 ? 1e-3 : U());
    const transform *t = NULL;
    probe p;

    memset(&p, 0, sizeof p);
    p.kind = TORUS;
    p.count = 2;
    p.size = s->size;
    p.number[0] = major;
    p.number[1] = minor;
    assert_true(probe_make(&p, shape, in, self));
    if (U() < 0.4)
        t = test_transform(&s->model, t, TRANSFORM_SCALE, 0.2 + U(), 0.2 + U(), 0.2 + U());
    t = test_transform(&s->model, t, TRANSFORM_ROTATE, 360.0 * U(), 360.0 * U(), 360.0 * U());
    t = test_transform(&s->model, t, TRANSFORM_TRANSLATE, s->size * U(), s->size * U(), s->size * U());
    test_add(&s->model, shape, self, t, 0, 0);
}

static void compile(side *out, const model *m, pov_accel accel)
{
    const world_options options = { .accel = accel, .threads = 1 };

    assert_int_equal(world_create(&out->world, m, &options, NULL), POV_OK);
    assert_int_equal(query_context_create(&out->context, out->world, NULL), POV_OK);
}

static void discard(side *s)
{
    query_context_destroy(s->context);
    world_destroy(s->world);
}

static pov_ray new_ray(const scene *s)
{
    static const double far[] = { 0.3, 3.0, 10.0, 1e3, 1e6, 1e9 };
    const pov_vec3 target = anywhere(s->size), dir = families_direction();
    pov_ray ray;

    memset(&ray, 0, sizeof ray);
    ray.org = pov_sub(target, pov_scale(dir, s->size * far[(uint32_t)(6.0 * U())]));
    ray.dir = pov_scale(dir, U() < 0.5 ? 1.0 : 1e-3);
    ray.origin_surface = POV_NO_OWNER;
    return ray;
}

static void compare(const scene *s, const kept *of, uint32_t first, uint32_t n, tally *out)
{
    const double most = of->truth[first].object == POV_NO_OWNER ? HUGE_VAL : of->truth[first].crossing.t * (1.0 + U());
    const pov_ray *some[WORLD_MANY];
    hit hits[WORLD_MANY];
    occlusion found;
    uint64_t met, clear;

    for (uint32_t i = 0; i < n; i++)
        some[i] = &of->rays[first + i];
    met = query_nearest(s->filtered.world, s->filtered.context, some, n, HUGE_VAL, hits);
    clear = query_occlusion(s->filtered.world, s->filtered.context, some, n, most, &found);
    for (uint32_t i = 0; i < n; i++) {
        const hit *truth = &of->truth[first + i];
        uint32_t owners[TEST_CROSSINGS], count;

        assert_int_equal(met >> i & 1, truth->object != POV_NO_OWNER);
        if (met >> i & 1) {
            assert_int_equal(hits[i].object, truth->object);
            assert_true(hits[i].crossing.t == truth->crossing.t && hits[i].crossing.t_lo == truth->crossing.t_lo);
        }
        assert_int_equal(clear >> i & 1, test_light(s->plain.world, s->plain.context, some[i], most, owners, &count));
        out->dark += !(clear >> i & 1);
    }
}

/* Ask a ray by itself, and with others of its octant as soon as these make a packet. */
static bool ask(scene *s, const pov_ray *ray, hit *h, tally *out)
{
    const bool met = test_nearest(s->plain.world, s->plain.context, ray, HUGE_VAL, h);
    kept *of = &s->of[bvh_octant(ray)];

    of->rays[of->count] = *ray;
    of->truth[of->count++] = *h;
    out->rays++;
    out->hits += met;
    if (of->count == WORLD_MANY) {
        compare(s, of, 0, WORLD_MANY, out);
        compare(s, of, 30, 11, out);
        of->count = 0;
    }
    return met;
}

static void ask_all(scene *s, tally *out)
{
    for (int i = 0; i < RAYS_OF_A_SCENE; i++) {
        pov_ray ray = new_ray(s);
        hit h;

        for (int turn = 0; turn < 4 && ask(s, &ray, &h, out); turn++) {
            world_surface(s->plain.world, &ray, &h);
            ray.org = h.point;
            ray.org_lo = h.point_lo;
            ray.dir = turn % 2 ? ray.dir : families_direction();
            memset(&ray.dir_lo, 0, sizeof ray.dir_lo);
            test_leave(&ray, &h);
        }
    }
}

static void filters_find_what_rays_find_alone(void **state)
{
    static const double sizes[] = { 1.0, 1e-6, 1e9 };
    tally all = { 0, 0, 0 };

    (void)state;
    families_seed(20261126);
    for (int round = 0; all.rays < rays; round++) {
        pov_reader *in = fake_reader_create();
        scene s;

        memset(&s, 0, sizeof s);
        test_model_init(&s.model, NULL);
        s.size = sizes[round % 3];
        for (int i = 0; i < TORI; i++)
            add_torus(&s, in);
        compile(&s.filtered, &s.model, POV_ACCEL_TREE);
        compile(&s.plain, &s.model, POV_ACCEL_NONE);
        ask_all(&s, &all);
        discard(&s.filtered);
        discard(&s.plain);
        model_free(&s.model);
        fake_reader_destroy(in);
    }
    print_message("%ld rays, %ld hits, %ld dark\n", all.rays, all.hits, all.dark);
    assert_true(all.hits > rays / 3 && all.dark > rays / 5);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(filters_find_what_rays_find_alone) };

    if (argc > 1)
        rays = strtol(argv[1], NULL, 10);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
