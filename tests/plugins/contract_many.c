/* contract_many.c - many rays or crossings at once get the answers that each gets alone. */
#include "plugins/contract.h"
#include "plugins/subject.h"

#include "support/check.h"

#include <math.h>
#include <string.h>

enum { PACKET = 37 };

/* To which side a ray goes from the crossing that it starts on, where that is no matter of rounding. */
static void name_side(const thing *t, pov_ray *ray, const pov_crossing *from)
{
    pov_vec3 normal;
    double rise;

    subject.shape->normal(t->self, ray, from, &normal);
    rise = pov_dot(normal, pov_unit(ray->dir));
    if (fabs(rise) > 1e-6)
        ray->origin_mark.flags |= rise > 0.0 ? POV_MARK_OUTWARD : POV_MARK_INWARD;
}

/* Rays of all kinds: from far and near, from the surface itself, with zeros of both signs, absurdly large and small. */
static pov_ray any_ray(const thing *t)
{
    const double luck = subject_uniform();
    pov_ray ray = subject_ray(t);
    pov_crossing at[MOST];
    const uint32_t n = subject_ask(t->self, &ray, at);

    if (n > 0 && luck < 0.4) {
        const uint32_t which = (uint32_t)(n * subject_uniform());

        subject_point(&ray, at[which].t, at[which].t_lo, &ray.org, &ray.org_lo);
        ray.dir = subject_direction();
        ray.origin_surface = OWNER;
        ray.origin_mark = at[which].mark;
        if (luck < 0.3)
            name_side(t, &ray, &at[which]);
    } else if (luck < 0.5) {
        ray.dir.x = luck < 0.45 ? 0.0 : -0.0;
    } else if (luck < 0.6) {
        ray.dir = pov_scale(ray.dir, luck < 0.53 ? 1e-280 : luck < 0.56 ? 1e250 : 5e-324);
    } else if (luck < 0.65) {
        ray.org = pov_scale(ray.org, luck < 0.63 ? 1e180 : 1e-300);
    }
    return ray;
}

static pov_hits any_question(const thing *t, const pov_ray *ray, pov_crossing *at)
{
    const double scale = t->size / fmax(pov_largest(ray->dir), 1e-300);
    pov_hits hits;

    memset(&hits, 0, sizeof hits);
    hits.want = subject_uniform() < 0.2 ? POV_WANT_ANY : POV_WANT_NEAREST;
    hits.tmin = subject_uniform() < 0.8 ? 0.0 : scale * subject_uniform();
    hits.tmax = subject_uniform() < 0.5 ? HUGE_VAL : hits.tmin + 20.0 * scale * subject_uniform();
    hits.always_exact = subject_uniform() < 0.02;
    hits.unfiltered = hits.always_exact && subject_uniform() < 0.5;
    hits.owner = OWNER;
    hits.capacity = 1;
    hits.at = at;
    memset(at, 0, sizeof *at);
    return hits;
}

/* A crossing of another object's is there already. Not where distances are beyond all doubles: any is a tie with those. */
static void find_other(const thing *t, const pov_ray *ray, pov_hits *hits)
{
    const double scale = t->size / fmax(pov_largest(ray->dir), 1e-300), at = hits->tmin + 10.0 * scale * subject_uniform();

    if (hits->want != POV_WANT_NEAREST || !(at > hits->tmin && at < fmin(hits->tmax, 1e100)))
        return;
    hits->at->t = at;
    hits->at->owner = OWNER - 1;
    hits->count = 1;
    hits->tmax = at + POV_COINCIDENT * at;
}

/* Where any crossing will do, it may be another one. A single ray may escalate for one that turns out not to count. */
static bool same_result(const pov_hits *one, const pov_hits *many)
{
    return one->count == many->count && many->escalated <= one->escalated && one->tied == many->tied &&
           (one->want == POV_WANT_ANY || memcmp(&one->tmax, &many->tmax, sizeof one->tmax) == 0) &&
           (one->want == POV_WANT_ANY || one->count == 0 || memcmp(one->at, many->at, sizeof *one->at) == 0);
}

/* Pairs of a thing and a ray, their questions, and what is there. */
typedef struct packet {
    const void *selves[PACKET];
    const pov_ray *rays[PACKET];
    pov_ray ray[PACKET];
    pov_hits hits[2][PACKET];
    pov_crossing at[2][PACKET];
} packet;

