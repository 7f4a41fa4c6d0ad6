/* test_isosurface.c - isosurfaces whose crossings are known in closed form, on the same doubles: which there are, and where.
 *
 * Rays start near and far, within the container, and graze the surface; each goes on through all of its crossings, so that it
 * leaves surfaces too. Without arguments a short run; test_isosurface RAYS [SEED] for a long one, of RAYS for each surface. */
#include "support/check.h"
#include "support/scenes.h"

#include "base/mix.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef long double real;

enum { PIECES = 64 };

static long rays = 1500;
static uint64_t state = 20261125;

static double uniform(void)
{
    state += 0x9e3779b97f4a7c15u;
    return (double)(mix_bits(state) >> 11) * 0x1p-53;
}

/* ---- sets of distances ---- */

/* Pieces from edge to edge; edges grow. */
typedef struct set { real at[2 * PIECES]; int count; } set;
typedef struct line { real o[3], d[3]; } line;

static const set everything = { { -1e300L, 1e300L }, 2 };

static bool holds(const set *s, real t)
{
    int before = 0;

    for (int i = 0; i < s->count; i++)
        before += s->at[i] < t;
    return before % 2 == 1;
}

static int compare(const void *a, const void *b)
{
    const real x = *(const real *)a, y = *(const real *)b;

    return (x > y) - (x < y);
}

/* What lies in both, or in one of them. */
static set combine(const set *a, const set *b, bool both)
{
    real edge[4 * PIECES];
    set out = { .count = 0 };
    int n = 0;

    for (int i = 0; i < a->count; i++)
        edge[n++] = a->at[i];
    for (int i = 0; i < b->count; i++)
        edge[n++] = b->at[i];
    qsort(edge, (size_t)n, sizeof *edge, compare);
    for (int i = 0; i + 1 < n; i++) {
        const real middle = 0.5L * (edge[i] + edge[i + 1]);
        const bool in = both ? holds(a, middle) && holds(b, middle) : holds(a, middle) || holds(b, middle);

        if (!in || !(edge[i + 1] > edge[i]))
            continue;
        if (out.count > 0 && out.at[out.count - 1] == edge[i])
            out.at[out.count - 1] = edge[i + 1];
        else if (out.count + 2 <= 2 * PIECES)
            out.at[out.count++] = edge[i], out.at[out.count++] = edge[i + 1];
    }
    return out;
}

static set complement(const set *a)
{
    set out = { .count = 0 };

    out.at[out.count++] = everything.at[0];
    for (int i = 0; i < a->count; i++)
        out.at[out.count++] = a->at[i];
    out.at[out.count++] = everything.at[1];
    return out;
}

/* a t^2 + 2 b t + c < 0. */
static set below(real a, real b, real c)
{
    const real square = b * b - a * c;
    set out = { .count = 0 }, turned;
    real q;

    if (a == 0.0L || square <= 0.0L)
        return (a == 0.0L ? c : a) < 0.0L ? everything : out;
    q = -(b + copysignl(sqrtl(square), b));
    out.at[0] = fminl(q / a, c / q);
    out.at[1] = fmaxl(q / a, c / q);
    out.count = 2;
    turned = complement(&out);
    return a > 0.0L ? out : turned;
}

/* wx x^2 + wy y^2 + wz z^2 < k about a centre. The ray is moved to its nearest point first: far starts lose nothing. */
static set quadric(const line *l, real wx, real wy, real wz, real k, real cx)
{
    const real w[3] = { wx, wy, wz }, centre[3] = { cx, 0.0L, 0.0L };
    real near = 0.0L, square = 0.0L, a = 0.0L, b = 0.0L, c = -k;
    set s;

    for (int i = 0; i < 3; i++) {
        near -= (l->o[i] - centre[i]) * l->d[i];
        square += l->d[i] * l->d[i];
    }
    near /= square;
    for (int i = 0; i < 3; i++) {
        const real p = (l->o[i] - centre[i]) + near * l->d[i];

        a += w[i] * l->d[i] * l->d[i];
        b += w[i] * p * l->d[i];
        c += w[i] * p * p;
    }
    s = below(a, b, c);
    for (int i = 0; i < s.count; i++)
        s.at[i] += fabsl(s.at[i]) < 1e299L ? near : 0.0L;
    return s;
}

