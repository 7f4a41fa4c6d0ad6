/* Rays that go together get the answers of single rays bit for bit, whatever they are and wherever they go. */
#include "support/check.h"
#include "support/rays.h"
#include "support/shapes.h"

#include "world/internal.h"

#include <string.h>

static const pov_vec3 origin = { 0.0, 0.0, 0.0 };

typedef struct subject { model model; world *world; query_context *context; test_random random; } subject;

static void begin(subject *s, uint64_t seed)
{
    memset(s, 0, sizeof *s);
    s->random.state = seed;
    test_model_init(&s->model, NULL);
    test_add_light(&s->model, 1.0f);
}

static void build(subject *s, pov_accel accel)
{
    world_options options = { .accel = accel, .threads = 1 };
    pov_error err;

    assert_int_equal(world_create(&s->world, &s->model, &options, &err), POV_OK);
    assert_int_equal(query_context_create(&s->context, s->world, &err), POV_OK);
    assert_int_equal(s->world->has_tree, accel != POV_ACCEL_NONE);
}

static void end(subject *s)
{
    query_context_destroy(s->context);
    world_destroy(s->world);
    model_free(&s->model);
}

static pov_vec3 somewhere(subject *s, double size)
{
    return pov_vec3_of(test_uniform(&s->random, -size, size), test_uniform(&s->random, -size, size),
                       test_uniform(&s->random, -size, size));
}

/* Spheres in blocks, bricks, placed spheres; opaque and coloured ones, some without a shadow. */
static void add_objects(subject *s, int n, double scale, pov_vec3 offset, bool coloured)
{
    uint32_t glass = test_add_material(&s->model, colour_of(0.9f, 0.5f, 0.2f), 0.8f, 0.1f, true);
    int i;

    for (i = 0; i < n; i++) {
        pov_vec3 c = pov_add(offset, somewhere(s, scale));
        double size = 0.1 * scale * test_uniform(&s->random, 0.2, 1.0);
        test_sphere_shape sphere = { c, size };
        test_brick brick = { c, pov_add(c, pov_vec3_of(size, 0.2 * size, 2.0 * size)) };
        uint32_t surface = coloured && i % 3 == 0 ? glass : 0, flags = i % 11 == 0 ? LEAF_NO_SHADOW : i % 7 == 0 ? LEAF_INVERSE : 0;
        const transform *map = NULL;
        if (i % 5 == 0)
            test_add(&s->model, &test_brick_class, &brick, NULL, surface, flags);
        else if (i % 5 == 1) {
            sphere.centre = origin;
            sphere.radius = 1.0;
            map = test_transform(&s->model, map, TRANSFORM_SCALE, size, 0.5 * size, 2.0 * size);
            map = test_transform(&s->model, map, TRANSFORM_TRANSLATE, c.x, c.y, c.z);
            test_add(&s->model, &test_sphere_class, &sphere, map, surface, flags);
        } else {
            test_add(&s->model, &test_sphere_class, &sphere, NULL, surface, flags);
        }
    }
}

/* What many say, with the bits of those that meet anything, is what single ones say. */
static int same_hits(subject *s, const pov_ray *const *rays, uint32_t n, uint64_t candidates, const hit *many,
                     hit *single)
{
    int hits = 0;
    uint32_t i;

    assert_true(n == WORLD_MANY || candidates >> n == 0);
    for (i = 0; i < n; i++) {
        bool found = test_nearest(s->world, s->context, rays[i], HUGE_VAL, &single[i]);
        assert_int_equal(candidates >> i & 1, found);
        if (!found)
            continue;
        hits++;
        assert_int_equal(many[i].object, single[i].object);
        assert_memory_equal(&many[i].crossing.t, &single[i].crossing.t, sizeof many[i].crossing.t);
        assert_memory_equal(&many[i].crossing.t_lo, &single[i].crossing.t_lo, sizeof many[i].crossing.t_lo);
        assert_int_equal(many[i].crossing.mark.feature, single[i].crossing.mark.feature);
    }
    return hits;
}

