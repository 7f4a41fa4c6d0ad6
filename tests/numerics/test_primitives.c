/* test_primitives.c - every primitive against 512 bits, on the same doubles.
 *
 * Without arguments a short run, as a test. test_primitives RAYS FILE: RAYS of torture for each kind, a
 * tenth of that for every other family, and a table of the scores in FILE, of the methods to compare with as well. */
#include "numerics/harness.h"

#include "numerics/leaving.h"

#include "support/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static long torture_rays = 30000, family_rays = 1500;
static FILE *table;
static harness *bench;

/* A torus takes long in 512 bits. */
enum { SEED = 20240607, OURS = 2, METHODS = 5, TORUS_SHARE = 16 };

/* Our own method first. The others are described in tests/numerics/methods. */
static const method methods[METHODS] = {
    { "certified", "lib/povtrace/primitives/" TEST_COPY, false, false },
    { "max", "lib/povtrace/primitives/" TEST_COPY, true, false },
    { "textbook", "tests/numerics/textbook/primitives", false, true },
    { "q-form", "tests/numerics/qform/primitives", false, true },
    { "double-double", "tests/numerics/twofold/primitives", false, true },
};

static const char *isa(void)
{
#if defined(__x86_64__)
    return "x86-64";
#elif defined(__aarch64__)
    return "aarch64";
#else
    return "other";
#endif
}

static void write_row(kind k, const family *f, const method *m, const score *s)
{
    const double n = s->rays ? (double)s->rays : 1.0;

    fprintf(table, "%s,%s,%g,%s,%s,%ld,%.1f,%.1f,%.3f,%.3f,%.4g,%.3g,%ld,%ld,0,%.3f,%ld,%ld,%d,\"%s\"\n",
            probe_keyword(k), f->name, f->parameter, m->name, isa(), s->rays, s->ns_median, s->ns_iqr, s->ulp_median,
            s->ulp_p99, s->ulp_max, s->normal_max, s->miss_false, s->hit_false, 100.0 * (double)s->escalated / n,
            s->selfhit, s->leak, SEED, s->worst);
    fflush(table);
}

static bool is_kept(kind k, const score *s)
{
    return s->miss_false == 0 && s->hit_false == 0 && s->part_false == 0 && s->exact_differs == 0
           && s->scale_differs == 0 && s->selfhit == 0 && s->leak == 0 && s->ulp_median <= 0.5 && s->ulp_p99 <= 2.0
           && s->ulp_max <= probe_limit(k) && s->normal_max <= 1e-13;
}

static void print_broken(kind k, const family *f, const method *m, const score *s)
{
    fprintf(stderr, "%s %s %g, %s: %ld rays, %ld missed, %ld hit falsely, %ld wrong parts, %ld self-hits, %ld leaks,\n",
            probe_keyword(k), f->name, f->parameter, m->name, s->rays, s->miss_false, s->hit_false, s->part_false,
            s->selfhit, s->leak);
    fprintf(stderr, "    exact differs %ld, scaled %ld, ulp %.3g %.3g %.3g, normal %.3g, point %.3g\n",
            s->exact_differs, s->scale_differs, s->ulp_median, s->ulp_p99, s->ulp_max, s->normal_max, s->point_max);
}

static void keep_promises(kind k)
{
    const family *f;
    long broken = 0;
    int i;

    for (f = families; f->name; f++) {
        const bool is_torture = strcmp(f->name, "torture") == 0;
        score s[METHODS];

        if (!(f->kinds & (1u << k)))
            continue;
        harness_run(bench, k, f, (is_torture ? torture_rays : family_rays) / (k == TORUS ? TORUS_SHARE : 1), SEED + (uint64_t)(f - families), s);
        for (i = 0; table && i < METHODS; i++)
            write_row(k, f, &methods[i], &s[i]);
        for (i = 0; i < OURS; i++) {
            if (is_kept(k, &s[i]))
                continue;
            broken++;
            print_broken(k, f, &methods[i], &s[i]);
        }
    }
    assert_int_equal(broken, 0);
}

