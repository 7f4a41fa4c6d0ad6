/* The constants that guard what queries leave out: rays made for the worst that each has to allow for, so that a constant
 * weakened by 2^8 is noticed. Random rays do not come near it. */
#include "support/check.h"
#include "support/rays.h"
#include "support/shapes.h"

#include <povtrace/exact.h>

enum { ROUNDS = 400 };

/* ---- one world ---- */

typedef struct scene { model model; world *world; query_context *context; } scene;

static void begin(scene *s)
{
    test_model_init(&s->model, NULL);
    test_add_light(&s->model, 1.0f);
}

static void build(scene *s, pov_accel accel)
{
    const world_options options = { .accel = accel, .threads = 1 };
    pov_error err;

    assert_int_equal(world_create(&s->world, &s->model, &options, &err), POV_OK);
    assert_int_equal(query_context_create(&s->context, s->world, &err), POV_OK);
}

static void end(scene *s)
{
    query_context_destroy(s->context);
    world_destroy(s->world);
    model_free(&s->model);
}

static bool nearest(const scene *s, const pov_ray *ray, hit *out)
{
    return query_nearest(s->world, s->context, &ray, 1, HUGE_VAL, out) != 0;
}

/* ---- the slack of the slab test ----
 *
 * A ray cuts an edge off a brick that is small in its frame, 2^-36 deep, and starts far away in it. It enters by one slab
 * and leaves by another at almost the same distance, which floats get wrong by as much as they round the ray's start. The
 * boxes' own rounding is of no help: it is as small as the brick. */

static const double small = 0x1p-8, depth = 0x1p-36;

static void add_brick(scene *s, double x, double y, double z, double half)
{
    const test_brick b = { { x - half, y - half, z - half }, { x + half, y + half, z + half } };

    test_add(&s->model, &test_brick_class, &b, NULL, 0, 0);
}

static double side(test_random *r) { return test_below(r, 2) ? 1.0 : -1.0; }

static pov_ray ray_past_an_edge(test_random *r)
{
    const uint32_t first = test_below(r, 3), second = (first + 1 + test_below(r, 2)) % 3, third = 3 - first - second;
    const double in = side(r), out = side(r), far = test_uniform(r, 3.0, 7.0);
    double at[3], dir[3];

    at[first] = in * (small - depth);
    at[second] = out * (small - depth);
    at[third] = test_uniform(r, -0.5, 0.5) * small;
    dir[first] = -in * test_uniform(r, 0.2, 1.0);
    dir[second] = out * test_uniform(r, 0.2, 1.0);
    dir[third] = test_uniform(r, -1.0, 1.0);
    return ray_from(pov_vec3_of(at[0] - far * dir[0], at[1] - far * dir[1], at[2] - far * dir[2]),
                  pov_vec3_of(dir[0], dir[1], dir[2]));
}

static void an_edge_that_a_ray_just_cuts_is_hit(void **state)
{
    test_random r = { 11 };
    scene s;
    int single = 0, together = 0;

    (void)state;
    begin(&s);
    add_brick(&s, 0.0, 0.0, 0.0, small);
    for (int i = 0; i < 8; i++)
        add_brick(&s, i & 1 ? 8.0 : -8.0, i & 2 ? 8.0 : -8.0, i & 4 ? 8.0 : -8.0, 0x1p-6);
    build(&s, POV_ACCEL_TREE);
    for (int round = 0; round < ROUNDS; round++) {
        pov_ray rays[WORLD_MANY];
        const pov_ray *many[WORLD_MANY];
        hit hits[WORLD_MANY];
        uint64_t candidates;

        for (int i = 0; i < WORLD_MANY; i++) {
            rays[i] = ray_past_an_edge(&r);
            many[i] = &rays[i];
        }
        candidates = query_nearest(s.world, s.context, many, WORLD_MANY, HUGE_VAL, hits);
        for (int i = 0; i < WORLD_MANY; i++) {
            together += !(candidates >> i & 1) || hits[i].object != 0;
            single += !nearest(&s, &rays[i], &hits[i]) || hits[i].object != 0;
        }
    }
    assert_int_equal(single, 0);
    assert_int_equal(together, 0);
    end(&s);
}

