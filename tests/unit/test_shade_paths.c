/* The rays that go on from a surface: mirrored, straight on, bent; and where they end. */
#include "support/near.h"
#include "support/tiny.h"

#include "shade/refract.h"

#include <string.h>

static const pov_vec3 origin = { 0.0, 0.0, 0.0 };

/* ---- rays that go on ---- */

static void a_mirror_shows_what_is_before_it(void **state)
{
    material mirror = tiny_matt();
    tiny s;
    (void)state;
    tiny_begin(&s, NULL);

    mirror.finish.diffuse = 0.0f;
    mirror.finish.reflection.min = mirror.finish.reflection.max = colour_of(0.5f, 0.25f, 1.0f);
    s.model.background = colour_of(0.0f, 0.0f, 0.125f);
    tiny_plane(&s, 0, 0, 1, 5, mirror);
    tiny_sphere(&s, 10, 0, 0, 1, tiny_emitted(1.0f, 1.0f, 0.5f));
    tiny_build(&s);
    assert_colour(tiny_trace(&s, origin, 1, 0, 1), 0.5, 0.25, 0.5, 1e-6);
    assert_colour(tiny_trace(&s, origin, -1, 0, 1), 0.0, 0.0, 0.125, 1e-6);
    assert_int_equal(s.tracer->context.counts.reflected, 2);
    tiny_end(&s);
}

static void a_filter_multiplies_by_its_colour_and_what_it_transmits(void **state)
{
    material glass = tiny_glass(1.0);
    tiny s;
    (void)state;
    tiny_begin(&s, NULL);

    glass.pigment = colour_of(1.0f, 0.5f, 0.0f);
    glass.filter = 0.5f;
    glass.transmit = 0.25f;
    s.model.background = colour_of(1.0f, 1.0f, 1.0f);
    tiny_plane(&s, 0, 0, 1, 5, glass);
    tiny_build(&s);
    assert_colour(tiny_trace(&s, origin, 1, 0, 1), 0.75, 0.5, 0.25, 1e-6);
    tiny_end(&s);
}

static void straight_on_does_not_count_for_the_depth(void **state)
{
    tiny s;
    (void)state;
    tiny_begin(&s, NULL);

    s.model.max_trace_level = 1;
    s.model.background = colour_of(1.0f, 1.0f, 1.0f);
    for (int i = 0; i < 40; i++)
        tiny_plane(&s, 0, 0, 1, 5 + i, tiny_glass(i % 2 ? 1.0 : 0.0));
    tiny_build(&s);
    assert_colour(tiny_trace(&s, origin, 0.2, 0, 1), 1.0, 1.0, 1.0, 0.0);
    assert_int_equal(s.tracer->context.counts.transmitted, 40);
    tiny_end(&s);
}

static void two_mirrors_give_as_many_pictures_as_there_are_levels(void **state)
{
    static const int levels[] = { 0, 1, 2, 5, 256, 2000 };
    (void)state;

    for (int i = 0; i < 6; i++) {
        int n = levels[i] > 0 ? levels[i] : 1;
        material mirror = tiny_emitted(0.0625f, 0.0625f, 0.0625f);
        tiny s;

        tiny_begin(&s, NULL);
        mirror.finish.reflection.min = mirror.finish.reflection.max = colour_of(1.0f, 1.0f, 1.0f);
        s.model.max_trace_level = levels[i];
        tiny_plane(&s, 0, 0, 1, 5, mirror);
        tiny_plane(&s, 0, 0, 1, -5, mirror);
        tiny_build(&s);
        assert_near(tiny_trace(&s, origin, 0, 0, 1).r, 0.0625 * n, 1e-6);
        assert_int_equal(s.tracer->context.counts.reflected, n - 1);
        assert_int_equal(s.tracer->context.counts.cut_depth, 1);
        tiny_end(&s);
    }
}

static void a_ray_is_cut_off_below_the_bailout_and_not_at_it(void **state)
{
    material mirror = tiny_emitted(1.0f, 1.0f, 1.0f);
    tiny s;
    (void)state;
    tiny_begin(&s, NULL);

    mirror.finish.reflection.min = mirror.finish.reflection.max = colour_of(0.5f, 0.125f, 0.0f);
    s.model.adc_bailout = 0.25;
    s.model.max_trace_level = 50;
    tiny_plane(&s, 0, 0, 1, 5, mirror);
    tiny_plane(&s, 0, 0, 1, -5, mirror);
    tiny_build(&s);
    assert_colour(tiny_trace(&s, origin, 0, 0, 1), 1.75, 1.125 + 0.125 * 0.125, 1.0, 1e-6);
    assert_int_equal(s.tracer->context.counts.cut_weight, 1);
    assert_int_equal(s.tracer->context.counts.cut_depth, 0);
    tiny_end(&s);
}