static void same_light(subject *s, const pov_ray *const *rays, uint32_t n, double tmax)
{
    uint32_t many[WORLD_MANY][TEST_CROSSINGS], counts[WORLD_MANY], single[TEST_CROSSINGS], count, i, k;
    occlusion found;
    const uint64_t open = query_occlusion(s->world, s->context, rays, n, tmax, &found);

    assert_true(n == WORLD_MANY || open >> n == 0);
    assert_true((found.crossed & ~open) == 0);
    for (i = 0; i < n; i++) {
        counts[i] = found.crossed >> i & 1 ? found.count[i] : 0;
        for (k = 0; k < counts[i] && k < TEST_CROSSINGS; k++)
            many[i][k] = found.at[i][k].owner;
    }
    for (i = 0; i < n; i++) {
        assert_int_equal(open >> i & 1, test_light(s->world, s->context, rays[i], tmax, single, &count));
        assert_int_equal(counts[i], count);
        assert_memory_equal(many[i], single, (count < TEST_CROSSINGS ? count : TEST_CROSSINGS) * sizeof *single);
    }
}

/* ---- rays by lane ---- */

static const pov_ray *const *make_known(void *user) { return user; }

/* Asks rays by lane and as records. */
static void same_lanes(subject *s, const lane_rays *lanes, const pov_ray *const *rays, uint32_t n, double tmax)
{
    uint32_t owners[WORLD_MANY][TEST_CROSSINGS], counts[WORLD_MANY];
    occlusion records, by_lane;
    const uint64_t open = query_occlusion(s->world, s->context, rays, n, tmax, &records);

    for (uint32_t i = 0; i < n; i++) {
        counts[i] = records.crossed >> i & 1 ? records.count[i] : 0;
        for (uint32_t k = 0; k < counts[i] && k < TEST_CROSSINGS; k++)
            owners[i][k] = records.at[i][k].owner;
    }
    assert_true(open == query_occlusion_lanes(s->world, s->context, lanes, n, tmax, &by_lane));
    assert_true(records.near_end == by_lane.near_end);
    assert_true(records.crossed == by_lane.crossed);
    for (uint32_t i = 0; i < n; i++) {
        if (!(by_lane.crossed >> i & 1))
            continue;
        assert_int_equal(counts[i], by_lane.count[i]);
        for (uint32_t k = 0; k < counts[i] && k < TEST_CROSSINGS; k++)
            assert_int_equal(owners[i][k], by_lane.at[i][k].owner);
    }
}

/* Light by lane is that of records: of all lanes, and of two of three. */
static void same_by_lane(subject *s, const pov_ray **rays, uint32_t n, double tmax)
{
    uint32_t starts[WORLD_MANY], excluded[WORLD_MANY], count = 0;
    const pov_ray *some[WORLD_MANY];
    uint8_t of[WORLD_MANY];
    vec_lanes org, org_lo, dir;
    lane_rays lanes = { { &org, &org_lo, &dir, excluded, 0, NULL }, starts, make_known, rays, false };

    for (uint32_t i = 0; i < n; i++) {
        const uint32_t flags = rays[i]->origin_mark.flags;

        lanes_put(&org, i, rays[i]->org);
        lanes_put(&org_lo, i, rays[i]->org_lo);
        lanes_put(&dir, i, rays[i]->dir);
        starts[i] = rays[i]->origin_surface;
        excluded[i] = flags & POV_MARK_OUTWARD ? starts[i] : POV_NO_OWNER;
        lanes.enters |= s->world->plan.coloured_shadows && !(flags & POV_MARK_OUTWARD) && (flags & POV_MARK_CLOSED);
        if (i % 3 == 1)
            continue;
        some[count] = rays[i];
        of[count++] = (uint8_t)i;
        lanes.lanes.which |= (uint64_t)1 << i;
    }
    same_lanes(s, &lanes, rays, n, tmax);
    lanes.lanes.of = of;
    lanes.user = some;
    same_lanes(s, &lanes, some, count, tmax);
}

/* What a ray knows of the side that it goes to saves questions and changes no answer. */
static void same_unnamed(subject *s, const pov_ray *const *rays, uint32_t n)
{
    uint32_t i;

    for (i = 0; i < n; i++) {
        pov_ray plain = *rays[i];
        uint32_t with[TEST_CROSSINGS], without[TEST_CROSSINGS], with_count, without_count;
        hit a, b;

        plain.origin_mark.flags = 0;
        assert_int_equal(test_light(s->world, s->context, rays[i], 1.0, with, &with_count),
                         test_light(s->world, s->context, &plain, 1.0, without, &without_count));
        assert_int_equal(with_count, without_count);
        assert_memory_equal(with, without, sizeof with);
        assert_int_equal(test_nearest(s->world, s->context, rays[i], HUGE_VAL, &a),
                         test_nearest(s->world, s->context, &plain, HUGE_VAL, &b));
        assert_int_equal(a.object, b.object);
        assert_true(a.object == POV_NO_OWNER || (a.crossing.t == b.crossing.t && a.crossing.t_lo == b.crossing.t_lo));
    }
}