/* lo < coordinate < hi */
static set slab(const line *l, int axis, real lo, real hi)
{
    const real a = (lo - l->o[axis]) / l->d[axis], b = (hi - l->o[axis]) / l->d[axis];
    const set s = { { fminl(a, b), fmaxl(a, b) }, 2 };

    return s;
}

/* ---- surfaces ---- */

typedef struct surface {
    const char *name, *text;
    set (*inside)(const line *l);
} surface;

static set in_sphere(const line *l) { return quadric(l, 1, 1, 1, 1, 0); }
static set in_ellipsoid(const line *l) { return quadric(l, 4, 1, 9, 1, 0); }

static set in_cube(const line *l)
{
    const set x = slab(l, 0, -0.75L, 0.75L), y = slab(l, 1, -0.75L, 0.75L), z = slab(l, 2, -0.75L, 0.75L), xy = combine(&x, &y, true);

    return combine(&xy, &z, true);
}

static set in_cylinder(const line *l)
{
    const set round = quadric(l, 1, 0, 1, 0.25L, 0), flat = slab(l, 1, -0.75L, 0.75L);

    return combine(&round, &flat, true);
}

static set in_two_spheres(const line *l)
{
    const set a = quadric(l, 1, 1, 1, 0.25L, 0.375L), b = quadric(l, 1, 1, 1, 0.25L, -0.375L);

    return combine(&a, &b, false);
}

static set in_shell(const line *l)
{
    const set outer = quadric(l, 1, 1, 1, 0.875L * 0.875L, 0), inner = quadric(l, 1, 1, 1, 0.75L * 0.75L, 0), hole = complement(&inner);

    return combine(&outer, &hole, true);
}

static set in_container(const line *l)
{
    const set x = slab(l, 0, -1, 1), y = slab(l, 1, -1, 1), z = slab(l, 2, -1, 1), xy = combine(&x, &y, true);

    return combine(&xy, &z, true);
}

/* sin(12 y) < 0. */
static set in_waves(const line *l)
{
    const set box = in_container(l);
    const real wave = 3.14159265358979323846264338328L / 12.0L;
    set all = { .count = 0 };

    for (int k = -2; k <= 2; k++) {
        const set one = slab(l, 1, (2 * k - 1) * wave, 2 * k * wave);

        all = combine(&all, &one, false);
    }
    return combine(&all, &box, true);
}

/* x^2 + z^2 < (1 - y)^2 / 4, where 1 - y > 0. */
static set in_cone(const line *l)
{
    const line moved = { { l->o[0], l->o[1] - 1.0L, l->o[2] }, { l->d[0], l->d[1], l->d[2] } };
    const set both = quadric(&moved, 1, -0.25L, 1, 0, 0), half = slab(l, 1, -1e6L, 1), one = combine(&both, &half, true), box = in_container(l);

    return combine(&one, &box, true);
}

static set in_hyperboloid(const line *l)
{
    const set all = quadric(l, 1, -1, 1, 0.125L, 0), box = in_container(l);

    return combine(&all, &box, true);
}

#define SPHERE_2 " contained_by { sphere { 0, 2 } } max_gradient 0.01 "
#define BOX_1 " contained_by { box { -1, 1 } } max_gradient 0.01 "

