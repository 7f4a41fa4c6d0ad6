#include "numerics/harness.h"

#include "support/fake_reader.h"

#include <povtrace/exact.h>

#include <float.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { BATCH = 256, OWNER = 7, ROUNDS = 9 };

struct harness {
    const pov_shape_class *shape[KINDS];
    double *ulps;
    long count, capacity;
    int printed;
    /* One batch: instances side by side, and the rays that were asked of them. */
    pov_reader *in;
    char *instances;
    size_t stride;
    probe probes[BATCH];
    int made;
    double *times;
    long time_count, time_capacity;
};

harness *harness_create(void)
{
    harness *h = calloc(1, sizeof *h);
    size_t largest = 0;
    int k;

    for (k = 0; h && k < KINDS; k++) {
        h->shape[k] = fake_reader_shape(probe_keyword((kind)k));
        if (!h->shape[k])
            abort();
        if (h->shape[k]->instance_size > largest)
            largest = h->shape[k]->instance_size;
    }
    if (!h)
        abort();
    h->stride = (largest + 63) / 64 * 64;
    h->instances = malloc(h->stride * (BATCH + 1));
    if (!h->instances)
        abort();
    return h;
}

void harness_destroy(harness *h)
{
    free(h->ulps);
    free(h->times);
    free(h->instances);
    free(h);
    real_free_all();
}

static void *instance(harness *h, int i)
{
    const uintptr_t start = ((uintptr_t)h->instances + 63) / 64 * 64;
    return (char *)h->instances + (start - (uintptr_t)h->instances) + h->stride * (size_t)i;
}

static void keep(double **values, long *count, long *capacity, double value)
{
    if (*count == *capacity) {
        *capacity = *capacity ? 2 * *capacity : 1024;
        *values = realloc(*values, (size_t)*capacity * sizeof **values);
        if (!*values)
            abort();
    }
    (*values)[(*count)++] = value;
}

double harness_limit(kind k)
{
    return k == SPHERE || k == QUADRIC ? 16.0 : k == BOX || k == POLYGON ? 4.0 : 32.0;
}

/* ---- one question ---- */

static uint32_t ask(const pov_shape_class *shape, const void *self, const pov_ray *ray, bool always_exact,
                    pov_crossing at[8], uint32_t *decided)
{
    pov_hits hits = { 0.0, HUGE_VAL, POV_WANT_ALL, always_exact, OWNER, 0, 8, 0, at, NULL, NULL, false };
    uint32_t i, j;

    shape->intersect(self, ray, &hits);
    *decided = hits.decided;
    for (i = 1; i < hits.count; i++) {
        const pov_crossing c = at[i];

        for (j = i; j > 0 && (at[j - 1].t > c.t || (at[j - 1].t == c.t && at[j - 1].t_lo > c.t_lo)); j--)
            at[j] = at[j - 1];
        at[j] = c;
    }
    return hits.count;
}

/* The crossings in front of the origin. False: a distance is out of the range of doubles, or of all
 * reason. */
static bool keep_positive(exact_answer *e, const probe *p)
{
    const double speed = pov_dot(pov_unit(p->ray.dir), p->ray.dir);
    int i, n = 0;

    for (i = 0; i < e->count; i++) {
        const double t = fabs(real_double(e->at[i].t));

        if (t > 1e300 || (t < 1e-290 && real_sign(e->at[i].t) != 0) || t * speed > 1e60 * p->size)
            return false;
        if (real_sign(e->at[i].t) > 0)
            e->at[n++] = e->at[i];
    }
    e->count = n;
    return true;
}

static void complain(harness *h, const probe *p, const char *what, score *s)
{
    char line[4096];

    probe_write(p, line, sizeof line);
    if (h->printed++ < 8)
        fprintf(stderr, "%s: %s\n", what, line);
    if (!s->worst[0])
        snprintf(s->worst, sizeof s->worst, "%s", line);
}

