/* sides.h - the same scene compiled in two ways: rays by themselves, and packets of one octant, are held against each other. */
#ifndef NUMERICS_SIDES_H
#define NUMERICS_SIDES_H

#include "query/context.h"   /* before probe.h, whose name for a kind it uses for a parameter */

#include "numerics/families.h"

#include "support/check.h"
#include "support/shapes.h"

#include <string.h>

typedef struct side { world *world; query_context *context; } side;

/* Rays of an octant that were asked by themselves, and their nearest hits: without one the object is POV_NO_OWNER. */
typedef struct kept { uint32_t count; pov_ray rays[WORLD_MANY]; hit truth[WORLD_MANY]; } kept;

static inline void side_compile(side *out, const model *m, pov_accel accel, bool exact)
{
    const world_options options = { .accel = accel, .threads = 1, .always_exact = exact };

    assert_int_equal(world_create(&out->world, m, &options, NULL), POV_OK);
    assert_int_equal(query_context_create(&out->context, out->world, NULL), POV_OK);
}

static inline void side_discard(side *s)
{
    query_context_destroy(s->context);
    world_destroy(s->world);
}

/* To a place from near to a thousand million sizes away. */
static inline pov_ray side_ray(pov_vec3 target, pov_vec3 dir, double size)
{
    static const double far[] = { 0.3, 3.0, 10.0, 1e3, 1e6, 1e9 };
    pov_ray ray;

    memset(&ray, 0, sizeof ray);
    ray.org = pov_sub(target, pov_scale(dir, size * far[(uint32_t)(6.0 * families_uniform())]));
    ray.dir = pov_scale(dir, families_uniform() < 0.5 ? 1.0 : 1e-3);
    ray.origin_surface = POV_NO_OWNER;
    return ray;
}

/* Keeps a ray that was asked by itself. True: they are as many as a packet has, and start over after it. */
static inline bool side_keep(kept *of, const pov_ray *ray, const hit *h, bool met)
{
    of->rays[of->count] = *ray;
    of->truth[of->count] = *h;
    if (!met)
        of->truth[of->count].object = POV_NO_OWNER;
    of->count = (of->count + 1) % WORLD_MANY;
    return of->count == 0;
}

/* Some of them side by side, each as by itself, bit for bit; and their light up to a distance, as each has it alone on the other side.
 * Returns how many are dark. */
static inline uint32_t side_compare(const side *together, const side *alone, const kept *of, uint32_t first, uint32_t n, double most, hit *hits)
{
    const pov_ray *some[WORLD_MANY];
    uint32_t dark = 0;
    occlusion found;
    uint64_t met, clear;

    for (uint32_t i = 0; i < n; i++)
        some[i] = &of->rays[first + i];
    met = query_nearest(together->world, together->context, some, n, HUGE_VAL, hits);
    clear = query_occlusion(together->world, together->context, some, n, most, &found);
    for (uint32_t i = 0; i < n; i++) {
        const hit *truth = &of->truth[first + i];
        uint32_t owners[TEST_CROSSINGS], count;

        assert_int_equal(met >> i & 1, truth->object != POV_NO_OWNER);
        if (met >> i & 1) {
            assert_int_equal(hits[i].object, truth->object);
            assert_true(hits[i].crossing.t == truth->crossing.t && hits[i].crossing.t_lo == truth->crossing.t_lo);
        }
        assert_int_equal(clear >> i & 1, test_light(alone->world, alone->context, some[i], most, owners, &count));
        dark += !(clear >> i & 1);
    }
    return dark;
}

#endif