/* Of one thing, or of any. others: some rays have found another object before. */
static void gather(packet *c, uint32_t n, bool others)
{
    const bool alike = subject_uniform() < 0.5;
    const thing *t = NULL;
    uint32_t i;

    for (i = 0; i < n; i++) {
        if (!t || !alike)
            t = &subject.things[(int)(subject.count * subject_uniform())];

        c->selves[i] = t->self;
        c->ray[i] = any_ray(t);
        c->rays[i] = &c->ray[i];
        c->hits[0][i] = any_question(t, &c->ray[i], &c->at[0][i]);
        if (others && subject_uniform() < 0.3)
            find_other(t, &c->ray[i], &c->hits[0][i]);
        c->hits[1][i] = c->hits[0][i];
        c->hits[1][i].at = &c->at[1][i];
        c->hits[0][i].scratch = c->hits[1][i].scratch = subject_scratch(t->self);
        c->at[1][i] = c->at[0][i];
        subject.shape->intersect(t->self, &c->ray[i], &c->hits[0][i]);
    }
}

void many_rays_get_the_results_of_single_ones(void **unused)
{
    static packet c;
    int round, broken = 0;

    (void)unused;
    if (!HAS(intersect_many))
        subject_skip("has no intersect_many");
    for (round = 0; round < 3000; round++) {
        const uint32_t n = 1 + (uint32_t)(PACKET * subject_uniform());
        pov_hits *hits[PACKET];
        uint32_t i;

        gather(&c, n, true);
        for (i = 0; i < n; i++)
            hits[i] = &c.hits[1][i];
        subject.shape->intersect_many(c.selves, c.rays, hits, n);
        for (i = 0; i < n; i++)
            broken += !same_result(&c.hits[0][i], &c.hits[1][i]);
    }
    assert_int_equal(broken, 0);
}

static bool same_crossings(const pov_hits *one, const pov_hits *many)
{
    return one->count == many->count && many->escalated <= one->escalated && memcmp(one->at, many->at, one->count * sizeof *one->at) == 0;
}

void many_rays_get_all_crossings_that_single_ones_get(void **unused)
{
    static pov_crossing at[2][PACKET][MOST];
    static packet c;
    int broken = 0, crossings = 0;

    (void)unused;
    if (!HAS(intersect_many))
        subject_skip("has no intersect_many");
    for (int round = 0; round < 1000; round++) {
        const uint32_t n = 1 + (uint32_t)(PACKET * subject_uniform());
        pov_hits *hits[PACKET];

        gather(&c, n, false);
        memset(at, 0, sizeof at);
        for (uint32_t i = 0; i < n; i++) {
            for (int k = 0; k < 2; k++) {
                pov_hits *h = &c.hits[k][i];

                h->want = POV_WANT_ALL;
                h->count = h->escalated = 0;
                h->tied = false;
                h->tmax = round % 2 ? HUGE_VAL : c.hits[0][i].tmax;
                h->capacity = MOST;
                h->at = at[k][i];
            }
            hits[i] = &c.hits[1][i];
            subject.shape->intersect(c.selves[i], c.rays[i], &c.hits[0][i]);
            crossings += (int)c.hits[0][i].count;
        }
        subject.shape->intersect_many(c.selves, c.rays, hits, n);
        for (uint32_t i = 0; i < n; i++)
            broken += !same_crossings(&c.hits[0][i], &c.hits[1][i]);
    }
    assert_true(crossings > 1000);
    assert_int_equal(broken, 0);
}

void many_normals_are_those_of_single_ones(void **unused)
{
    static packet c;
    int round, broken = 0, seen = 0;

    (void)unused;
    if (!HAS(normal_many))
        subject_skip("has no normal_many");
    for (round = 0; round < 3000; round++) {
        const pov_crossing *at[PACKET];
        pov_vec3 normal[PACKET], *out[PACKET];
        uint32_t i, n = 0;

        gather(&c, PACKET, false);
        for (i = 0; i < PACKET; i++) {
            if (c.hits[0][i].count == 0)
                continue;
            c.selves[n] = c.selves[i];
            c.rays[n] = c.rays[i];
            at[n] = &c.at[0][i];
            out[n] = &normal[n];
            n++;
        }
        if (n == 0)
            continue;
        seen += (int)n;
        subject.shape->normal_many(c.selves, c.rays, at, out, n);
        for (i = 0; i < n; i++) {
            pov_vec3 one;

            subject.shape->normal(c.selves[i], c.rays[i], at[i], &one);
            broken += memcmp(&one, &normal[i], sizeof one) != 0;
        }
    }
    assert_true(seen > 1000);
    assert_int_equal(broken, 0);
}