/* ---- the side of a ray that leaves ----
 *
 * A class whose normals are off by all that docs/numerics.md allows, 1e-13 radians. By such a normal the ray goes outward;
 * in truth it goes inward, by less, and comes out again. */

static const double normal_error = 1e-13;

static void tilted_normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    test_sphere_class.normal(self, ray, at, out);
    out->x += normal_error;
}

static void a_ray_that_goes_in_by_less_than_normals_are_off_comes_out(void **state)
{
    const test_sphere_shape sphere = { { 0.0, 0.0, 0.0 }, 1.0 };
    const pov_ray down = ray_from(pov_vec3_of(0.0, 5.0, 0.0), pov_vec3_of(0.0, -1.0, 0.0));
    shape_class tilted = test_plain_sphere_class;
    scene s;

    (void)state;
    tilted.normal = tilted_normal;
    begin(&s);
    test_add(&s.model, &tilted, &sphere, NULL, 0, 0);
    build(&s, POV_ACCEL_TREE);
    for (int i = 1; i < 10; i++) {
        const double inward = 0.1 * i * normal_error;
        pov_ray ray;
        hit h;

        assert_true(nearest(&s, &down, &h));
        world_surface(s.world, &down, &h);
        ray = ray_from(h.point, pov_vec3_of(1.0, -inward, 0.0));
        ray.org_lo = h.point_lo;
        test_leave(&ray, &h);
        assert_true(nearest(&s, &ray, &h));
        assert_true(fabs(h.crossing.t - 2.0 * inward) < 0.1 * inward);
    }
    end(&s);
}

/* ---- the end of a light's path ----
 *
 * From the surface of a brick of glass through it to a light that stands within it still, nearer to its surface than the
 * sum of start and way is rounded: nothing is crossed. The face is just below a number that such sums are rounded to. */

static const double face = 0x1p-20 - 0x1p-60;

/* From where a ray hits the brick through that face. */
static pov_ray ray_within(const scene *s, test_random *r)
{
    const pov_vec3 out = pov_scale(test_direction(r), 9.0);
    const pov_ray from = ray_from(out, pov_sub(pov_vec3_of(-0.5, 0.0, 0.0), out));
    pov_vec3 to = { face, test_uniform(r, -0.9, 0.9), test_uniform(r, -0.9, 0.9) };
    pov_ray ray;
    hit h;

    assert_true(nearest(s, &from, &h));
    world_surface(s->world, &from, &h);
    ray = ray_from(h.point, pov_scale(pov_sub(to, h.point), test_uniform(r, 0.3, 3.0)));
    ray.org_lo = h.point_lo;
    test_leave(&ray, &h);
    return ray;
}

static void a_light_just_within_glass_is_not_behind_it(void **state)
{
    const test_brick brick = { { -1.0, -1.0, -1.0 }, { face, 1.0, 1.0 } };
    const colour filter = { 1.0f, 0.5f, 0.25f };
    test_random r = { 5 };
    int wrong = 0;
    scene s;

    (void)state;
    begin(&s);
    test_add(&s.model, &test_brick_class, &brick, NULL, test_add_material(&s.model, filter, 0.9f, 0.0f, true), 0);
    build(&s, POV_ACCEL_TREE);
    for (int round = 0; round < 10 * ROUNDS; round++) {
        const pov_ray ray = ray_within(&s, &r), *one = &ray;
        occlusion o;
        double before;
        hit h;

        if (!(ray.origin_mark.flags & POV_MARK_INWARD))
            continue;
        assert_true(nearest(&s, &ray, &h));
        before = h.crossing.t_lo > 0.0 ? h.crossing.t : nextafter(h.crossing.t, 0.0);
        assert_int_equal(query_occlusion(s.world, s.context, &one, 1, before, &o), 1);
        wrong += (int)(o.crossed & 1);
    }
    assert_int_equal(wrong, 0);
    end(&s);
}

/* ---- the limit of the nearest ----
 *
 * Two walls as near to each other as their distances may be off. Such a tie is resolved in double-double, whatever filters
 * know; a wall that its filter or the limit leaves out would make no tie, and the nearest distance would be the other's
 * as it was reported first. */

/* late: by what part its quick distances are off. */
typedef struct wall { double z, late; } wall;

static double distance_to(const wall *of, double org, double dir) { return (of->z - org) / dir; }