static void a_sphere_keeps_its_promises(void **state) { (void)state; keep_promises(SPHERE); }
static void a_box_keeps_its_promises(void **state) { (void)state; keep_promises(BOX); }
static void a_cone_keeps_its_promises(void **state) { (void)state; keep_promises(CONE); }
static void a_cylinder_keeps_its_promises(void **state) { (void)state; keep_promises(CYLINDER); }
static void a_quadric_keeps_its_promises(void **state) { (void)state; keep_promises(QUADRIC); }
static void a_polygon_keeps_its_promises(void **state) { (void)state; keep_promises(POLYGON); }
/* Not compared with other methods. */
static void a_triangle_keeps_its_promises(void **state)
{
    (void)state;
    if (!table)
        keep_promises(TRIANGLE);
}
static void a_mesh_keeps_its_promises(void **state)
{
    (void)state;
    if (!table)
        keep_promises(MESH);
}

static void a_smooth_triangle_keeps_its_promises(void **state)
{
    (void)state;
    if (!table)
        keep_promises(SMOOTH_TRIANGLE);
}
static void a_torus_keeps_its_promises(void **state)
{
    (void)state;
    if (!table)
        keep_promises(TORUS);
}
static void a_plane_keeps_its_promises(void **state)
{
    (void)state;
    if (!table)
        keep_promises(PLANE);
}
static void a_disc_keeps_its_promises(void **state)
{
    (void)state;
    if (!table)
        keep_promises(DISC);
}

/* Rays that once were judged wrongly. */
static void what_once_failed_is_right(void **state)
{
    FILE *file = fopen(TEST_ROOT "/tests/numerics/replay.txt", "r");
    char line[8192];
    long broken = 0;

    (void)state;
    assert_non_null(file);
    while (fgets(line, sizeof line, file)) {
        probe p;
        score all[METHODS], s;

        if (line[0] == '#' || line[0] == '\n')
            continue;
        assert_true(probe_read(&p, line));
        harness_replay(bench, &p, all);
        s = all[0];
        broken += s.rays != 1 || s.miss_false || s.hit_false || s.part_false || s.normal_max > 1e-13
                  || s.ulp_max > probe_limit(p.kind) || s.selfhit || s.leak || s.exact_differs || s.scale_differs;
    }
    fclose(file);
    assert_int_equal(broken, 0);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_sphere_keeps_its_promises),   cmocka_unit_test(a_box_keeps_its_promises),
        cmocka_unit_test(a_cone_keeps_its_promises),     cmocka_unit_test(a_cylinder_keeps_its_promises),
        cmocka_unit_test(a_quadric_keeps_its_promises),  cmocka_unit_test(a_polygon_keeps_its_promises),
        cmocka_unit_test(a_triangle_keeps_its_promises), cmocka_unit_test(a_mesh_keeps_its_promises),
        cmocka_unit_test(a_smooth_triangle_keeps_its_promises), cmocka_unit_test(a_torus_keeps_its_promises),
        cmocka_unit_test(a_plane_keeps_its_promises),    cmocka_unit_test(a_disc_keeps_its_promises),
        cmocka_unit_test(what_once_failed_is_right),
    };
    int failed;

    if (argc > 1) {
        torture_rays = strtol(argv[1], NULL, 10);
        family_rays = torture_rays / 10;
    }
    if (argc > 2) {
        table = fopen(argv[2], "w");
        if (!table) {
            perror(argv[2]);
            return 2;
        }
        fprintf(table,
                "kind,family,param,method,isa,n,ns_ray_med,ns_ray_iqr,t_ulp_med,t_ulp_p99,t_ulp_max,normal_rad_max,"
                "miss_false,hit_false,undecided_pct,fallback_pct,selfhit,leak,seed,worst_case_hex\n");
    }
    bench = harness_create(methods, table ? METHODS : OURS);
    failed = cmocka_run_group_tests(tests, NULL, NULL);
    harness_destroy(bench);
    if (table)
        fclose(table);
    return failed;
}
