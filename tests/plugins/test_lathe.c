/* test_lathe.c - rays that leave a lathe. */
#include "plug/shape_class.h"

#include "support/check.h"
#include "support/fake_reader.h"

#include <povtrace/exact.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { OWNER = 3, MOST = 64, SHAPES = 8, RAYS = 4000, LEAVING = 20 };

static uint64_t state;

static double uniform(void)
{
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return (double)(state >> 11) * 0x1p-53;
}

static double between(double lo, double hi) { return lo + (hi - lo) * uniform(); }

static pov_vec3 direction(void)
{
    pov_vec3 v;

    do
        v = pov_vec3_of(between(-1.0, 1.0), between(-1.0, 1.0), between(-1.0, 1.0));
    while (pov_dot(v, v) > 1.0 || pov_dot(v, v) < 1e-3);
    return pov_unit(v);
}

static bool no_more(pov_hits *hits)
{
    (void)hits;
    return false;
}

static uint32_t ask(const shape_class *c, const void *self, void *scratch, const pov_ray *ray, pov_crossing *at)
{
    pov_hits hits = { .tmax = HUGE_VAL, .want = POV_WANT_ALL, .at = at, .capacity = MOST, .grow = no_more, .scratch = scratch, .owner = OWNER };

    c->intersect(self, ray, &hits);
    return hits.count;
}

/* Straight pieces that rise, between two ends on the axis. */
static void *make(pov_reader *in, const shape_class *c)
{
    const int n = 4 + (int)(4.0 * uniform());
    double y = between(-1.5, -0.5);
    char text[1024];
    int length = snprintf(text, sizeof text, "linear_spline %d", n);

    for (int i = 0; i < n; i++, y += between(0.2, 0.6))
        length += snprintf(text + length, sizeof text - (size_t)length, ", <%.17g, %.17g>", i == 0 || i == n - 1 ? 0.0 : between(0.2, 1.0), y);
    fake_reader_text(in, text);
    return fake_reader_parse(in, c);
}

static pov_two along(double org, double dir, const pov_crossing *at)
{
    return pov_two_add_double(pov_two_add_double(pov_two_product(dir, at->t), dir * at->t_lo), org);
}

/* From a crossing, half of them tilted less against the surface, by up to 1e-4. */
static pov_ray leave(const pov_ray *ray, const pov_crossing *at, pov_vec3 normal)
{
    const pov_two x = along(ray->org.x, ray->dir.x, at), y = along(ray->org.y, ray->dir.y, at), z = along(ray->org.z, ray->dir.z, at);
    const double part = uniform() < 0.5 ? 1.0 : pow(10.0, -4.0 * uniform());
    pov_ray next;

    memset(&next, 0, sizeof next);
    next.org = pov_vec3_of(x.hi, y.hi, z.hi);
    next.org_lo = pov_vec3_of(x.lo, y.lo, z.lo);
    next.dir = direction();
    next.dir = pov_unit(pov_sub(next.dir, pov_scale(normal, pov_dot(normal, next.dir) * (1.0 - part))));
    next.origin_surface = OWNER;
    next.origin_mark = at->mark;
    return next;
}

/* No chord of a cone is shorter than its tilt times the distance from the axis. */
static int count_starts_met(const shape_class *c, const void *self, void *scratch, const pov_ray *ray)
{
    pov_crossing at[MOST], again[MOST];
    const uint32_t n = ask(c, self, scratch, ray, at);
    int met = 0;

    for (int i = 0; n > 0 && i < LEAVING; i++) {
        const pov_crossing *from = &at[(uint32_t)(n * uniform())];
        pov_vec3 normal;
        pov_ray next;
        double tilt;
        uint32_t m;

        c->normal(self, ray, from, &normal);
        next = leave(ray, from, normal);
        tilt = fabs(pov_dot(normal, next.dir));
        m = tilt > 1e-6 ? ask(c, self, scratch, &next, again) : 0;
        for (uint32_t k = 0; k < m; k++)
            met += again[k].mark.feature == from->mark.feature && again[k].t < tilt * sqrt(next.org.x * next.org.x + next.org.z * next.org.z);
    }
    return met;
}

