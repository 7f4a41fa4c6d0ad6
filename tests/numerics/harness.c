#include "numerics/harness.h"

#include "numerics/leaving.h"
#include "support/fake_reader.h"

#include <povtrace/exact.h>

#include <float.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { BATCH = 256, ROUNDS = 9, ALIGNMENT = 64 };

typedef struct list { double *values; long count, capacity; } list;

/* A method at work. */
typedef struct contender {
    const method *how;
    const shape_class *shape[KINDS];
    score *score;
    list ulps, times;
    char *memory;               /* one batch of instances side by side */
    bool parsed[BATCH];
    pov_crossing at[CROSSINGS_MAX];   /* of the probe at hand */
    uint32_t found;
} contender;

struct harness {
    contender contenders[METHODS_MAX];
    int count;
    int printed;
    pov_reader *in;
    size_t stride;
    probe probes[BATCH];
    int made;
    bool replays;                /* every check is made for the ray */
};

static void load_shapes(contender *c)
{
    char path[1024];
    int k;

    for (k = 0; k < KINDS; k++) {
        snprintf(path, sizeof path, "%s/%s/%s.so", TEST_BUILD, c->how->folder, probe_keyword((kind)k));
        c->shape[k] = fake_reader_load(path);
        if (!c->shape[k] && k <= POLYGON)   /* other methods have no more kinds */
            abort();
    }
}