/* Half goes through and half comes back each time: 2/3 of what is behind the wall in front, 1/3 of the other. */
static void a_ray_may_split_at_every_level(void **state)
{
    material half = tiny_glass(1.0);
    tiny s;
    (void)state;
    tiny_begin(&s, NULL);

    half.transmit = 0.5f;
    half.finish.reflection.min = half.finish.reflection.max = colour_of(0.5f, 0.5f, 0.5f);
    s.model.max_trace_level = 60;
    s.model.adc_bailout = 0.0;
    tiny_plane(&s, 0, 0, 1, 5, half);
    tiny_plane(&s, 0, 0, 1, -5, half);
    tiny_plane(&s, 0, 0, 1, 6, tiny_emitted(1.0f, 0.0f, 0.0f));
    tiny_plane(&s, 0, 0, 1, -6, tiny_emitted(0.0f, 1.0f, 0.0f));
    tiny_build(&s);
    assert_colour(tiny_trace(&s, origin, 0, 0, 1), 2.0 / 3.0, 1.0 / 3.0, 0.0, 1e-6);
    assert_int_equal(s.tracer->queue.waits.count, 0);
    tiny_end(&s);
}

static pov_vec3 turned(double angle)
{
    return pov_vec3_of(cos(angle), sin(angle), 0.0);
}

/* A small glowing sphere on a ray from a point of the unit circle (at `place`) in the direction `heading`. */
static void put_target(tiny *s, double place, double heading)
{
    pov_vec3 p = pov_add(turned(place), pov_scale(turned(heading), 10.0));

    tiny_sphere(s, p.x, p.y, p.z, 1e-6, tiny_emitted(1.0f, 1.0f, 1.0f));
}

/* Along x at height 1/2: in at 30 degrees, bent to r, out again after turning by 2 (30 degrees - r). */
static void a_sphere_of_glass_refracts_a_ray_twice(void **state)
{
    double in = asin(0.5), r = asin(0.5 / 1.5), place = 3.14159265358979 - in - (3.14159265358979 - 2.0 * r);
    tiny s;
    (void)state;
    tiny_begin(&s, NULL);

    tiny_sphere(&s, 0, 0, 0, 1, tiny_glass(1.5));
    put_target(&s, place, -2.0 * (in - r));
    tiny_build(&s);
    assert_colour(tiny_trace(&s, pov_vec3_of(-5, 0.5, 0), 1, 0, 0), 1.0, 1.0, 1.0, 0.0);
    assert_int_equal(s.tracer->context.counts.transmitted, 2);
    tiny_end(&s);
}

static void an_eye_in_glass_sees_refraction_on_the_way_out(void **state)
{
    double in = asin(0.5), out = asin(0.75);
    tiny s;
    (void)state;
    tiny_begin(&s, NULL);

    tiny_sphere(&s, 0, 0, 0, 1, tiny_glass(1.5));
    put_target(&s, in, in - out);
    tiny_build(&s);
    assert_colour(tiny_trace(&s, pov_vec3_of(0, 0.5, 0), 1, 0, 0), 1.0, 1.0, 1.0, 0.0);
    assert_colour(tiny_trace(&s, pov_vec3_of(0.1, 0.5, 0), 1, 0, 0), 1.0, 1.0, 1.0, 0.0);
    tiny_end(&s);
}

/* The bubble is a hole in the glass, whichever the text names first: out of it at 30 degrees into ior 1.5, a
 * wall of which hides the sky but is no dielectric. */