static pov_ray aimed(void)
{
    const pov_vec3 to = pov_scale(direction(), 0.9 * uniform());
    pov_ray ray;

    memset(&ray, 0, sizeof ray);
    ray.origin_surface = UINT32_MAX;
    ray.dir = direction();
    ray.org = pov_sub(to, pov_scale(ray.dir, 3.0));
    return ray;
}

static void a_ray_that_leaves_a_lathe_does_not_meet_its_start(void **unused)
{
    const shape_class *c = fake_reader_shape("lathe");
    int met = 0;

    (void)unused;
    assert_non_null(c);
    state = 88172645463325252u;
    for (int shape = 0; shape < SHAPES; shape++) {
        pov_reader *in = fake_reader_create();
        void *const self = make(in, c), *const scratch = self ? malloc(c->scratch(self)) : NULL;

        assert_non_null(scratch);
        for (int i = 0; i < RAYS; i++) {
            const pov_ray ray = aimed();

            met += count_starts_met(c, self, scratch, &ray);
        }
        free(scratch);
        fake_reader_destroy(in);
    }
    assert_int_equal(met, 0);
}

/* Behind a crossing, against its normal. */
static bool is_inside(const shape_class *c, const void *self, const pov_ray *ray, const pov_crossing *at, double off)
{
    const pov_vec3 none = { 0.0, 0.0, 0.0 };
    pov_vec3 normal, p;

    c->normal(self, ray, at, &normal);
    p = pov_vec3_of(along(ray->org.x, ray->dir.x, at).hi, along(ray->org.y, ray->dir.y, at).hi, along(ray->org.z, ray->dir.z, at).hi);
    return c->inside(self, pov_sub(p, pov_scale(normal, off)), none);
}

/* Of curves whose ends are on the other side of an area than what bulges, that cross themselves, that go round a hole. */
static void normals_point_out_of_what_is_inside(void **unused)
{
    static const char *const texts[] = {
        "bezier_spline 12, <.4,-.6>, <1,-.6>, <1,.6>, <.4,.6>, <.4,.6>, <.3,.6>, <.3,.3>, <.5,0>, <.5,0>, <.6,-.2>, <.2,-.6>, <.4,-.6>",
        "bezier_spline 4, <.3,-.8>, <2.5,1.5>, <2.5,-1.5>, <.3,.8>",
        "linear_spline 5, <.3,-.8>, <.9,.8>, <.3,.8>, <.9,-.8>, <.3,-.8>",
        "linear_spline 6, <0,-.8>, <.9,0>, <.4,.5>, <.4,-.5>, <.9,.2>, <0,.8>",
        "quadratic_spline 6, <.2,.1>, <.4,-.5>, <.9,0>, <.5,.6>, <.2,.1>, <.4,-.5>",
        "cubic_spline 7, <.9,0>, <.4,-.5>, <.2,.1>, <.5,.6>, <.9,0>, <.4,-.5>, <.2,.1>",
        "linear_spline 3, <0,.8>, <.9,0>, <0,-.8>",
    };
    const shape_class *c = fake_reader_shape("lathe");

    (void)unused;
    assert_non_null(c);
    state = 88172645463325252u;
    for (size_t k = 0; k < sizeof texts / sizeof texts[0]; k++) {
        pov_reader *in = fake_reader_create();
        void *self, *scratch;
        int count = 0, wrong = 0;

        fake_reader_text(in, texts[k]);
        self = fake_reader_parse(in, c);
        scratch = self ? malloc(c->scratch(self)) : NULL;
        assert_non_null(scratch);
        for (int i = 0; i < RAYS; i++) {
            const pov_ray ray = aimed();
            pov_crossing at[MOST];
            const uint32_t n = ask(c, self, scratch, &ray, at);

            for (uint32_t h = 0; h < n; h++, count++)
                wrong += !is_inside(c, self, &ray, &at[h], 1e-5) || is_inside(c, self, &ray, &at[h], -1e-5);
        }
        if (count < RAYS / 4 || wrong > count / 500)
            fail_msg("%s: of %d normals %d do not point outward", texts[k], count, wrong);
        free(scratch);
        fake_reader_destroy(in);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_ray_that_leaves_a_lathe_does_not_meet_its_start),
        cmocka_unit_test(normals_point_out_of_what_is_inside),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