static double ulps_off(real exact, double t)
{
    const double near = fabs(real_double(exact));
    return fabs(real_double(real_sub(exact, real_of(t)))) / (nextafter(near, HUGE_VAL) - near);
}

static void compare_one(harness *h, const probe *p, const void *self, const exact_crossing *e, const pov_crossing *c,
                        score *s)
{
    const double off = ulps_off(e->t, c->t);
    const double speed = pov_dot(pov_unit(p->ray.dir), p->ray.dir);
    const double point = fabs(real_double(real_sub(e->t, real_of2(c->t, c->t_lo)))) * speed / p->size;
    pov_vec3 n;
    double turn;

    s->crossings++;
    s->part_false += e->part != c->mark.part;
    if (e->part != c->mark.part)
        complain(h, p, "wrong part", s);
    keep(&h->ulps, &h->count, &h->capacity, off);
    if (off > s->ulp_max) {
        s->ulp_max = off;
        if (off > harness_limit(p->kind))
            complain(h, p, "distance", s);
    }
    s->point_max = fmax(s->point_max, point);
    h->shape[p->kind]->normal(self, &p->ray, c, &n);
    /* A polygon has no outside: its normal may point either way. */
    if (p->kind == POLYGON && n.x * e->normal[0] + n.y * e->normal[1] + n.z * e->normal[2] < 0.0)
        n = pov_scale(n, -1.0);
    turn = fmax(fabs(n.x - e->normal[0]), fmax(fabs(n.y - e->normal[1]), fabs(n.z - e->normal[2])));
    /* So near to an apex not even a distance in two parts tells where around it: any normal will do. */
    if (isnan(e->normal[0]) || e->room < 1e-15 * p->size)
        turn = 0.0;
    if (!(turn <= 1e-13))
        complain(h, p, "normal", s);
    if (isnan(n.x) || fabs(pov_dot(n, n) - 1.0) > 8.0 * DBL_EPSILON)
        complain(h, p, "normal not unit", s), turn = HUGE_VAL;
    s->normal_max = fmax(s->normal_max, turn);
}

/* ---- rays that leave the surface ---- */

static pov_two coordinate(double o, double o_lo, const pov_crossing *c, double d, double d_lo)
{
    pov_two t = pov_two_of(c->t, c->t_lo);
    return pov_two_add(pov_two_sum(o, o_lo), pov_two_mul(t, pov_two_of(d, d_lo)));
}

static pov_ray leave(const pov_ray *ray, const pov_crossing *c, pov_vec3 normal)
{
    const pov_two x = coordinate(ray->org.x, ray->org_lo.x, c, ray->dir.x, ray->dir_lo.x);
    const pov_two y = coordinate(ray->org.y, ray->org_lo.y, c, ray->dir.y, ray->dir_lo.y);
    const pov_two z = coordinate(ray->org.z, ray->org_lo.z, c, ray->dir.z, ray->dir_lo.z);
    pov_vec3 along = families_direction();
    pov_ray r;

    memset(&r, 0, sizeof r);
    if (families_uniform() < 0.5) {
        const double tilt = pow(10.0, -6.0 * families_uniform());
        along = pov_sub(along, pov_scale(normal, pov_dot(along, normal) * (1.0 - tilt)));
    }
    r.org = pov_vec3_of(x.hi, y.hi, z.hi);
    r.org_lo = pov_vec3_of(x.lo, y.lo, z.lo);
    r.dir = pov_unit(along);
    r.left = OWNER;
    r.left_mark = c->mark;
    return r;
}

/* Take the root that the ray starts on out of the exact answer. False: it cannot be told from another. */
static bool take_out_start(exact_answer *e, double size)
{
    double nearest = HUGE_VAL, second = HUGE_VAL;
    int i, start = 0;

    for (i = 0; i < e->count; i++) {
        const double t = fabs(real_double(e->at[i].t));

        if (t < nearest) {
            second = nearest;
            nearest = t;
            start = i;
        } else if (t < second) {
            second = t;
        }
    }
    /* At a rim the rounded start can lie beside the shape. */
    if (e->count == 0 || nearest > 1e-3 * size)
        return true;
    if (nearest > 1e-9 * size || (e->count > 1 && second < 1e-6 * size))
        return false;
    for (i = start; i + 1 < e->count; i++)
        e->at[i] = e->at[i + 1];
    e->count--;
    return true;
}