static void an_eye_in_a_bubble_in_glass_is_in_the_bubble(void **state)
{
    double in = asin(0.5), r = asin(0.5 / 1.5);
    (void)state;

    for (int bubble_first = 0; bubble_first < 2; bubble_first++) {
        material bubble = tiny_glass(1.0);
        tiny s;

        tiny_begin(&s, NULL);
        bubble.interior.given = false;
        if (bubble_first)
            tiny_sphere(&s, 0, 0, 0, 1, bubble);
        tiny_sphere(&s, 0, 0, 0, 50, tiny_glass(1.5));
        if (!bubble_first)
            tiny_sphere(&s, 0, 0, 0, 1, bubble);
        tiny_sphere(&s, 0, 0, 0, 100, tiny_matt());
        put_target(&s, in, in - r);
        tiny_build(&s);
        assert_colour(tiny_trace(&s, pov_vec3_of(0, 0.5, 0), 1, 0, 0), 1.0, 1.0, 1.0, 0.0);
        tiny_end(&s);
    }
}

/* sin 53 degrees > 1 / 1.5: the ray runs round inside, until the levels end. */
static void total_inner_reflection_is_unfiltered_and_leaves_out_the_surface_s_own(void **state)
{
    material glass = tiny_glass(1.5);
    tiny s;
    (void)state;
    tiny_begin(&s, NULL);

    glass.transmit = 0.5f;
    glass.finish.reflection.min = glass.finish.reflection.max = colour_of(0.9f, 0.9f, 0.9f);
    glass.finish.ambient = colour_of(0.2f, 0.2f, 0.2f);
    s.model.max_trace_level = 7;
    tiny_sphere(&s, 0, 0, 0, 1, glass);
    tiny_build(&s);
    assert_colour(tiny_trace(&s, pov_vec3_of(0, 0.8, 0), 1, 0, 0), 0.7, 0.7, 0.7, 1e-6);
    assert_int_equal(s.tracer->context.counts.inner_reflections, 6);
    assert_int_equal(s.tracer->context.counts.reflected, 6);
    assert_int_equal(s.tracer->context.counts.transmitted, 0);
    tiny_end(&s);
}

/* ---- against plain recursion ---- */

enum { SPHERES = 9, LEVELS = 6 };
typedef struct inside { uint32_t list[2 * SPHERES]; int count; } inside;

static double ior_at(const tiny *s, const inside *in, int back)
{
    if (in->count < back)
        return 1.0;
    return s->model.materials.items[s->model.leaves.items[in->list[in->count - back]].material].interior.ior;
}

/* Cross a surface by the rule of the language, on a copy of the list. */
static inside crossed(const tiny *s, inside in, uint32_t which, double *before, double *after)
{
    int at = 0;

    while (at < in.count && in.list[at] != which)
        at++;
    *before = *after = ior_at(s, &in, 1);
    if (at == in.count) {
        in.list[in.count++] = which;
        *after = ior_at(s, &in, 1);
        return in;
    }
    if (at == in.count - 1)
        *after = ior_at(s, &in, 2);
    memmove(in.list + at, in.list + at + 1, sizeof in.list[0] * (size_t)(in.count - at - 1));
    in.count--;
    return in;
}

static double recursive(tiny *s, pov_ray ray, inside in, int level)
{
    const material *m;
    double before, after, sum, cosine;
    pov_vec3 d = pov_unit(ray.dir), n, out;
    inside next;
    const pov_ray *rays = &ray;
    pov_ray on;
    hit h;

    if (!query_nearest(s->world, s->tracer->context.context, &rays, 1, HUGE_VAL, &h))
        return s->model.background.r;
    world_surface(s->world, &ray, &h);
    m = &s->model.materials.items[s->model.leaves.items[h.object].material];
    n = h.entering ? h.normal : pov_scale(h.normal, -1.0);
    cosine = -pov_dot(n, d);
    on = ray;
    on.org = h.point;
    on.org_lo = h.point_lo;
    on.origin_surface = h.object;
    on.origin_mark = h.crossing.mark;
    next = crossed(s, in, h.object, &before, &after);
    sum = 0.125 * (1.0 - m->transmit);
    if (before == after || refract(d, n, cosine, before, after, &out)) {
        on.dir = before == after ? ray.dir : out;
        if (before == after || level < LEVELS)
            sum += m->transmit * recursive(s, on, next, level + (before != after));
        on.dir = pov_add(d, pov_scale(n, 2.0 * cosine));
        return level < LEVELS ? sum + m->finish.reflection.max.r * recursive(s, on, in, level + 1) : sum;
    }
    on.dir = pov_add(d, pov_scale(n, 2.0 * cosine));
    return level < LEVELS ? sum + recursive(s, on, in, level + 1) : sum;
}

static double random_unit(uint64_t *seed)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(*seed >> 11) * 0x1p-53;
}