harness *harness_create(const method *methods, int count)
{
    harness *h = calloc(1, sizeof *h);
    size_t largest = 0;
    int i, k;

    if (!h || count > METHODS_MAX)
        abort();
    h->count = count;
    for (i = 0; i < count; i++) {
        h->contenders[i].how = &methods[i];
        load_shapes(&h->contenders[i]);
        for (k = 0; k < KINDS; k++) {
            const size_t size = h->contenders[i].shape[k] ? h->contenders[i].shape[k]->instance_size : 0;
            largest = size > largest ? size : largest;
        }
    }
    h->stride = (largest + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
    for (i = 0; i < count; i++) {
        h->contenders[i].memory = malloc(h->stride * (BATCH + 1));
        if (!h->contenders[i].memory)
            abort();
    }
    return h;
}

void harness_destroy(harness *h)
{
    int i;

    for (i = 0; i < h->count; i++) {
        free(h->contenders[i].ulps.values);
        free(h->contenders[i].times.values);
        free(h->contenders[i].memory);
    }
    free(h);
    real_free_all();
}

static void *instance(const harness *h, const contender *c, int i)
{
    const uintptr_t start = (uintptr_t)c->memory, aligned = (start + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
    return c->memory + (aligned - start) + h->stride * (size_t)i;
}

static subject subject_of(const harness *h, const contender *c, kind k, int slot)
{
    subject s;

    s.shape = c->shape[k];
    s.self = instance(h, c, slot);
    s.always_exact = c->how->always_exact;
    return s;
}

static void keep(list *l, double value)
{
    if (l->count == l->capacity) {
        l->capacity = l->capacity ? 2 * l->capacity : 1024;
        l->values = realloc(l->values, (size_t)l->capacity * sizeof *l->values);
        if (!l->values)
            abort();
    }
    l->values[l->count++] = value;
}

static void complain(harness *h, const contender *c, const probe *p, const char *what)
{
    char line[4096];

    if (c->how->rival && c->score->worst[0])
        return;
    probe_write(p, line, sizeof line);
    if (!c->how->rival && h->printed++ < 8)
        fprintf(stderr, "%s, %s: %s\n", c->how->name, what, line);
    if (!c->score->worst[0])
        snprintf(c->score->worst, sizeof c->score->worst, "%s", line);
}

/* ---- one question ---- */

static void compare_normal(harness *h, contender *c, const probe *p, int slot, const exact_crossing *e,
                           const pov_crossing *at)
{
    score *s = c->score;
    pov_vec3 n;
    double turn;

    c->shape[p->kind]->normal(instance(h, c, slot), &p->ray, at, &n);
    /* A polygon has no outside: its normal may point either way. */
    if (kind_is_planar(p->kind) && n.x * e->normal[0] + n.y * e->normal[1] + n.z * e->normal[2] < 0.0)
        n = pov_scale(n, -1.0);
    turn = fmax(fabs(n.x - e->normal[0]), fmax(fabs(n.y - e->normal[1]), fabs(n.z - e->normal[2])));
    /* So near to an apex not even a distance in double-double tells where around it: any normal will do. */
    if (isnan(e->normal[0]) || e->clearance < 1e-15 * p->size)
        turn = 0.0;
    if (!(turn <= 1e-13))
        complain(h, c, p, "normal");
    if (isnan(n.x) || fabs(pov_dot(n, n) - 1.0) > 8.0 * DBL_EPSILON) {
        complain(h, c, p, "normal not unit");
        turn = HUGE_VAL;
    }
    s->normal_max = fmax(s->normal_max, turn);
}

static void compare_one(harness *h, contender *c, const probe *p, int slot, const exact_crossing *e,
                        const pov_crossing *at)
{
    double off = probe_ulps_off(e->t, at->t);
    const double point = fabs(real_double(real_sub(e->t, real_of2(at->t, at->t_lo)))) * probe_speed(p) / p->size;
    score *s = c->score;

    /* Of a torus that the ray starts so near to, the distance is only good to a part of the size. */
    if (p->kind == TORUS && at->t * probe_speed(p) < 1e-6 * p->size && point < 0x1p-44)
        off = 0.0;
    s->crossings++;
    if (e->feature != at->mark.feature) {
        s->part_false++;
        complain(h, c, p, "wrong part");
    }
    keep(&c->ulps, off);
    if (!(off <= s->ulp_max)) {
        s->ulp_max = off;
        if (!(off <= probe_limit(p->kind)))
            complain(h, c, p, "distance");
    }
    s->point_max = fmax(s->point_max, point);
    compare_normal(h, c, p, slot, e, at);
}

/* Low parts that would be denormal are rounded: of a direction with a denormal component, at any distance. */
static bool is_same_low(double a, double b, double power) { return fabs(a - b) <= DBL_MIN * fmax(1.0, power); }

/* Everything 2^k times as large gives the same bits 2^k times as large. */
static bool scales(const contender *c, const probe *p, int k)
{
    const double power = ldexp(1.0, k);
    const shape_class *shape = c->shape[p->kind];
    pov_reader *in = fake_reader_create();
    void *self = fake_reader_memory(in, shape->instance_size);
    const subject larger = { shape, self, c->how->always_exact };
    pov_crossing there[CROSSINGS_MAX];
    uint32_t m = 0, escalated, i;
    probe q = *p;

    probe_scale(&q, power);
    if (probe_make(&q, shape, in, self))
        m = subject_ask(&larger, &q.ray, there, &escalated);
    fake_reader_destroy(in);
    for (i = 0; i < c->found; i++) {
        /* Distances can leave the range of doubles. */
        const double t = fabs(c->at[i].t * power);

        if (t < 1e-270 || t > 1e290)
            return true;
    }
    for (i = 0; i < c->found && m == c->found; i++) {
        if (there[i].t != c->at[i].t * power || !is_same_low(there[i].t_lo, c->at[i].t_lo * power, power))
            return false;
    }
    return m == c->found;
}

/* By a power drawn by chance, or by all that may be drawn. */
static bool scales_by_any(const harness *h, const contender *c, const probe *p)
{
    int k;

    if (!h->replays)
        return scales(c, p, (int)(80.0 * families_uniform()) - 40);
    for (k = -40; k < 40; k++)
        if (!scales(c, p, k))
            return false;
    return true;
}

/* Checks made for every eighth ray only, and for all that are replayed. */
static void judge_more(harness *h, contender *c, const probe *p, int slot)
{
    subject s = subject_of(h, c, p->kind, slot);
    pov_crossing at[CROSSINGS_MAX];
    uint32_t escalated;

    s.always_exact = true;
    if ((h->replays || c->score->rays % 8 == 0) && subject_ask(&s, &p->ray, at, &escalated) != c->found) {
        c->score->exact_differs++;
        complain(h, c, p, "always_exact differs");
    }
    if ((h->replays || c->score->rays % 8 == 4) && !scales_by_any(h, c, p)) {
        c->score->scale_differs++;
        complain(h, c, p, "scaled differs");
    }
}

static void judge_one(harness *h, contender *c, const probe *p, int slot, const exact_result *e)
{
    const subject s = subject_of(h, c, p->kind, slot);
    uint32_t escalated, i;

    c->score->rays++;
    c->found = subject_ask(&s, &p->ray, c->at, &escalated);
    c->score->escalated += escalated > 0;
    if (c->found != (uint32_t)e->count) {
        c->score->miss_false += c->found < (uint32_t)e->count;
        c->score->hit_false += c->found > (uint32_t)e->count;
        complain(h, c, p, c->found < (uint32_t)e->count ? "missed" : "hit nothing");
        return;
    }
    for (i = 0; i < c->found; i++)
        compare_one(h, c, p, slot, &e->at[i], &c->at[i]);
}

/* A ray leaves the surface from ours' crossing `i`, exactly judged; from the others' own they meet as much, or not. */
static void spawn(harness *h, const probe *p, int slot, uint32_t i, uint32_t found)
{
    const double speed = probe_speed(p);
    pov_vec3 normal, direction = { 0.0, 0.0, 0.0 };
    int expected = 0, j;

    for (j = 0; j < h->count; j++) {
        contender *c = &h->contenders[j];
        const subject s = subject_of(h, c, p->kind, slot);
        leaving_verdict verdict;
        probe q = *p;

        if (!c->parsed[slot] || c->found != found)
            continue;
        if (j == 0) {
            c->shape[p->kind]->normal(s.self, &p->ray, &c->at[i], &normal);
            direction = leaving_direction(normal);
        }
        q.ray = leaving_ray(&p->ray, &c->at[i], direction);
        if (c->how->rival) {
            pov_crossing at[CROSSINGS_MAX];
            uint32_t escalated, n = subject_ask(&s, &q.ray, at, &escalated);

            verdict = n == (uint32_t)expected ? LEFT_WELL : n > (uint32_t)expected ? HIT_ITSELF : LEAKED;
        } else {
            verdict = leaving_judge(&s, &q, &c->at[i], c->at[i].t * speed, normal, &expected);
        }
        if (j == 0 && verdict == NOT_JUDGED)
            return;
        c->score->spawned += verdict != NOT_JUDGED;
        c->score->selfhit += verdict == HIT_ITSELF;
        c->score->leak += verdict == LEAKED || verdict == MISPLACED;
        if (verdict == HIT_ITSELF)
            complain(h, c, p, "met itself after");
        else if (verdict == LEAKED || verdict == MISPLACED)
            complain(h, c, p, verdict == LEAKED ? "leaked after" : "other side misplaced after");
    }
}

/* ---- a probe, a family ---- */

static bool are_apart(const contender *c, const probe *p)
{
    for (uint32_t i = 1; i < c->found; i++)
        if (!((c->at[i].t - c->at[i - 1].t) * probe_speed(p) > 1e-6 * p->size))
            return false;
    return true;
}

static void judge(harness *h, const probe *p, int slot)
{
    contender *ours = &h->contenders[0];
    exact_result e;
    int i;

    real_reset();
    probe_exact(p, &e);
    if (!probe_keep_positive(&e, p)) {
        for (i = 0; i < h->count; i++)
            h->contenders[i].score->rejected++;
        return;
    }
    for (i = 0; i < h->count; i++) {
        if (h->contenders[i].parsed[slot])
            judge_one(h, &h->contenders[i], p, slot, &e);
    }
    if (ours->found != (uint32_t)e.count)
        return;
    /* At a rim, where two crossings are as good as one, no name can tell them apart; but those of boxes do. */
    if (ours->found > 0 && (p->kind == BOX || are_apart(ours, p)))
        spawn(h, p, slot, (uint32_t)(ours->found * families_uniform()), ours->found);
    judge_more(h, ours, p, slot);
}

static double seconds(void)
{
    struct timespec t;

    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Nanoseconds a ray for the nearest crossing of each probe of the batch. */
static double time_round(const harness *h, const contender *c)
{
    const double start = seconds();
    int i;

    for (i = 0; i < h->made; i++) {
        const shape_class *shape = c->shape[h->probes[i].kind];
        pov_crossing at;
        pov_hits hits = { 0.0, HUGE_VAL, POV_WANT_NEAREST, c->how->always_exact, false, OWNER, 0, 1, 0, &at, NULL, NULL, false, NULL, 0.0, false, c->how->always_exact };

        shape->intersect(instance(h, c, i), &h->probes[i].ray, &hits);
    }
    return (seconds() - start) / h->made * 1e9;
}

/* Several rounds, the methods in turn in each; the first round warms up. */
static void time_batch(harness *h)
{
    int round, i;

    for (round = 0; round < ROUNDS && h->made; round++) {
        for (i = 0; i < h->count; i++) {
            const double ns = time_round(h, &h->contenders[i]);

            if (round > 0)
                keep(&h->contenders[i].times, ns);
        }
    }
}

static int order(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double quantile(const list *sorted, double q)
{
    return sorted->count ? sorted->values[(long)(q * (double)(sorted->count - 1))] : 0.0;
}

static void begin(harness *h, score *out)
{
    int i;

    h->in = fake_reader_create();
    if (!h->in)
        abort();
    h->printed = 0;
    for (i = 0; i < h->count; i++) {
        contender *c = &h->contenders[i];

        memset(&out[i], 0, sizeof out[i]);
        c->score = &out[i];
        c->ulps.count = c->times.count = 0;
    }
}

static void finish(harness *h)
{
    int i;

    for (i = 0; i < h->count; i++) {
        contender *c = &h->contenders[i];

        if (c->ulps.count)
            qsort(c->ulps.values, (size_t)c->ulps.count, sizeof *c->ulps.values, order);
        if (c->times.count)
            qsort(c->times.values, (size_t)c->times.count, sizeof *c->times.values, order);
        c->score->ulp_median = quantile(&c->ulps, 0.5);
        c->score->ulp_p99 = quantile(&c->ulps, 0.99);
        c->score->ns_median = quantile(&c->times, 0.5);
        c->score->ns_iqr = quantile(&c->times, 0.75) - quantile(&c->times, 0.25);
    }
    fake_reader_destroy(h->in);
}

/* The shape for every method; false where ours refuses it. */
static bool make_instances(harness *h, const probe *p, int slot)
{
    int i;

    for (i = 0; i < h->count; i++) {
        contender *c = &h->contenders[i];

        c->parsed[slot] = c->shape[p->kind] && probe_make(p, c->shape[p->kind], h->in, instance(h, c, slot));
        c->score->rejected += !c->parsed[slot];
    }
    return h->contenders[0].parsed[slot];
}

void harness_run(harness *h, kind k, const family *f, long rays, uint64_t seed, score *out)
{
    long asked = 0;

    families_seed(seed);
    begin(h, out);
    while (asked < rays) {
        for (h->made = 0; h->made < BATCH && asked < rays; asked++) {
            probe *p = &h->probes[h->made];

            memset(p, 0, sizeof *p);
            p->kind = k;
            f->make(p, f->parameter);
            if (!isfinite(probe_speed(p)))
                out[0].rejected++;
            else if (make_instances(h, p, h->made))
                judge(h, p, h->made++);
        }
        time_batch(h);
        fake_reader_destroy(h->in);
        h->in = fake_reader_create();
        if (!h->in)
            abort();
    }
    finish(h);
}

void harness_replay(harness *h, const probe *p, score *out)
{
    begin(h, out);
    h->replays = true;
    if (make_instances(h, p, 0))
        judge(h, p, 0);
    h->replays = false;
    finish(h);
}
