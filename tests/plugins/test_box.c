/* test_box.c - rays at boxes without extent along an axis: side by side they get what each gets. */
#include "support/check.h"
#include "support/fake_reader.h"
#include "support/shapes.h"

#include <math.h>
#include <string.h>

enum { RAYS = 16 };

static const shape_class *box;

static bool same(const pov_hits *one, const pov_hits *many)
{
    return one->count == many->count && memcmp(one->at, many->at, one->count * sizeof *one->at) == 0;
}

/* How many of some rays hit. */
static int compare(test_random *r, const void *self)
{
    const void *selves[RAYS];
    const pov_ray *rays[RAYS];
    pov_hits *hits[RAYS], of[2][RAYS];
    pov_crossing at[2][RAYS][2];
    pov_ray ray[RAYS];
    int count = 0;

    memset(at, 0, sizeof at);
    for (int i = 0; i < RAYS; i++) {
        const pov_vec3 target = { test_uniform(r, -1.5, 1.5), test_uniform(r, 1.5, 2.5), test_uniform(r, -1.5, 1.5) };

        ray[i] = (pov_ray){ .dir = test_direction(r), .origin_surface = POV_NO_OWNER };
        ray[i].org = pov_sub(target, pov_scale(ray[i].dir, test_uniform(r, 0.0, 3.0)));
        for (int k = 0; k < 2; k++)
            of[k][i] = (pov_hits){ .tmax = HUGE_VAL, .want = i % 3 == 0 ? POV_WANT_ALL : POV_WANT_NEAREST, .at = at[k][i], .capacity = 2 };
        selves[i] = self;
        rays[i] = &ray[i];
        hits[i] = &of[1][i];
        box->intersect(self, &ray[i], &of[0][i]);
        count += (int)of[0][i].count;
    }
    box->intersect_many(selves, rays, hits, RAYS);
    for (int i = 0; i < RAYS; i++)
        assert_true(same(&of[0][i], &of[1][i]));
    return count;
}

static void planar_ones_are_hit_side_by_side_as_by_single_rays(void **state)
{
    static const char *const texts[] = { "<-1, 2, -1>, <1, 2, 1>", "<0.3, 1, -1>, <0.3, 3, 1>", "<-1, 1, 0.2>, <1, 3, 0.2>" };
    test_random r = { 7 };
    int hits = 0;

    (void)state;
    for (int i = 0; i < 3; i++) {
        pov_reader *in = fake_reader_create();
        void *self;

        fake_reader_text(in, texts[i]);
        self = fake_reader_parse(in, box);
        assert_non_null(self);
        for (int turn = 0; turn < 1000; turn++)
            hits += compare(&r, self);
        fake_reader_destroy(in);
    }
    assert_true(hits > 5000);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(planar_ones_are_hit_side_by_side_as_by_single_rays) };

    box = fake_reader_shape("box");
    return box ? cmocka_run_group_tests(tests, NULL, NULL) : 1;
}
