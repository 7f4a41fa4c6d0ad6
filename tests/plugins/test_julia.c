/* test_julia.c - thin parts of a julia_fractal. */
#include "plug/shape_class.h"

#include "support/check.h"
#include "support/fake_reader.h"

#include <math.h>
#include <string.h>

enum { OWNER = 3, MOST = 64, RAYS = 20000 };

static uint64_t state = 88172645463325252u;

static double uniform(void)
{
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return (double)(state >> 11) * 0x1p-53;
}

static pov_vec3 within_sphere(double r)
{
    pov_vec3 v;

    do
        v = pov_vec3_of(2.0 * uniform() - 1.0, 2.0 * uniform() - 1.0, 2.0 * uniform() - 1.0);
    while (!(pov_dot(v, v) <= 1.0));
    return pov_scale(v, r);
}

static bool no_more(pov_hits *hits)
{
    (void)hits;
    return false;
}

static uint32_t count(const shape_class *c, const void *self, const pov_ray *ray)
{
    pov_crossing at[MOST];
    pov_hits hits = { .tmax = HUGE_VAL, .want = POV_WANT_ALL, .at = at, .capacity = MOST, .grow = no_more, .owner = OWNER };

    c->intersect(self, ray, &hits);
    return hits.count;
}

static void *make(pov_reader *in, const shape_class *c, const char *text)
{
    fake_reader_text(in, text);
    return fake_reader_parse(in, c);
}

/* A precision that divides stretches down to 1/64000 tells what is there. */
static void crossings_are_found_at_a_low_precision(void **unused)
{
    const shape_class *c = fake_reader_shape("julia_fractal");
    pov_reader *a = fake_reader_create(), *b = fake_reader_create();
    const void *rough = make(a, c, "<-.08, 0, -.83, -.02> quaternion sqr max_iteration 8 precision 20");
    const void *fine = make(b, c, "<-.08, 0, -.83, -.02> quaternion sqr max_iteration 8 precision 4000");
    int lost = 0;

    (void)unused;
    assert_non_null(rough);
    assert_non_null(fine);
    for (int i = 0; i < RAYS; i++) {
        const pov_vec3 to = within_sphere(1.2);
        pov_ray ray;

        memset(&ray, 0, sizeof ray);
        ray.origin_surface = UINT32_MAX;
        ray.dir = pov_unit(within_sphere(1.0));
        ray.org = pov_sub(to, pov_scale(ray.dir, 4.0));
        lost += count(c, rough, &ray) != count(c, fine, &ray);
    }
    assert_int_equal(lost, 0);
    fake_reader_destroy(a);
    fake_reader_destroy(b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(crossings_are_found_at_a_low_precision),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