static const surface surfaces[] = {
    { "root of a sphere", "sqrt(x*x + y*y + z*z) - 1 }" SPHERE_2, in_sphere },
    { "sphere", "x*x + y*y + z*z - 1 }" SPHERE_2, in_sphere },
    { "ellipsoid", "4*x*x + pow(y, 2) + 9*z*z - 1 }" SPHERE_2, in_ellipsoid },
    { "cube", "max(abs(x), abs(y), abs(z)) - 0.75 }" SPHERE_2, in_cube },
    { "cylinder", "max(sqrt(x*x + z*z) - 0.5, abs(y) - 0.75) }" SPHERE_2, in_cylinder },
    { "two spheres", "min((x - 0.375)*(x - 0.375), (x + 0.375)*(x + 0.375)) + y*y + z*z - 0.25 }" SPHERE_2, in_two_spheres },
    { "shell", "abs(sqrt(x*x + y*y + z*z) - 0.8125) - 0.0625 }" SPHERE_2, in_shell },
    { "waves", "sin(12*y) }" BOX_1, in_waves },
    { "cone", "sqrt(x*x + z*z) - (1 - y)/2 }" BOX_1, in_cone },
    { "hyperboloid", "x*x + z*z - y*y - 0.125 }" BOX_1, in_hyperboloid },
};

/* ---- rays ---- */

static pov_vec3 direction(void)
{
    pov_vec3 d;

    do
        d = pov_vec3_of(2.0 * uniform() - 1.0, 2.0 * uniform() - 1.0, 2.0 * uniform() - 1.0);
    while (pov_dot(d, d) > 1.0 || pov_dot(d, d) < 0.01);
    return pov_unit(d);
}

typedef struct tally { long asked, crossings, open, wrong, off; double worst; } tally;
typedef struct hits { double t[2 * PIECES], slope[2 * PIECES]; int count; pov_vec3 dir; } hits;

static bool note(void *user, const pov_hit *hit)
{
    hits *h = user;

    if (h->count == 2 * PIECES)
        return false;
    h->slope[h->count] = fabs(pov_dot(hit->normal, h->dir));
    h->t[h->count++] = hit->distance;
    return true;
}

/* Towards the surface: from near, far and very far, from within, and along it: past a point of it by little. */
static void make_ray(pov_tracer *tracer, pov_vec3 *org, pov_vec3 *dir)
{
    const double kind = uniform(), away = kind < 0.4 ? 3.0 : kind < 0.5 ? 1e3 : 1e6;
    pov_hit hit = { .size = sizeof hit };

    *dir = direction();
    *org = pov_sub(pov_scale(direction(), 0.8 * uniform()), pov_scale(*dir, kind < 0.6 ? away : 0.0));
    if (kind < 0.7 || !pov_trace_hit(tracer, *org, *dir, &hit))
        return;
    *dir = pov_unit(pov_add(pov_unit(pov_cross_product(hit.normal, direction())), pov_scale(direction(), pow(10.0, -6.0 * uniform()))));
    *org = pov_sub(pov_add(hit.point, pov_scale(hit.normal, pow(10.0, -2.0 - 10.0 * uniform()) * (uniform() < 0.5 ? -1.0 : 1.0))), pov_scale(*dir, 3.0));
}

/* The edges ahead, and how much apart they are at least: below that rounding decides. */
static int ahead(const set *s, double away, real out[2 * PIECES], bool *open)
{
    const real narrow = 1e-12L * (1.0L + (real)away);
    int n = 0;

    *open = false;
    for (int i = 0; i < s->count; i++) {
        *open = *open || fabsl(s->at[i]) < narrow || (i > 0 && s->at[i] - s->at[i - 1] < sqrtl(narrow));
        if (s->at[i] > 0.0L && s->at[i] < 1e299L)
            out[n++] = s->at[i];
    }
    return n;
}

static void judge(const surface *f, pov_tracer *tracer, tally *t)
{
    real known[2 * PIECES];
    hits h = { .count = 0 };
    pov_vec3 org, dir;
    bool open;
    line l;
    set s;
    int n;

    make_ray(tracer, &org, &dir);
    h.dir = dir;
    l = (line){ { org.x, org.y, org.z }, { dir.x, dir.y, dir.z } };
    s = f->inside(&l);
    n = ahead(&s, pov_largest(org), known, &open);
    t->asked++;
    t->open += open;
    if (open)
        return;
    pov_trace_hits(tracer, org, dir, note, &h);
    t->crossings += n;
    if (h.count != n) {
        if (t->wrong++ == 0)
            printf("%s: %d of %d crossings from <%a,%a,%a> along <%a,%a,%a>\n", f->name, h.count, n, org.x, org.y, org.z, dir.x, dir.y, dir.z);
        return;
    }
    for (int i = 0; i < n; i++) {
        const double off = fabs((double)(known[i] - h.t[i])) * fmax(h.slope[i], 1e-9) / (0x1p-53 * (2.0 + (double)known[i]));

        t->worst = fmax(t->worst, off);
        t->off += off > 64.0;
    }
}

