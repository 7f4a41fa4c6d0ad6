/* test_leaving.c - rays that leave a surface never meet their start again, in great numbers.
 *
 * The exact answer is asked for only where the count of crossings does not show by itself that all is well, so that a
 * million rays of a family take seconds. Without arguments a short run; test_leaving RAYS [KIND]: so many rays for every
 * family, of all kinds or one. */
#include "numerics/families.h"
#include "numerics/leaving.h"

#include "support/check.h"
#include "support/fake_reader.h"

#include <povtrace/exact.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SEED = 20250101, RAYS_OF_A_CROSSING = 16, PROBES_OF_A_READER = 256 };

static long rays_wanted = 4000;
static const char *only;

typedef struct tally { long spawned, selfhit, leak, judged; } tally;

/* For a convex shape: 1 where a direction goes inward, 0 where it goes outward, -1 where that is not certain. */
static int plain_count(const probe *p, double slope)
{
    const bool convex = p->kind == SPHERE || p->kind == BOX || (!p->open && (p->kind == CONE || p->kind == CYLINDER));

    if (kind_is_planar(p->kind))
        return 0;
    return !convex || fabs(slope) < 1e-9 ? -1 : slope < 0.0;
}

/* The crossings that a line can have besides its start. */
static uint32_t most_crossings(kind k) { return kind_is_planar(k) ? 0 : k == CONE || k == CYLINDER || k == TORUS ? 3 : 1; }

/* Is it plain that nothing here is the start? Distances in doubles are off by far less than that part of the size. */
static bool is_plainly_well(const probe *q, double slope, const pov_crossing *at, uint32_t n)
{
    const int count = plain_count(q, slope);
    uint32_t i;

    if (n > most_crossings(q->kind) || (count >= 0 && n != (uint32_t)count))
        return false;
    for (i = 0; i < n; i++) {
        if (!(at[i].t > 1e-6 * q->size))
            return false;
    }
    return true;
}

/* The ray as a line that replay.txt can hold, what it left, and what it met. */
static void complain(const probe *q, leaving_verdict verdict, const pov_crossing *at, uint32_t n, int expected)
{
    char line[4096];
    uint32_t i;

    probe_write(q, line, sizeof line);
    print_error("%s: %s\n    left part %u, %d expected", verdict == HIT_ITSELF ? "met itself" : "leaked", line,
                q->ray.origin_mark.feature, expected);
    for (i = 0; i < n; i++)
        print_error(", part %u at %.17g", at[i].mark.feature, at[i].t);
    print_error("\n");
}

static void leave_once(const subject *s, const probe *p, const pov_crossing *c, pov_vec3 normal, tally *out)
{
    leaving_verdict verdict = LEFT_WELL;
    pov_crossing at[CROSSINGS_MAX];
    uint32_t n, escalated;
    int expected = 0;
    probe q = *p;

    q.ray = leaving_ray(&p->ray, c, leaving_direction(normal));
    n = subject_ask(s, &q.ray, at, &escalated);
    if (!is_plainly_well(&q, pov_dot(normal, q.ray.dir), at, n)) {
        real_reset();
        out->judged++;
        verdict = leaving_judge(s, &q, c, c->t * probe_speed(p), normal, &expected);
    }
    out->spawned += verdict != NOT_JUDGED;
    out->selfhit += verdict == HIT_ITSELF;
    out->leak += verdict == LEAKED || verdict == MISPLACED;
    if (verdict != LEFT_WELL && verdict != NOT_JUDGED && out->selfhit + out->leak <= 8)
        complain(&q, verdict, at, n, expected);
}

/* Crossings that are as good as one at a rim, or beyond all reason, are no start; but the planes of boxes have names. */
static bool is_a_start(const probe *p, const pov_crossing *at, uint32_t n, uint32_t i)
{
    const double speed = probe_speed(p), dir = at[i].t * speed;
    const double apart = 1e-6 * (p->kind == TORUS ? p->number[1] : p->size);

    if (!(dir < 1e15 * p->size) || at[i].t < 1e-290 || at[i].t > 1e290)
        return false;
    if (p->kind == BOX)
        return true;
    return (i == 0 || (at[i].t - at[i - 1].t) * speed > apart)
           && (i + 1 == n || (at[i + 1].t - at[i].t) * speed > apart);
}

static void leave_probe(const subject *s, const probe *p, tally *out)
{
    pov_crossing at[CROSSINGS_MAX];
    uint32_t escalated, i, n = subject_ask(s, &p->ray, at, &escalated);
    int j;

    for (i = 0; i < n; i++) {
        pov_vec3 normal;

        if (!is_a_start(p, at, n, i))
            continue;
        s->shape->normal(s->self, &p->ray, &at[i], &normal);
        for (j = 0; j < RAYS_OF_A_CROSSING; j++)
            leave_once(s, p, &at[i], normal, out);
    }
}

static tally leave_family(const shape_class *shape, kind k, const family *f)
{
    tally out = { 0, 0, 0, 0 };
    long probes = 0;
    int i;

    while (out.spawned < rays_wanted && probes < 20 * rays_wanted) {
        pov_reader *in = fake_reader_create();
        void *self = fake_reader_memory(in, shape->instance_size);
        const subject s = { shape, self, false };

        for (i = 0; i < PROBES_OF_A_READER && out.spawned < rays_wanted; i++, probes++) {
            probe p;

            memset(&p, 0, sizeof p);
            p.kind = k;
            f->make(&p, f->parameter);
            memset(self, 0, shape->instance_size);
            if (isfinite(probe_speed(&p)) && probe_make(&p, shape, in, self))
                leave_probe(&s, &p, &out);
        }
        fake_reader_destroy(in);
    }
    return out;
}

static void no_ray_hits_the_point_that_it_leaves(void **state)
{
    tally all = { 0, 0, 0, 0 };
    const family *f;
    long families_done = 0;
    int k;

    (void)state;
    for (k = 0; k < KINDS; k++) {
        const shape_class *shape = fake_reader_shape(probe_keyword((kind)k));
        tally sum = { 0, 0, 0, 0 };

        assert_non_null(shape);
        for (f = families; f->name; f++) {
            tally t;

            if (!(f->kinds & (1u << k)) || (only && strcmp(only, probe_keyword((kind)k)) != 0))
                continue;
            families_seed(SEED + (uint64_t)(f - families));
            t = leave_family(shape, (kind)k, f);
            families_done++;
            assert_true(t.spawned >= rays_wanted);
            sum.spawned += t.spawned, sum.selfhit += t.selfhit, sum.leak += t.leak, sum.judged += t.judged;
        }
        all.selfhit += sum.selfhit;
        all.leak += sum.leak;
        if (sum.spawned)
            print_message("%s: %ld rays left, %ld met themselves, %ld leaked; %ld of them asked exactly\n",
                          probe_keyword((kind)k), sum.spawned, sum.selfhit, sum.leak, sum.judged);
    }
    print_message("%ld pairs of kind and family, %ld rays each\n", families_done, rays_wanted);
    real_free_all();
    assert_int_equal(all.selfhit, 0);
    assert_int_equal(all.leak, 0);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(no_ray_hits_the_point_that_it_leaves) };

    if (argc > 1)
        rays_wanted = strtol(argv[1], NULL, 10);
    if (argc > 2)
        only = argv[2];
    return cmocka_run_group_tests(tests, NULL, NULL);
}