static void same_lane(const vec_lanes *l, uint32_t i, pov_vec3 v)
{
    const pov_vec3 there = lanes_at(l, i);

    assert_memory_equal(&there, &v, sizeof v);
}

/* As nearest hits that the query context has found just now, and as hits of which it knows nothing. */
static void same_surfaces(subject *s, const query_context *k, const pov_ray *const *rays, uint64_t candidates,
                          hit *hits)
{
    const pov_ray *from[WORLD_MANY];
    hit *at[WORLD_MANY];
    incidence to;
    uint32_t n = 0, i;

    for (i = 0; i < WORLD_MANY; i++)
        if (candidates >> i & 1) {
            at[n] = &hits[i];
            from[n++] = rays[i];
        }
    world_surface_many(s->world, k ? query_context_own(k) : NULL, from, at, n, &to);
    for (i = 0; i < n; i++) {
        hit single = *at[i];
        world_surface(s->world, from[i], &single);
        assert_memory_equal(&at[i]->point, &single.point, sizeof single.point);
        assert_memory_equal(&at[i]->point_lo, &single.point_lo, sizeof single.point_lo);
        assert_memory_equal(&at[i]->normal, &single.normal, sizeof single.normal);
        assert_int_equal(at[i]->entering, single.entering);
        same_lane(&to.dir, i, from[i]->dir);
        same_lane(&to.point, i, single.point);
        same_lane(&to.point_lo, i, single.point_lo);
        same_lane(&to.normal, i, pov_scale(single.normal, single.entering ? 1.0 : -1.0));
    }
}

static int same_nearest(subject *s, const pov_ray *const *rays, uint32_t n, hit *single)
{
    hit many[WORLD_MANY];
    const uint64_t candidates = query_nearest(s->world, s->context, rays, n, HUGE_VAL, many);

    same_surfaces(s, s->context, rays, candidates, many);
    same_surfaces(s, NULL, rays, candidates, many);
    return same_hits(s, rays, n, candidates, many, single);
}

/* The rays, and from what they meet those to a light, by each of this processor's kernels. Gives the number of hits. */
static int same_packet(subject *s, const pov_ray *rays, uint32_t n, pov_vec3 lamp)
{
    const bvh_kernels *kernels[2] = { bvh_kernels_best(), &bvh_kernels_portable };
    const pov_ray *all[WORLD_MANY], *lights[WORLD_MANY];
    pov_ray shadows[WORLD_MANY];
    hit hits[WORLD_MANY];
    uint32_t i, lit = 0;
    int candidates = 0, k;

    for (i = 0; i < n; i++)
        all[i] = &rays[i];
    for (k = 0; k < 2; k++) {
        s->world->kernels = kernels[k];
        candidates = same_nearest(s, all, n, hits);
        same_light(s, all, n, HUGE_VAL);
        for (i = lit = 0; i < n; i++) {
            if (hits[i].object == POV_NO_OWNER)
                continue;
            world_surface(s->world, all[i], &hits[i]);
            shadows[lit] = ray_from(hits[i].point, pov_sub(lamp, hits[i].point));
            shadows[lit].org_lo = hits[i].point_lo;
            test_leave(&shadows[lit], &hits[i]);
            lights[lit] = &shadows[lit];
            lit++;
        }
        if (lit > 0) {
            same_nearest(s, lights, lit, hits);
            same_light(s, lights, lit, 1.0);
            same_by_lane(s, lights, lit, 1.0);
            same_unnamed(s, lights, lit);
        }
    }
    return candidates;
}

/* A beam from one point through a square of points. */
static int beam(subject *s, uint32_t n, pov_vec3 from, pov_vec3 to, double spread, double length)
{
    pov_ray rays[WORLD_MANY];
    uint32_t i;

    for (i = 0; i < n; i++) {
        pov_vec3 d = pov_add(pov_sub(to, from), pov_vec3_of(spread * (i % 8), spread * (i / 8), spread * (i % 3)));
        rays[i] = ray_from(from, pov_scale(d, length));
    }
    return same_packet(s, rays, n, pov_add(to, pov_vec3_of(spread, 100.0 * spread, -30.0 * spread)));
}

