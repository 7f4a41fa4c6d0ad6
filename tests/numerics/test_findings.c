/* test_findings.c - N1 to N7: the families of rays by which an attack from outside found faults, through the library's own
 * calls, against 512 bits.
 *
 * Without arguments a short run. test_findings RAYS [NAME [KIND]]: so many rays for every family and kind, or for those
 * whose name begins so. */
#include "numerics/findings.h"
#include "numerics/leaving.h"
#include "numerics/real_map.h"

#include "support/check.h"
#include "support/scenes.h"

#include <povtrace/povtrace.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { RAYS_OF_A_SCENE = 16, SEED = 20261125 };

static long rays_wanted = 300;
static const char *only = "", *only_kind = "";

typedef struct tally {
    long judged, open, wrong;           /* open: nearer to a tie than what is promised, or not what the family is of */
    double ulps, far_ulps, part;        /* far: from 1e-6 sizes off; the part of the size, in 2^-44 */
    double beyond;                      /* the least of both over its limit */
    double normal;
} tally;

/* ---- the question as a scene ---- */

static char *put_vector(char *at, const double *v) { return at + sprintf(at, "<%.17g,%.17g,%.17g>", v[0], v[1], v[2]); }

/* Of all kinds of triangles. */
static char *put_corners(char *at, const probe *p)
{
    double normal[3];
    int i;

    probe_flat_normal(p, normal);
    for (i = 1; i < 10; i += 3) {
        at = put_vector(at, p->number + i);
        if (p->kind == SMOOTH_TRIANGLE)
            at = put_vector(at, normal);
    }
    return at;
}

static char *put_shape(char *at, const probe *p)
{
    static const char *const forms[KINDS] = { "vn", "vv", "vnvn", "vvn", "vvvn", "n", "", "", "", "nn", "vn", "vvnn" };
    const char *form;
    int i = 0;

    at += sprintf(at, "%s { ", p->kind == MESH ? "mesh { triangle" : probe_keyword(p->kind));
    for (form = forms[p->kind]; *form; form++) {
        at += sprintf(at, i ? ", " : "");
        at = *form == 'v' ? put_vector(at, p->number + i) : at + sprintf(at, "%.17g", p->number[i]);
        i += *form == 'v' ? 3 : 1;
    }
    if (kind_has_corners(p->kind) && p->kind != POLYGON)
        at = put_corners(at, p);
    for (; p->kind == POLYGON && i < p->count; i += 3)
        at = put_vector(at + sprintf(at, ", "), p->number + i);
    return at + sprintf(at, "%s%s", p->open ? " open" : "", p->kind == MESH ? " }" : "");
}

static void put_scene(char *at, const question *q, double wall)
{
    int i;

    at = put_shape(at + sprintf(at, "#version 3.7; "), &q->p);
    if (q->mapped) {
        at += sprintf(at, " matrix <");
        for (i = 0; i < MATRIX; i++)
            at += sprintf(at, "%s%.17g", i ? "," : "", q->matrix[i]);
        at += sprintf(at, ">");
    }
    at += sprintf(at, " }");
    if (wall != 0.0)
        sprintf(at, " plane { z, %.17g pigment { rgb 1 } finish { ambient 0 diffuse 1 } } light_source { <%.17g,%.17g,%.17g> rgb 1 }",
                wall, q->to.x, q->to.y, q->to.z);
}

/* ---- the exact answer ---- */

static real3 real3_point(pov_vec3 v) { return real3_of(real_of(v.x), real_of(v.y), real_of(v.z)); }

static void map_of(const question *q, real_map *f)
{
    int i, j;

    for (i = 0; i < 3; i++)
        for (j = 0; j < 4; j++)
            f->m[i][j] = q->mapped ? real_of(q->matrix[3 * j + i]) : real_of(i == j);
    real_map_invert(f);
}

