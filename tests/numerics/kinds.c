#include "numerics/kinds.h"

#include "numerics/draw.h"

#include "support/check.h"
#include "support/fake_reader.h"
#include "support/rays.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { RAYS_A_SHAPE = 50 };

/* How far distances may be off, in sizes and as a part of themselves; grazing rays cross slowly, and where they bend away on both
 * sides (a triple root) slower still. */
static const double OFF = 0x1p-24, PART = 0x1p-48, BENT = 0x1p-14;

void kinds_collect(const poly_real *p, real from, real to, answer *out)
{
    const poly_piece piece = { *p, from, to };

    out->count += poly_roots(&piece, out->at + out->count, KIND_CROSSINGS - out->count);
}

/* ---- rays ---- */

/* Some start within the shape, or near it. */
static double distance(void)
{
    const double u = U();

    return u < 0.2 ? between(0.0, 2.0) : u < 0.7 ? between(3.0, 6.0) : log_between(1.0, 6.0);
}

/* Some are nearly across an axis. */
static pov_vec3 direction(void)
{
    pov_vec3 d = families_direction();

    if (U() < 0.1)
        d.y *= log_between(-8.0, -1.0);
    return pov_unit(d);
}

/* Along a surface, for some nearly across an axis, too. */
static pov_vec3 direction_along(pov_vec3 normal)
{
    const pov_vec3 d = across(normal), level = pov_cross_product(normal, pov_vec3_of(0.0, 1.0, 0.0));

    return U() < 0.2 && pov_largest(level) > 0.0 ? pov_unit(pov_add(pov_unit(level), pov_scale(d, log_between(-8.0, -1.0)))) : d;
}

static pov_ray any_ray(void)
{
    const pov_vec3 d = direction(), to = pov_vec3_of(between(-1.0, 1.0), between(-1.5, 1.5), between(-1.0, 1.0));

    return ray_from(pov_sub(to, pov_scale(d, distance())), d);
}

static int by_distance(const void *a, const void *b)
{
    const double *s = a, *t = b;

    return (*s > *t) - (*s < *t);
}

static uint32_t ask(const shape_class *c, const void *self, const pov_ray *ray, double end, pov_crossing *at)
{
    static union { char bytes[1 << 16]; double aligned; } scratch;
    pov_hits hits = hits_to(end, POV_WANT_ALL, at, KIND_CROSSINGS);

    hits.scratch = &scratch;
    c->intersect(self, ray, &hits);
    return hits.count;
}

/* Beside a crossing of another ray, along the surface there. */
static pov_ray grazing_ray(const shape_class *c, const void *self)
{
    pov_ray ray = any_ray();
    pov_crossing at[KIND_CROSSINGS];
    pov_vec3 normal, p, d;

    if (ask(c, self, &ray, 1e3, at) == 0)
        return ray;
    c->normal(self, &ray, &at[0], &normal);
    p = pov_add(pov_add(ray.org, pov_scale(ray.dir, at[0].t)), pov_scale(normal, either(log_between(-9.0, -1.0))));
    d = direction_along(normal);
    return ray_from(pov_sub(p, pov_scale(d, distance())), d);
}

/* ---- the verdict ---- */

/* Pairs nearer than KIND_TOUCH are left out. */
static int drop_pairs(double *at, int n)
{
    int kept = 0;

    for (int i = 0; i < n; i++) {
        if (kept > 0 && at[i] - at[kept - 1] < KIND_TOUCH)
            kept--;
        else
            at[kept++] = at[i];
    }
    return kept;
}

static bool agree(const double *a, int n, const double *b, int m, double off)
{
    bool same = n == m;

    for (int i = 0; same && i < n; i++)
        same = fabs(a[i] - b[i]) <= off + PART * fabs(b[i]);
    return same;
}

typedef struct score { long asked, open, wrong, crossings; double off; } score;

static void judge(const kind_row *k, const shape_class *c, const shape *s, const void *self, const pov_ray *ray, score *out)
{
    const double end = 2.0 * sqrt(pov_dot(ray->org, ray->org)) + 10.0;
    pov_crossing at[KIND_CROSSINGS];
    const int n = (int)ask(c, self, ray, end, at);
    double found[KIND_CROSSINGS];
    answer there = { 0, { 0.0 }, false };
    along a;

    real_reset();
    a.x = poly_line(real_of(ray->org.x), real_of(ray->dir.x));
    a.y = poly_line(real_of(ray->org.y), real_of(ray->dir.y));
    a.z = poly_line(real_of(ray->org.z), real_of(ray->dir.z));
    a.end = real_of(end);
    k->solve(s, &a, &there);
    for (int i = 0; i < n; i++)
        found[i] = at[i].t;
    qsort(found, (size_t)n, sizeof *found, by_distance);
    qsort(there.at, (size_t)there.count, sizeof *there.at, by_distance);
    out->asked++;
    out->crossings += there.count;
    if (agree(found, n, there.at, there.count, OFF)) {
        for (int i = 0; i < n; i++)
            out->off = fmax(out->off, fabs(found[i] - there.at[i]) - PART * fabs(found[i]));
        return;
    }
    if (there.open || agree(found, drop_pairs(found, n), there.at, drop_pairs(there.at, there.count), BENT)) {
        out->open++;
        return;
    }
    if (out->wrong++ == 0)
        fprintf(stderr, "%s: ray <%a,%a,%a> <%a,%a,%a>: %d crossings, found %d\n", k->keyword, ray->org.x, ray->org.y, ray->org.z,
                ray->dir.x, ray->dir.y, ray->dir.z, there.count, n);
}

void kinds_keep_crossings(const kind_row *k, long rays)
{
    const shape_class *c = fake_reader_shape(k->keyword);
    score s = { 0, 0, 0, 0, 0.0 };

    assert_non_null(c);
    families_seed(11);
    while (s.asked < rays) {
        pov_reader *in = fake_reader_create();
        shape one;
        void *self;

        k->make(&one, in);
        self = fake_reader_parse(in, c);
        if (!self)
            fail_msg("%s: %s", k->keyword, fake_reader_message(in));
        for (int i = 0; i < RAYS_A_SHAPE; i++) {
            const pov_ray ray = U() < 0.5 ? any_ray() : grazing_ray(c, self);

            judge(k, c, &one, self, &ray, &s);
        }
        fake_reader_destroy(in);
    }
    printf("%s: %ld rays, %ld crossings, %ld open, %ld misjudged, off by %.2g sizes\n", k->keyword, s.asked, s.crossings, s.open, s.wrong,
           s.off);
    assert_int_equal(s.wrong, 0);
    assert_true(1000 * s.open <= s.asked);
}