/* ---- tests ---- */

static void no_ray_slips_through_and_crossings_are_where_they_are(void **user)
{
    pov_context *context = scenes_context();
    long wrong = 0;

    (void)user;
    for (size_t i = 0; i < sizeof surfaces / sizeof *surfaces; i++) {
        char text[512];
        tally t = { 0 };
        pov_tracer *tracer;
        pov_scene *scene;

        snprintf(text, sizeof text, "isosurface { function { %s pigment { rgb 1 } }", surfaces[i].text);
        scene = scenes_text(context, text);
        assert_int_equal(pov_tracer_create(&tracer, scene, NULL), POV_OK);
        for (long k = 0; k < rays; k++)
            judge(&surfaces[i], tracer, &t);
        printf("%-16s %ld rays, %ld crossings, %ld open, %ld wrong, %ld off; worst %.1f u of 2 + t over the cosine\n", surfaces[i].name,
               t.asked, t.crossings, t.open, t.wrong, t.off, t.worst);
        wrong += t.wrong + t.off;
        pov_tracer_destroy(tracer);
        pov_scene_destroy(scene);
    }
    pov_context_destroy(context);
    assert_int_equal(wrong, 0);
}

/* Of which those words are without meaning. */
static void the_picture_is_the_same_whatever_max_gradient_says(void **user)
{
    static const char *const words[] = { "", "max_gradient 0.001", "max_gradient 1000 accuracy 0.1 max_trace 1", "all_intersections evaluate 1, 1, 0.9" };
    enum { WIDTH = 40, HEIGHT = 30 };
    float *first = NULL;

    (void)user;
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        char text[1024];
        float *picture;

        snprintf(text, sizeof text,
                 "#declare Torus = function { internal(70) } camera { location <0, 1, -4> look_at 0 } light_source { <5, 9, -9>, 1 } isosurface { function { Torus(x, y, z, 0.8, 0.3) + "
                 "0.05*sin(20*x)*sin(20*z) } contained_by { box { -1.3, 1.3 } } %s pigment { rgb 1 } }", words[i]);
        picture = scenes_draw(text, WIDTH, HEIGHT, 0, 0);
        if (!first)
            first = picture;
        assert_memory_equal(first, picture, sizeof(float) * 4 * WIDTH * HEIGHT);
        if (first != picture)
            free(picture);
    }
    free(first);
}

static long hits_of(const char *function, pov_vec3 org, pov_vec3 dir, hits *out, pov_vec3 *normal)
{
    pov_context *context = scenes_context();
    pov_hit first = { .size = sizeof first };
    pov_tracer *tracer;
    pov_scene *scene;
    char text[512];

    snprintf(text, sizeof text, "#declare Noise = function { internal(76) } isosurface { function { %s } pigment { rgb 1 } }", function);
    scene = scenes_text(context, text);
    assert_int_equal(pov_tracer_create(&tracer, scene, NULL), POV_OK);
    out->count = 0;
    out->dir = dir;
    pov_trace_hits(tracer, org, dir, note, out);
    if (pov_trace_hit(tracer, org, dir, &first))
        *normal = first.normal;
    pov_tracer_destroy(tracer);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
    return out->count;
}

static void a_jump_is_a_surface_and_the_border_of_a_domain_is_none(void **user)
{
    const pov_vec3 org = { 3.0, 0.3, 0.2 }, dir = { -1.0, 0.0, 0.0 };
    pov_vec3 normal = { 0.0, 0.0, 0.0 };
    hits h;

    (void)user;
    assert_int_equal(hits_of("select(x - 0.25, -1, 1) + 0.1*y", org, dir, &h, &normal), 2);
    assert_true(fabs(h.t[0] - 2.75) < 1e-12 && normal.x > 0.99 && fabs(h.t[1] - 4.0) < 1e-12);
    assert_int_equal(hits_of("ln(x) + y", org, dir, &h, &normal), 1);
    assert_true(fabs(h.t[0] - (3.0 - exp(-0.3))) < 1e-12);
}