/* All crossings of the line through `org` along `dir` in the world. */
static void exact_line(question *q, real_map *f, real3 org, real3 dir, exact_result *out)
{
    real3 o = org, d = dir;

    map_of(q, f);
    if (q->mapped) {
        o = real_times(f->inverse, real3_sub(org, real3_of(f->m[0][3], f->m[1][3], f->m[2][3])));
        d = real_times(f->inverse, dir);
    }
    /* In the shape's own space; the exact answer looks along its largest component. */
    q->p.ray.dir = pov_vec3_of(real_double(d.x), real_double(d.y), real_double(d.z));
    probe_exact_line(&q->p, o, d, out);
}

/* An inverse map is rounded to 512 bits; roots of a torus are found to 2^-300 of its size. */
static bool is_all_but_zero(const question *q, real a)
{
    return fabs(real_double(a)) < (q->p.kind == TORUS ? 0x1p-250 * q->p.size / sqrt(pov_dot(q->p.ray.dir, q->p.ray.dir)) : 0x1p-300);
}

/* Where the sign is a matter of less than what two parts hold. */
static bool is_open(const question *q, real a, double rise) { return !is_all_but_zero(q, a) && fabs(real_double(a)) * rise < 0x1p-90; }

/* The same at a segment's end, at a part of its length: heights over the surface below 2^-95 of the lengths involved are
 * taken for nothing. */
static bool is_end_open(const question *q, real a, double rise, double lengths)
{
    return !is_all_but_zero(q, a) && fabs(real_double(a)) * rise < 0x1.8p-95 * lengths;
}

static double rise_of(const question *q, const exact_crossing *e)
{
    const pov_vec3 d = pov_unit(q->p.ray.dir);

    return fabs(e->normal[0] * d.x + e->normal[1] * d.y + e->normal[2] * d.z);
}

/* ---- judging ---- */

static void complain(const question *q, const char *scene, const pov_ray *ray, const char *what, tally *out)
{
    if (out->wrong++ < 3)
        print_error("%s: %s\n    from %a %a %a along %a %a %a to %a %a %a\n", what, scene, ray->org.x, ray->org.y, ray->org.z,
                    ray->dir.x, ray->dir.y, ray->dir.z, q->to.x, q->to.y, q->to.z);
}

/* The normal in the world goes by the transposed inverse. */
static void world_normal(const real_map *f, const exact_crossing *e, real r[3])
{
    const real n[3] = { real_of(e->normal[0]), real_of(e->normal[1]), real_of(e->normal[2]) };
    real length;
    int i;

    for (i = 0; i < 3; i++)
        r[i] = real_add(real_add(real_mul(f->inverse[0][i], n[0]), real_mul(f->inverse[1][i], n[1])),
                        real_mul(f->inverse[2][i], n[2]));
    length = real_sqrt(real3_dot(real3_of(r[0], r[1], r[2]), real3_of(r[0], r[1], r[2])));
    for (i = 0; i < 3; i++)
        r[i] = real_div(r[i], length);
}

/* It may point to either side. */
static double normal_off(const real_map *f, const exact_crossing *e, pov_vec3 found)
{
    double side;
    real r[3];

    world_normal(f, e, r);
    side = found.x * real_double(r[0]) + found.y * real_double(r[1]) + found.z * real_double(r[2]) < 0.0 ? -1.0 : 1.0;
    return fmax(fabs(side * found.x - real_double(r[0])),
                fmax(fabs(side * found.y - real_double(r[1])), fabs(side * found.z - real_double(r[2]))));
}

static void measure(const question *q, const real_map *f, const exact_crossing *e, const pov_hit *hit, tally *out)
{
    const double speed = sqrt(pov_dot(q->p.ray.dir, q->p.ray.dir)), ulps = probe_ulps_off(e->t, hit->distance);
    const double off = fabs(real_double(real_sub(e->t, real_of(hit->distance)))) * speed / q->p.size * 0x1p44;

    out->ulps = fmax(out->ulps, ulps);
    out->part = fmax(out->part, off);
    if (hit->distance * speed > 1e-6 * q->p.size)
        out->far_ulps = fmax(out->far_ulps, ulps);
    out->beyond = fmax(out->beyond, fmin(ulps / probe_limit(q->p.kind), off));
    if (e->clearance > 1e-6 * q->p.size)
        out->normal = fmax(out->normal, normal_off(f, e, hit->normal));
}