static void add_random_sphere(tiny *s, uint64_t *seed)
{
    static const double iors[] = { 1.0, 1.3, 1.3, 1.6 };
    material m = tiny_glass(iors[(int)(4.0 * random_unit(seed))]);

    m.transmit = 0.75f;
    m.finish.ambient = colour_of(0.125f, 0.125f, 0.125f);
    m.finish.reflection.min.r = m.finish.reflection.max.r = random_unit(seed) < 0.5 ? 0.25f : 0.0f;
    tiny_sphere(s, random_unit(seed), random_unit(seed), random_unit(seed), 0.1 + random_unit(seed), m);
}

static void the_list_of_rays_gives_what_recursion_gives(void **state)
{
    uint64_t seed = 7;
    (void)state;

    for (int scene = 0; scene < 20; scene++) {
        tiny s;

        tiny_begin(&s, NULL);
        s.model.max_trace_level = LEVELS;
        s.model.adc_bailout = 0.0;
        s.model.background = colour_of(1.0f, 0.0f, 0.0f);
        for (int i = 0; i < SPHERES; i++)
            add_random_sphere(&s, &seed);
        tiny_build(&s);
        for (int i = 0; i < 40; i++) {
            inside none = { { 0 }, 0 };
            pov_ray ray = { .org = { 5.0, 5.0, 5.0 }, .origin_surface = POV_NO_OWNER };

            ray.dir = pov_sub(pov_vec3_of(random_unit(&seed), random_unit(&seed), random_unit(&seed)), ray.org);
            assert_near(tiny_trace(&s, ray.org, ray.dir.x, ray.dir.y, ray.dir.z).r, recursive(&s, ray, none, 1), 1e-5);
        }
        tiny_end(&s);
    }
}

/* ---- scales ---- */

static colour see_scaled(double scale, double x, double y)
{
    material mirror = tiny_matt(), glass = tiny_glass(1.5);
    colour c;
    tiny s;

    tiny_begin(&s, NULL);
    mirror.finish.reflection.min = mirror.finish.reflection.max = colour_of(0.5f, 0.5f, 0.5f);
    glass.finish.reflection.min = glass.finish.reflection.max = colour_of(0.125f, 0.125f, 0.125f);
    mirror.finish.phong = 0.5f;
    tiny_plane(&s, 0, 1, 0, -scale, tiny_matt());
    tiny_sphere(&s, -scale, 0, 4 * scale, scale, mirror);
    tiny_sphere(&s, scale, 0, 3 * scale, scale, glass);
    tiny_sphere(&s, scale, 0.125 * scale, 3 * scale, 0.5 * scale, tiny_glass(1.25));
    tiny_light(&s, 3 * scale, 5 * scale, -2 * scale, 1.0f, 0.75f, 0.5f);
    tiny_build(&s);
    c = tiny_trace(&s, origin, x, y, 1);
    tiny_end(&s);
    return c;
}

static void a_power_of_two_in_size_changes_no_bit(void **state)
{
    static const double scales[] = { 0x1p-100, 0x1p-40, 0x1p40, 0x1p100 };
    (void)state;

    for (int i = 0; i < 400; i++) {
        double x = (i % 20 - 9.5) / 12.0, y = (i / 20 - 12.5) / 16.0;
        colour one = see_scaled(1.0, x, y);

        for (int k = 0; k < 4; k++) {
            colour other = see_scaled(scales[k], x, y);
            assert_memory_equal(&one, &other, sizeof one);
        }
    }
}

static void stick(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const pov_mark no_mark = { 0, 0, 0.0, 0.0 };
    (void)self;

    if (ray->origin_surface != hits->owner)
        pov_cross(hits, 1e-300, 0.0, no_mark);
}

static void point_back(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    (void)self;
    (void)at;
    *out = pov_scale(pov_unit(ray->dir), -1.0);
}

static bool unbounded(const void *self, pov_box *out)
{
    (void)self;
    (void)out;
    return false;
}

/* More than are told apart. */
static void coincident_surfaces_cannot_hold_a_ray_for_ever(void **state)
{
    /* Certified: of other classes, what is so near the start counts as lying there. */
    const shape_class sticky = { .keyword = "sticky", .flags = POV_SHAPE_CERTIFIED, .instance_size = 1,
                                     .bounds = unbounded, .intersect = stick, .normal = point_back };
    tiny s;
    (void)state;
    tiny_begin(&s, NULL);

    for (int i = 0; i < COINCIDENT_MAX + 2; i++)
        tiny_add(&s, &sticky, "", tiny_glass(1.0));
    tiny_build(&s);
    tiny_trace(&s, pov_vec3_of(1, 1, 1), 0, 0, 1);
    assert_int_equal(s.tracer->context.counts.cut_depth, 1);
    tiny_end(&s);
}