static void beams_are_the_same(int objects_info, double scale, pov_vec3 offset, bool coloured, double length)
{
    static const double dir[4] = { 0.5, 3.0, 40.0, 1e7 };
    subject s;
    int i, hits = 0;

    begin(&s, 20250607u + (uint64_t)objects_info);
    add_objects(&s, objects_info, scale, offset, coloured);
    build(&s, POV_ACCEL_TREE);
    for (i = 0; i < 120; i++) {
        pov_vec3 from = pov_add(offset, pov_scale(test_direction(&s.random), scale * dir[i % 4]));
        pov_vec3 to = pov_add(offset, somewhere(&s, 0.5 * scale));
        hits += beam(&s, 1 + (uint32_t)i * 37 % WORLD_MANY, from, to, scale * (i % 3 == 0 ? 0.2 : 0.01), length);
    }
    assert_true(hits > 100);
    end(&s);
}

static void beams_through_scenes_of_all_sizes(void **state)
{
    (void)state;
    beams_are_the_same(40, 1.0, origin, false, 1.0);
    beams_are_the_same(600, 1.0, origin, true, 1.0);
    beams_are_the_same(5000, 1.0, origin, false, 1.0);
}

static void beams_in_tiny_huge_and_far_scenes(void **state)
{
    (void)state;
    beams_are_the_same(300, 1e-12, origin, true, 1.0);
    beams_are_the_same(300, 1e12, origin, true, 1e-20);
    beams_are_the_same(300, 1.0, pov_vec3_of(1e9, -1e9, 1e9), true, 1e20);
    beams_are_the_same(300, 1e-100, origin, false, 1e100);
}

/* Parts of a scene that are tiny against it stand in frames of their own. */
static void beams_through_frames_in_frames(void **state)
{
    subject s;
    int i, hits = 0;
    (void)state;

    begin(&s, 77);
    add_objects(&s, 100, 1.0, origin, true);
    add_objects(&s, 100, 1e-5, pov_vec3_of(0.1, 0.2, 0.3), true);
    add_objects(&s, 100, 1e-10, pov_vec3_of(0.1, 0.2, 0.3), false);
    build(&s, POV_ACCEL_TREE);
    assert_true(s.world->tree.frame_count > 2);
    for (i = 0; i < 200; i++) {
        double size = i % 3 == 0 ? 1.0 : i % 3 == 1 ? 1e-5 : 1e-10;
        pov_vec3 to = pov_add(pov_vec3_of(0.1, 0.2, 0.3), somewhere(&s, size));
        pov_vec3 from = pov_add(to, pov_scale(test_direction(&s.random), size * (i % 2 ? 3.0 : 1e4)));
        hits += beam(&s, WORLD_MANY, from, to, 0.02 * size, 1.0);
    }
    assert_true(hits > 1000);
    end(&s);
}

static void rays_of_all_directions_at_once(void **state)
{
    pov_ray rays[WORLD_MANY];
    subject s;
    uint32_t i, k, hits = 0;
    (void)state;

    begin(&s, 5);
    add_objects(&s, 900, 1.0, origin, true);
    build(&s, POV_ACCEL_TREE);
    for (k = 0; k < 60; k++) {
        for (i = 0; i < WORLD_MANY; i++)
            rays[i] = ray_from(somewhere(&s, 1.5), test_direction(&s.random));
        hits += (uint32_t)same_packet(&s, rays, WORLD_MANY, pov_vec3_of(2.0, 3.0, -4.0));
    }
    assert_true(hits > 1000);
    end(&s);
}

/* Zeros of both signs, and components that count as zero. */
static void rays_along_axes(void **state)
{
    static const double small[4] = { 0.0, -0.0, 1e-300, -1e-25 };
    pov_ray rays[WORLD_MANY];
    subject s;
    uint32_t i, k, hits = 0;
    (void)state;

    begin(&s, 6);
    add_objects(&s, 400, 1.0, origin, false);
    build(&s, POV_ACCEL_TREE);
    for (k = 0; k < 60; k++) {
        for (i = 0; i < WORLD_MANY; i++) {
            double d[3] = { small[i % 4], small[i / 4 % 4], small[(i + k) % 4] };
            d[k % 3] = k % 2 ? -1.0 : 1.0;
            rays[i] = ray_from(pov_vec3_of(0.03 * (i % 8), 0.04 * (i / 8), 0.01 * i), pov_vec3_of(d[0], d[1], d[2]));
        }
        hits += (uint32_t)same_packet(&s, rays, 4 * (1 + k % 16), pov_vec3_of(0.0, 3.0, 0.0));
    }
    assert_true(hits > 100);
    end(&s);
}