static void judge_ray(pov_tracer *tracer, question *q, const char *scene, tally *out)
{
    const pov_ray ray = q->p.ray;
    const exact_crossing *first = NULL;
    pov_hit hit = POV_INIT(hit);
    exact_result e;
    real_map f;
    int i;

    exact_line(q, &f, real3_point(ray.org), real3_point(ray.dir), &e);
    for (i = 0; i < e.count; i++) {
        if (is_open(q, real_mul(e.at[i].t, real_of(sqrt(pov_dot(q->p.ray.dir, q->p.ray.dir)) / q->p.size)), rise_of(q, &e.at[i]))) {
            out->open++;
            return;
        }
        if (!first && real_sign(e.at[i].t) > 0 && !is_all_but_zero(q, e.at[i].t))
            first = &e.at[i];
    }
    out->judged++;
    if (pov_trace_hit(tracer, ray.org, ray.dir, &hit) != (first != NULL))
        complain(q, scene, &ray, first ? "missed" : "hit nothing", out);
    else if (first)
        measure(q, &f, first, &hit, out);
}

/* The cosine in the shape's own space or in the world, whichever is less: a shape may have absorbed its map or not. */
static double least_rise(const question *q, const real_map *f, const exact_crossing *e, pov_vec3 dir)
{
    const pov_vec3 d = pov_unit(dir);
    real r[3];

    world_normal(f, e, r);
    return fmin(rise_of(q, e), fabs(real_double(r[0]) * d.x + real_double(r[1]) * d.y + real_double(r[2]) * d.z));
}

/* Is anything between two points? Gives -1 where that is open. */
static int is_blocked(question *q, pov_vec3 from, pov_vec3 to)
{
    const real3 org = real3_point(from), dir = real3_sub(real3_point(to), org);
    const double lengths = 1.0 + (pov_largest(from) + q->p.size) / pov_largest(pov_sub(to, from));
    exact_result e;
    real_map f;
    int i, blocked = 0;

    exact_line(q, &f, org, dir, &e);
    for (i = 0; i < e.count; i++) {
        const real left = real_sub(e.at[i].t, real_of(1.0));

        /* A quadric that is all but a point is not of the size that it is taken for. */
        if (is_end_open(q, left, least_rise(q, &f, &e.at[i], pov_sub(to, from)), lengths) || is_open(q, e.at[i].t, rise_of(q, &e.at[i])) ||
            e.at[i].clearance < 1e-6 * q->p.size)
            return -1;
        if (real_sign(e.at[i].t) > 0 && !is_all_but_zero(q, e.at[i].t) && real_sign(left) < 0 && !is_all_but_zero(q, left))
            blocked = 1;
    }
    return blocked;
}

static void judge_segment(pov_tracer *tracer, question *q, const char *scene, tally *out)
{
    const pov_ray ray = q->p.ray;
    const int blocked = is_blocked(q, ray.org, q->to);

    if (blocked < 0) {
        out->open++;
        return;
    }
    out->judged++;
    if (pov_trace_blocked(tracer, ray.org, q->to) != (blocked > 0))
        complain(q, scene, &ray, blocked ? "free" : "blocked", out);
}

/* A point of the wall, seen from just before it. */
static void judge_light(pov_tracer *tracer, question *q, const char *scene, double wall, tally *out)
{
    const double reach = 64.0 * q->p.size;
    const pov_vec3 at = pov_vec3_of(q->to.x + reach * (2.0 * families_uniform() - 1.0),
                                    q->to.y + reach * (2.0 * families_uniform() - 1.0), wall);
    const pov_vec3 eye = pov_vec3_of(at.x, at.y, wall - q->p.size / 1024.0), z = { 0.0, 0.0, 1.0 };
    const int blocked = is_blocked(q, at, q->to);
    pov_hit hit = POV_INIT(hit);
    float rgba[4];

    if (blocked < 0 || !pov_trace_hit(tracer, eye, z, &hit) || hit.object != 1) {
        out->open++;
        return;
    }
    out->judged++;
    assert_int_equal(pov_trace_color(tracer, eye, z, rgba, NULL), POV_OK);
    if ((rgba[0] > 0.0f) != (blocked == 0)) {
        pov_ray ray = { .org = eye, .dir = z };

        complain(q, scene, &ray, blocked ? "lit" : "dark", out);
    }
}