/* Of noise no bounds are known. */
static void an_accuracy_beyond_that_of_doubles_has_an_end(void **user)
{
    const pov_vec3 org = { 3.0, 0.3, 0.2 }, dir = { -1.0, 0.0, 0.0 };
    pov_vec3 normal;
    hits h;

    (void)user;
    assert_int_equal(hits_of("x - 0.25 + 0*Noise(x, y, z) } max_gradient 9 accuracy 1e-30 contained_by { box { -1, 1 }", org, dir, &h, &normal), 2);
    assert_true(fabs(h.t[0] - 2.75) < 1e-15 * h.t[0]);
}

/* Bit for bit, from outside and from within, past one and into another. */
static void rays_together_find_what_each_finds_alone(void **user)
{
    enum { RAYS = 400 };
    pov_context *context = scenes_context();
    pov_vec3 org[RAYS], dir[RAYS], normal[RAYS];
    double distance[RAYS];
    const pov_found found = { .size = sizeof found, .distance = distance, .normal = normal };
    pov_tracer *tracer;
    pov_scene *scene = scenes_text(context, "#declare F = function { pattern { crackle scale 0.6 } } "
                                            "isosurface { function { F(x, y, z) - 0.3 } max_gradient 4 pigment { rgb 1 } } "
                                            "isosurface { function { F(x, y, z) - 0.2 + 0.1*sin(9*x) } open max_gradient 5 rotate 20 translate 2.2*x pigment { rgb 1 } }");
    long hit = 0;

    (void)user;
    assert_int_equal(pov_tracer_create(&tracer, scene, NULL), POV_OK);
    for (int i = 0; i < RAYS; i++) {
        org[i] = i % 3 == 0 ? pov_scale(direction(), 0.9) : pov_vec3_of(0.3 * uniform(), 0.4 * uniform(), -4.0);
        dir[i] = pov_sub(pov_vec3_of(3.0 * uniform() - 1.0, 2.0 * uniform() - 1.0, uniform()), org[i]);
    }
    assert_int_equal(pov_trace_many(tracer, RAYS, org, dir, &found, NULL), POV_OK);
    for (int i = 0; i < RAYS; i++) {
        pov_hit alone = { .size = sizeof alone };

        if (!pov_trace_hit(tracer, org[i], dir[i], &alone))
            continue;
        hit++;
        assert_memory_equal(&distance[i], &alone.distance, sizeof alone.distance);
        assert_memory_equal(&normal[i], &alone.normal, sizeof alone.normal);
    }
    assert_true(hit > RAYS / 2);
    pov_tracer_destroy(tracer);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
}

/* As in POV-Ray. */
static void a_gradient_or_accuracy_of_zero_is_as_if_left_out(void **user)
{
    const pov_vec3 org = { 3.0, 0.3, 0.2 }, dir = { -1.0, 0.0, 0.0 };
    pov_vec3 normal;
    hits h;

    (void)user;
    assert_int_equal(hits_of("x - 0.25 } max_gradient 0 accuracy 0 contained_by { box { -1, 1 }", org, dir, &h, &normal), 2);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(no_ray_slips_through_and_crossings_are_where_they_are),
                                        cmocka_unit_test(the_picture_is_the_same_whatever_max_gradient_says),
                                        cmocka_unit_test(a_jump_is_a_surface_and_the_border_of_a_domain_is_none),
                                        cmocka_unit_test(an_accuracy_beyond_that_of_doubles_has_an_end),
                                        cmocka_unit_test(rays_together_find_what_each_finds_alone),
                                        cmocka_unit_test(a_gradient_or_accuracy_of_zero_is_as_if_left_out) };

    if (argc > 1)
        rays = strtol(argv[1], NULL, 10);
    if (argc > 2)
        state = strtoull(argv[2], NULL, 10);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