static bool wall_bounds(const void *self, pov_box *out)
{
    const wall *of = self;

    out->lo = pov_vec3_of(-1.0, -1.0, of->z);
    out->hi = pov_vec3_of(1.0, 1.0, of->z);
    return true;
}

static void wall_intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const wall *of = self;
    const pov_mark mark = { 0, POV_MARK_OUTWARD, 0.0, 0.0 };
    const double t = distance_to(of, ray->org.z, ray->dir.z);

    if (ray->origin_surface != hits->owner)
        pov_cross(hits, hits->always_exact ? t : t + of->late * t, 0.0, mark);
}

static void wall_normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    (void)self;
    (void)ray;
    (void)at;
    *out = pov_vec3_of(0.0, 0.0, 1.0);
}

typedef struct wall_block { uint32_t count; wall at[POV_BLOCK_MAX]; } wall_block;

static bool wall_pack(void *block, const pov_frame *frame, const void *const *selves, uint32_t n)
{
    wall_block *b = block;

    (void)frame;
    b->count = n;
    for (uint32_t i = 0; i < n; i++)
        b->at[i] = *(const wall *)selves[i];
    return true;
}

/* Bounds as narrow as they can be. */
static uint32_t wall_filter(const void *block, const uint32_t *owners, const pov_rays *rays, uint64_t lanes,
                            pov_candidate *out)
{
    const wall_block *b = block;
    uint32_t n = 0;

    (void)owners;
    for (uint32_t ray = 0; ray < POV_RAYS_MAX; ray++)
        for (uint32_t i = 0; (lanes >> ray & 1) && i < b->count; i++) {
            const double t = distance_to(&b->at[i], rays->org[2][ray], rays->dir[2][ray]);
            const pov_candidate m = { t, t, (uint8_t)ray, (uint8_t)i, true, false, 0 };

            if (t > 0.0 && t < rays->tmax[ray])
                out[n++] = m;
        }
    return n;
}

static const shape_class wall_class = {
    .keyword = "wall",
    .instance_size = sizeof(wall),
    .bounds = wall_bounds,
    .intersect = wall_intersect,
    .normal = wall_normal,
    .block_size = sizeof(wall_block),
    .block_pack = wall_pack,
    .block_filter = wall_filter,
};

/* Quick distances are off by 60 units of 2^-53 towards each other, of the 64 allowed; 228 apart in truth, they are 108
 * apart as reported: nearer than POV_COINCIDENT, which is 128. */
static void assert_tie(const shape_class *shape, bool nearer_first, pov_accel accel)
{
    const wall near = { 1.0, 60.0 * 0x1p-53 }, far = { 1.0 + 228.0 * 0x1p-53, -60.0 * 0x1p-53 };
    const pov_ray ray = ray_from(pov_vec3_of(0.1, 0.2, 0.0), pov_vec3_of(0.0, 0.0, 1.0)), *many[2] = { &ray, &ray };
    hit h, hits[2];
    scene s;

    begin(&s);
    test_add(&s.model, shape, nearer_first ? &near : &far, NULL, 0, 0);
    test_add(&s.model, shape, nearer_first ? &far : &near, NULL, 0, 0);
    build(&s, accel);
    assert_true(nearest(&s, &ray, &h));
    assert_int_equal(h.object, nearer_first ? 0 : 1);
    assert_true(h.crossing.t == near.z);
    assert_int_equal(query_nearest(s.world, s.context, many, 2, HUGE_VAL, hits), 3);
    assert_true(hits[0].crossing.t == near.z && hits[1].crossing.t == near.z);
    end(&s);
}

static void distances_that_may_be_equal_are_compared_exactly(void **state)
{
    shape_class sharing = wall_class;

    (void)state;
    sharing.full_leaves = true;
    for (int order = 0; order < 2; order++) {
        assert_tie(&wall_class, order, POV_ACCEL_NONE);
        assert_tie(&wall_class, order, POV_ACCEL_TREE);
        assert_tie(&sharing, order, POV_ACCEL_TREE);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_edge_that_a_ray_just_cuts_is_hit),
        cmocka_unit_test(a_ray_that_goes_in_by_less_than_normals_are_off_comes_out),
        cmocka_unit_test(a_light_just_within_glass_is_not_behind_it),
        cmocka_unit_test(distances_that_may_be_equal_are_compared_exactly),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