static void stick_always(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const pov_mark no_mark = { 0, 0, 0.0, 0.0 };
    (void)ray;

    pov_cross(hits, *(const double *)self, 0.0, no_mark);
}

/* Near the origin of coordinates even such a step is not zero. */
static void a_shape_just_ahead_of_every_start_cannot_hold_a_ray_for_ever(void **state)
{
    static const double steps[] = { 1e-300, 0x1p-1074 };
    (void)state;

    for (int i = 0; i < 2; i++) {
        const shape_class sticky = { .keyword = "sticky", .flags = POV_SHAPE_CERTIFIED, .instance_size = sizeof(double),
                                     .bounds = unbounded, .intersect = stick_always, .normal = point_back };
        tiny s;

        tiny_begin(&s, NULL);
        tiny_add(&s, &sticky, &steps[i], tiny_glass(1.0));
        tiny_build(&s);
        tiny_trace(&s, pov_vec3_of(0, 0, 0), 0, 0, 1);
        assert_int_equal(s.tracer->context.counts.cut_depth, 1);
        tiny_end(&s);
    }
}

/* Each camera ray has the dielectrics around its own start, whatever its neighbours have. */
static void rays_that_start_in_different_places_know_what_they_are_in(void **state)
{
    pov_ray rays[BATCH_MAX];
    colour many[BATCH_MAX];
    tiny s;
    (void)state;
    tiny_begin(&s, NULL);

    s.model.background = colour_of(1.0f, 1.0f, 1.0f);
    tiny_sphere(&s, 0, 0, 0, 4, tiny_glass(1.5));
    tiny_sphere(&s, 1, 0, 0, 2, tiny_glass(1.2));
    for (int i = 0; i < 40; i++)
        tiny_sphere(&s, i - 20.0, 0, 9, 0.3, tiny_emitted(0.025f * (float)i, 0.5f, 0.0f));
    tiny_build(&s);
    assert_true(world_plan(s.world)->dielectrics_at_start);
    for (int i = 0; i < BATCH_MAX; i++) {
        const pov_ray ray = { .org = { 0.2 * i - 6.4, 0, 0 }, .dir = { 0.1, 0, 1 }, .origin_surface = POV_NO_OWNER };

        rays[i] = ray;
    }
    for (int round = 0; round < 2; round++) {
        tracer_colors(s.tracer, rays, BATCH_MAX, TRACER_SOUND, NULL, many, NULL);
        for (int i = 0; i < BATCH_MAX; i++) {
            const colour one = tracer_color(s.tracer, &rays[i]);

            assert_memory_equal(&many[i], &one, sizeof one);
        }
    }
    tiny_end(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_mirror_shows_what_is_before_it),
        cmocka_unit_test(a_filter_multiplies_by_its_colour_and_what_it_transmits),
        cmocka_unit_test(straight_on_does_not_count_for_the_depth),
        cmocka_unit_test(two_mirrors_give_as_many_pictures_as_there_are_levels),
        cmocka_unit_test(a_ray_is_cut_off_below_the_bailout_and_not_at_it),
        cmocka_unit_test(a_ray_may_split_at_every_level),
        cmocka_unit_test(a_sphere_of_glass_refracts_a_ray_twice),
        cmocka_unit_test(an_eye_in_glass_sees_refraction_on_the_way_out),
        cmocka_unit_test(an_eye_in_a_bubble_in_glass_is_in_the_bubble),
        cmocka_unit_test(total_inner_reflection_is_unfiltered_and_leaves_out_the_surface_s_own),
        cmocka_unit_test(the_list_of_rays_gives_what_recursion_gives),
        cmocka_unit_test(a_power_of_two_in_size_changes_no_bit),
        cmocka_unit_test(rays_that_start_in_different_places_know_what_they_are_in),
        cmocka_unit_test(coincident_surfaces_cannot_hold_a_ray_for_ever),
        cmocka_unit_test(a_shape_just_ahead_of_every_start_cannot_hold_a_ray_for_ever),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