/* Lengths and places so absurd that a ray asks every box goes among ordinary ones. */
static void absurd_rays_among_ordinary_ones(void **state)
{
    static const double length[4] = { 1.0, 1e-310, 1e300, 1e-200 };
    pov_ray rays[WORLD_MANY];
    subject s;
    uint32_t i, k, hits = 0;
    (void)state;

    begin(&s, 7);
    add_objects(&s, 300, 1.0, origin, true);
    build(&s, POV_ACCEL_TREE);
    for (k = 0; k < 40; k++) {
        for (i = 0; i < WORLD_MANY; i++) {
            pov_vec3 from = i % 5 == 4 ? pov_vec3_of(-1e200, -1e200, -1e200) : somewhere(&s, 1.0);
            pov_vec3 d = pov_vec3_of(test_uniform(&s.random, 0.1, 1.0), test_uniform(&s.random, 0.1, 1.0), 0.5);
            rays[i] = ray_from(from, pov_scale(d, i % 3 == 0 ? length[i / 3 % 4] : 1.0));
        }
        hits += (uint32_t)same_packet(&s, rays, WORLD_MANY, pov_vec3_of(0.0, 3.0, 0.0));
    }
    assert_true(hits > 100);
    end(&s);
}

/* So many that what filters see of them is not kept. */
static void more_instances_than_have_filters(void **state)
{
    const test_brick brick = { { -1.0, -1.0, -1.0 }, { 1.0, 1.0, 1.0 } };
    subject s;
    int i, hits = 0;
    (void)state;

    begin(&s, 10);
    add_objects(&s, 200, 1.0, origin, true);
    for (i = 0; i <= 1 << 17; i++) {
        const pov_vec3 at = somewhere(&s, 1.0);
        const transform *map = test_transform(&s.model, NULL, TRANSFORM_SCALE, 0.004, 0.005, 0.006);

        map = test_transform(&s.model, map, TRANSFORM_ROTATE, 20.0, i % 90, 0.0);
        map = test_transform(&s.model, map, TRANSFORM_TRANSLATE, at.x, at.y, at.z);
        test_add(&s.model, &test_brick_class, &brick, map, 0, 0);
    }
    build(&s, POV_ACCEL_TREE);
    for (i = 0; i < 20; i++)
        hits += beam(&s, WORLD_MANY, pov_scale(test_direction(&s.random), 3.0), somewhere(&s, 0.5), 0.05, 1.0);
    assert_true(hits > 1000);
    end(&s);
}

static void a_packet_that_hits_nothing(void **state)
{
    subject s;
    (void)state;

    begin(&s, 8);
    add_objects(&s, 300, 1.0, origin, true);
    build(&s, POV_ACCEL_TREE);
    assert_int_equal(beam(&s, WORLD_MANY, pov_vec3_of(0.0, 9.0, 0.0), pov_vec3_of(0.0, 20.0, 0.0), 0.01, 1.0), 0);
    assert_int_equal(beam(&s, 1, pov_vec3_of(0.0, 1e9, 0.0), pov_vec3_of(0.0, 2e9, 0.0), 0.01, 1.0), 0);
    end(&s);
}

static void lists_and_infinite_shapes(void **state)
{
    static const pov_accel accel[2] = { POV_ACCEL_NONE, POV_ACCEL_TREE };
    test_ground ground = { -0.5 };
    int i, k, hits = 0;
    (void)state;

    for (k = 0; k < 2; k++) {
        subject s;
        begin(&s, 9);
        add_objects(&s, 100, 1.0, origin, true);
        test_add(&s.model, &test_ground_class, &ground, NULL, 0, 0);
        for (i = 0; i < 11; i++) {
            const test_sphere_shape sphere = { somewhere(&s, 1.0), 0.2 };
            test_add(&s.model, &test_loose_sphere_class, &sphere, NULL, 0, 0);
        }
        build(&s, accel[k]);
        for (i = 0; i < 30; i++)
            hits += beam(&s, WORLD_MANY, pov_scale(test_direction(&s.random), 3.0), somewhere(&s, 0.5), 0.05, 1.0);
        end(&s);
    }
    assert_true(hits > 1000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(beams_through_scenes_of_all_sizes),
        cmocka_unit_test(beams_in_tiny_huge_and_far_scenes),
        cmocka_unit_test(beams_through_frames_in_frames),
        cmocka_unit_test(rays_of_all_directions_at_once),
        cmocka_unit_test(rays_along_axes),
        cmocka_unit_test(absurd_rays_among_ordinary_ones),
        cmocka_unit_test(more_instances_than_have_filters),
        cmocka_unit_test(a_packet_that_hits_nothing),
        cmocka_unit_test(lists_and_infinite_shapes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