static void spawn(harness *h, const probe *p, const void *self, const pov_crossing *c, score *s)
{
    const pov_shape_class *shape = h->shape[p->kind];
    exact_answer e;
    pov_crossing at[8];
    uint32_t n, decided;
    pov_vec3 normal;
    probe q = *p;
    int i;

    shape->normal(self, &p->ray, c, &normal);
    q.ray = leave(&p->ray, c, normal);
    probe_exact(&q, &e);
    if (p->kind == POLYGON)
        e.count = 0;
    else if (!take_out_start(&e, p->size))
        return;
    if (!keep_positive(&e, &q) || c->t * pov_dot(pov_unit(p->ray.dir), p->ray.dir) > 1e15 * p->size)
        return;
    s->spawned++;
    n = ask(shape, self, &q.ray, false, at, &decided);
    /* Within rounding of a rim the ray may pass through the corner or miss it: another part, and no
     * distance at all. */
    if (n == 1 && e.count == 0 && at[0].mark.part != c->mark.part && at[0].t < 1e-9 * p->size)
        return;
    if (n > (uint32_t)e.count) {
        s->selfhit++;
        complain(h, p, "met itself after", s);
    } else if (n < (uint32_t)e.count) {
        s->leak++;
        complain(h, p, "leaked after", s);
    }
    /* A chord along the surface is as long as the square root of what two parts lose: nobody could tell its last bits. */
    if (fabs(pov_dot(normal, q.ray.dir)) < 1e-7)
        return;
    for (i = 0; i < e.count && (uint32_t)e.count == n; i++) {
        if (ulps_off(e.at[i].t, at[i].t) > harness_limit(p->kind)) {
            s->leak++;
            complain(h, &q, "other side misplaced", s);
        }
    }
}

/* ---- scaling ---- */

/* Everything 2^k times as large gives the same bits 2^k times as large. */
static bool scales(harness *h, const probe *p, const pov_crossing *at, uint32_t n)
{
    const int k = (int)(80.0 * families_uniform()) - 40;
    const double power = ldexp(1.0, k);
    pov_reader *in = fake_reader_create();
    void *self = fake_reader_memory(in, h->shape[p->kind]->instance_size);
    pov_crossing there[8];
    uint32_t m = 0, decided, i;
    probe q = *p;

    probe_scale(&q, power);
    if (probe_make(&q, h->shape[p->kind], in, self))
        m = ask(h->shape[p->kind], self, &q.ray, false, there, &decided);
    fake_reader_destroy(in);
    for (i = 0; i < n; i++) {
        /* Low parts that would be denormal are rounded, and distances can leave the range of doubles. */
        const double t = fabs(at[i].t * power);

        if (t < 1e-270 || t > 1e290)
            return true;
    }
    for (i = 0; i < n && m == n; i++) {
        if (there[i].t != at[i].t * power || there[i].t_lo != at[i].t_lo * power)
            return false;
    }
    return m == n;
}

/* ---- a probe, a family ---- */