/* A point as the contract has it: with its low part, and with memory behind both. */
typedef struct place { pov_vec3 point[2]; double behind[2]; } place;

/* Crossings of moderate rays, whose points say where they are. Returns their number. */
static uint32_t find_places(packet *c, place *places)
{
    uint32_t n = 0;

    memset(places, 0, PACKET * sizeof *places);
    gather(c, PACKET, false);
    for (uint32_t i = 0; i < PACKET; i++) {
        const double size = pov_largest(c->ray[i].dir), from = pov_largest(c->ray[i].org);

        if (c->hits[0][i].count == 0 || !(size > 1e-50 && size < 1e50) || !(from < 1e50))
            continue;
        subject_point(&c->ray[i], c->at[0][i].t, c->at[0][i].t_lo, &places[n].point[0], &places[n].point[1]);
        c->selves[n] = c->selves[i];
        c->rays[n] = c->rays[i];
        c->at[1][n++] = c->at[0][i];
    }
    return n;
}

void many_shading_normals_are_those_of_single_ones(void **unused)
{
    static packet c;
    int broken = 0, seen = 0;

    (void)unused;
    if (!HAS(shading_normals_many))
        subject_skip("has no shading_normals_many");
    for (int round = 0; round < 3000; round++) {
        place places[PACKET];
        pov_vec3 point[PACKET], low[PACKET], normal[PACKET], one[POV_NORMALS_MAX];
        const pov_mark *marks[PACKET];
        uint32_t count[PACKET];
        const uint32_t n = find_places(&c, places);

        for (uint32_t i = 0; i < n; i++) {
            point[i] = places[i].point[0];
            low[i] = places[i].point[1];
            marks[i] = &c.at[1][i].mark;
        }
        if (n > 0)
            subject.shape->shading_normals_many(c.selves, point, low, marks, n, normal, count);
        for (uint32_t i = 0; i < n; i++) {
            double share[POV_NORMALS_MAX];
            const uint32_t alone = subject.shape->shading_normals(c.selves[i], point[i], low[i], marks[i], one, share);

            broken += alone != count[i] || (alone > 0 && (share[0] != 1.0 || memcmp(&one[0], &normal[i], sizeof one[0]) != 0));
            seen += alone > 0;
        }
    }
    assert_true(seen > 1000);
    assert_int_equal(broken, 0);
}

static bool are_near(pov_vec3 a, pov_vec3 b)
{
    return pov_largest(pov_sub(a, b)) <= 0x1p-51;
}

void normals_at_points_are_those_of_rays(void **unused)
{
    static packet c;
    int round, off = 0, other = 0, seen = 0;

    (void)unused;
    if (!HAS(normal_at_many))
        subject_skip("has no normal_at_many");
    for (round = 0; round < 3000; round++) {
        place places[PACKET];
        const pov_vec3 *points[PACKET];
        pov_vec3 normal[PACKET], *out[PACKET];
        const uint32_t n = find_places(&c, places);

        for (uint32_t i = 0; i < n; i++) {
            points[i] = places[i].point;
            out[i] = &normal[i];
        }
        if (n > 0)
            subject.shape->normal_at_many(c.selves, points, out, n);
        for (uint32_t i = 0; i < n; i++) {
            pov_vec3 by_ray, one, *const to = &one;

            subject.shape->normal(c.selves[i], c.rays[i], &c.at[1][i], &by_ray);
            subject.shape->normal_at_many(&c.selves[i], &points[i], &to, 1);
            off += !are_near(by_ray, normal[i]);
            other += memcmp(&one, &normal[i], sizeof one) != 0;
        }
        seen += (int)n;
    }
    assert_true(seen > 1000);
    assert_int_equal(off, 0);
    assert_int_equal(other, 0);
}