/* ---- families ---- */

static void ask_scene(pov_context *context, const finding *f, question *q, tally *out)
{
    const bool is_light = f->what == A_LIGHT;
    pov_load_desc desc = POV_INIT(desc);
    char text[8192];
    double wall = 0.0;
    pov_scene *scene;
    pov_tracer *tracer;
    pov_error err;
    int i;

    if (is_light) {
        f->aim(q, f->aim_parameter);
        wall = q->on.z + 64.0 * q->p.size;
    }
    put_scene(text, q, wall);
    desc.threads = 1;
    if (pov_scene_load_text(&scene, context, text, strlen(text), "finding.pov", &desc, &err) != POV_OK) {
        out->open += RAYS_OF_A_SCENE;
        return;
    }
    assert_int_equal(pov_tracer_create(&tracer, scene, NULL), POV_OK);
    for (i = 0; i < RAYS_OF_A_SCENE; i++) {
        real_reset();
        if (!is_light)
            f->aim(q, f->aim_parameter);
        if (f->what == A_RAY)
            judge_ray(tracer, q, text, out);
        else if (f->what == A_SEGMENT)
            judge_segment(tracer, q, text, out);
        else
            judge_light(tracer, q, text, wall, out);
    }
    pov_tracer_destroy(tracer);
    pov_scene_destroy(scene);
}

static tally ask(pov_context *context, const finding *f, kind k)
{
    tally out = { 0 };
    long asked;

    families_seed(SEED + 64 * (uint64_t)(f - findings) + (uint64_t)k);
    for (asked = 0; asked < rays_wanted; asked += RAYS_OF_A_SCENE) {
        question q;

        memset(&q, 0, sizeof q);
        q.p.kind = k;
        f->make(&q, f->make_parameter);
        ask_scene(context, f, &q, &out);
    }
    return out;
}

static long judge_family(pov_context *context, const finding *f)
{
    long broken = 0;
    int k;

    real_precision(f->bits);
    for (k = 0; k < KINDS; k++) {
        tally t;

        if (!(f->kinds & (1u << k)) || strncmp(only_kind, probe_keyword((kind)k), strlen(only_kind)) != 0)
            continue;
        t = ask(context, f, (kind)k);
        print_message("%s, %s: %ld rays, %ld misjudged, %ld left out; ulp %.3g (%.3g from 1e-6 sizes off), %.3g of 2^-44 sizes,"
                      " %.2g of the limit; normal %.2g\n", f->name, probe_keyword((kind)k), t.judged, t.wrong, t.open, t.ulps,
                      t.far_ulps, t.part, t.beyond, t.normal);
        fflush(stdout);
        broken += t.wrong > 0 || t.judged < rays_wanted / 4 || !(t.beyond <= 1.0) || !(t.normal <= f->normal);
    }
    return broken;
}

static void no_ray_of_a_finding_is_misjudged(void **state)
{
    pov_context *context = scenes_context();
    const finding *f;
    long broken = 0;

    (void)state;
    for (f = findings; f->name; f++)
        if (strncmp(only, f->name, strlen(only)) == 0)
            broken += judge_family(context, f);
    pov_context_destroy(context);
    real_free_all();
    assert_int_equal(broken, 0);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(no_ray_of_a_finding_is_misjudged) };

    if (argc > 1)
        rays_wanted = strtol(argv[1], NULL, 10);
    if (argc > 2)
        only = argv[2];
    if (argc > 3)
        only_kind = argv[3];
    return cmocka_run_group_tests(tests, NULL, NULL);
}