static void judge(harness *h, const probe *p, const void *self, score *s)
{
    const pov_shape_class *shape = h->shape[p->kind];
    pov_crossing at[8];
    uint32_t n, decided, i;
    exact_answer e;

    real_reset();
    probe_exact(p, &e);
    if (!keep_positive(&e, p)) {
        s->rejected++;
        return;
    }
    s->rays++;
    n = ask(shape, self, &p->ray, false, at, &decided);
    s->decided += decided > 0;
    if (n != (uint32_t)e.count) {
        s->miss_false += n < (uint32_t)e.count;
        s->hit_false += n > (uint32_t)e.count;
        complain(h, p, n < (uint32_t)e.count ? "missed" : "hit nothing", s);
        return;
    }
    for (i = 0; i < n; i++)
        compare_one(h, p, self, &e.at[i], &at[i], s);
    /* At a rim, where two crossings are as good as one, no name can tell them apart. */
    if (n == 1 || (n == 2 && (at[1].t - at[0].t) * pov_dot(pov_unit(p->ray.dir), p->ray.dir) > 1e-6 * p->size))
        spawn(h, p, self, &at[(uint32_t)(n * families_uniform())], s);
    if (s->rays % 8 == 0 && ask(shape, self, &p->ray, true, at, &decided) != n) {
        s->exact_differs++;
        complain(h, p, "always_exact differs", s);
    }
    ask(shape, self, &p->ray, false, at, &decided);
    if (s->rays % 8 == 4 && !scales(h, p, at, n)) {
        s->scale_differs++;
        complain(h, p, "scaled differs", s);
    }
}

static double seconds(void)
{
    struct timespec t;

    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* The nearest crossing for the whole batch, several times; the median of the rounds counts. */
static void time_batch(harness *h, const pov_shape_class *shape)
{
    int round, i;

    for (round = 0; round < ROUNDS && h->made; round++) {
        const double start = seconds();

        for (i = 0; i < h->made; i++) {
            pov_crossing at;
            pov_hits hits = { 0.0, HUGE_VAL, POV_WANT_NEAREST, false, OWNER, 0, 1, 0, &at, NULL, NULL, false };

            shape->intersect(instance(h, i), &h->probes[i].ray, &hits);
        }
        if (round > 0)
            keep(&h->times, &h->time_count, &h->time_capacity, (seconds() - start) / h->made * 1e9);
    }
}

static int order(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double quantile(const double *sorted, long n, double q)
{
    return n ? sorted[(long)(q * (double)(n - 1))] : 0.0;
}

static void begin(harness *h, score *out)
{
    memset(out, 0, sizeof *out);
    h->count = h->time_count = 0;
    h->printed = 0;
}

static void finish(harness *h, score *out)
{
    if (h->count)
        qsort(h->ulps, (size_t)h->count, sizeof *h->ulps, order);
    if (h->time_count)
        qsort(h->times, (size_t)h->time_count, sizeof *h->times, order);
    out->ulp_median = quantile(h->ulps, h->count, 0.5);
    out->ulp_p99 = quantile(h->ulps, h->count, 0.99);
    out->ns_median = quantile(h->times, h->time_count, 0.5);
    out->ns_iqr = quantile(h->times, h->time_count, 0.75) - quantile(h->times, h->time_count, 0.25);
}

void harness_run(harness *h, kind k, const family *f, long rays, uint64_t seed, score *out)
{
    long asked = 0;

    families_seed(seed);
    begin(h, out);
    while (asked < rays) {
        h->in = fake_reader_create();
        if (!h->in)
            abort();
        for (h->made = 0; h->made < BATCH && asked < rays; asked++) {
            probe *p = &h->probes[h->made];

            memset(p, 0, sizeof *p);
            p->kind = k;
            f->make(p, f->parameter);
            if (isfinite(pov_dot(pov_unit(p->ray.dir), p->ray.dir))
                && probe_make(p, h->shape[k], h->in, instance(h, h->made)))
                judge(h, p, instance(h, h->made++), out);
            else
                out->rejected++;
        }
        time_batch(h, h->shape[k]);
        fake_reader_destroy(h->in);
    }
    finish(h, out);
}

void harness_replay(harness *h, const probe *p, score *out)
{
    begin(h, out);
    h->in = fake_reader_create();
    if (!h->in)
        abort();
    if (probe_make(p, h->shape[p->kind], h->in, instance(h, BATCH - 1)))
        judge(h, p, instance(h, BATCH - 1), out);
    else
        out->rejected++;
    fake_reader_destroy(h->in);
    finish(h, out);
}
