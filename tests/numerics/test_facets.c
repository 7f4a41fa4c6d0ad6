/* test_facets.c - surfaces made of triangles, against each of their triangles in 512 bits: every crossing is found, and no other.
 *
 * Height fields of a few to some thousand cells, smooth, rough, flat and under water, and Bezier patches. Rays from near and far,
 * aimed anywhere, at corners and edges or beside them by 1e-1 to 1e-17, along axes, along the surface, and from the surface;
 * together too, which must give the same bits.
 * test_facets RAYS for a long run of each. */
#include "numerics/draw.h"
#include "numerics/long_run.h"

#include "support/check.h"
#include "support/fake_reader.h"
#include "support/rays.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE_MOST = 40, FACES_MOST = 2 * 64 * 64, MOST = 256, RAYS_A_SHAPE = 100 };

/* Heights nearer to the water, and distances nearer to a start on the surface, are open. How far distances may be off. */
static const double TOUCH = 0x1p-40, PART = 0x1p-50, OFF = 0x1p-49;

static long rays;

typedef struct surface {
    int count;
    pov_vec3 face[FACES_MOST][3];
    double water;                /* crossings below it are none */
    double beside;               /* rays nearer to an edge are open: what corners are off */
    uint16_t height[SIDE_MOST * SIDE_MOST];   /* rows from the top */
} surface;

/* ---- height fields ---- */

static void draw_heights(surface *s, uint32_t wide, uint32_t deep)
{
    const double rough = U() < 0.3 ? 0.0 : U() < 0.5 ? 1.0 : log_between(-4.0, 0.0), steps = U() < 0.3 ? 4096.0 : 1.0, wave = between(2.0, 12.0);

    for (uint32_t z = 0; z < deep; z++)
        for (uint32_t x = 0; x < wide; x++) {
            const double hill = 0.5 + 0.4 * sin(wave * x / wide) * cos(wave * z / deep), h = hill * (1.0 - rough) + rough * U();

            s->height[z * wide + x] = (uint16_t)(steps * floor(65535.0 * h / steps));
        }
}

static void make_height_field(surface *s, pov_reader *in)
{
    const uint32_t most = U() < 0.5 ? 6 : SIDE_MOST, wide = 2 + (uint32_t)((most - 1) * U()), deep = 2 + (uint32_t)((most - 1) * U());

    draw_heights(s, wide, deep);
    fake_reader_heights(in, s->height, wide, deep);
    s->water = U() < 0.3 ? between(0.0, 1.0) : 0.0;
    s->beside = 0.0;
    fake_reader_word(in, "water_level");
    fake_reader_number(in, s->water);
    s->count = 0;
    for (uint32_t z = 0; z + 1 < deep; z++)
        for (uint32_t x = 0; x + 1 < wide; x++) {
            pov_vec3 c[4];

            for (uint32_t i = 0; i < 4; i++) {
                const uint32_t u = x + i % 2, v = z + i / 2;

                c[i] = pov_vec3_of(u / (wide - 1.0), s->height[(deep - 1 - v) * wide + u] / 65536.0, v / (deep - 1.0));
            }
            for (int i = 0; i < 3; i++) {
                s->face[s->count][i] = c[i];
                s->face[s->count + 1][i] = c[i + 1];
            }
            s->count += 2;
        }
}

/* ---- patches ---- */

static pov_vec3 bezier(const pov_vec3 *point, double u, double v)
{
    const double a[4] = { (1.0 - u) * (1.0 - u) * (1.0 - u), 3.0 * u * (1.0 - u) * (1.0 - u), 3.0 * u * u * (1.0 - u), u * u * u };
    const double b[4] = { (1.0 - v) * (1.0 - v) * (1.0 - v), 3.0 * v * (1.0 - v) * (1.0 - v), 3.0 * v * v * (1.0 - v), v * v * v };
    pov_vec3 sum = { 0.0, 0.0, 0.0 };

    for (int i = 0; i < 16; i++)
        sum = pov_add(sum, pov_scale(point[i], a[i % 4] * b[i / 4]));
    return sum;
}

static void feed(pov_reader *in, pov_vec3 p)
{
    fake_reader_word(in, "<");
    fake_reader_number(in, p.x);
    fake_reader_number(in, p.y);
    fake_reader_number(in, p.z);
    fake_reader_word(in, ">");
}

static void make_patch(surface *s, pov_reader *in)
{
    const int u_steps = (int)(5.0 * U()), v_steps = (int)(5.0 * U()), wide = 1 << v_steps, deep = 1 << u_steps;
    const double bend = U() < 0.2 ? 0.0 : between(0.1, 1.0);
    pov_vec3 point[16], c[4];

    fake_reader_text(in, "type 1 u_steps");
    fake_reader_number(in, u_steps);
    fake_reader_word(in, "v_steps");
    fake_reader_number(in, v_steps);
    for (int i = 0; i < 16; i++) {
        point[i] = pov_vec3_of((i % 4) / 3.0 + bend * between(-0.3, 0.3), bend * U(), i / 4 / 3.0 + bend * between(-0.3, 0.3));
        feed(in, point[i]);
    }
    s->water = -HUGE_VAL;
    s->beside = 0x1p-46;
    s->count = 0;
    for (int j = 0; j < deep; j++)
        for (int i = 0; i < wide; i++) {
            for (int k = 0; k < 4; k++)
                c[k] = bezier(point, (i + k % 2) / (double)wide, (j + k / 2) / (double)deep);
            for (int k = 0; k < 3; k++) {
                s->face[s->count][k] = c[k == 2 ? 3 : k];
                s->face[s->count + 1][k] = c[k == 0 ? 0 : k == 1 ? 3 : 2];
            }
            s->count += 2;
        }
}

/* ---- what is there ---- */

/* Crossings that are there for certain, and whether there may be others. */
typedef struct answer { int count; double at[MOST]; uint32_t face[MOST]; bool open; } answer;

typedef struct line { real3 o, d; pov_vec3 near, dir; double off; } line;

static real3 real3_from(pov_vec3 v) { return real3_of(real_of(v.x), real_of(v.y), real_of(v.z)); }

static double length(pov_vec3 v) { return sqrt(pov_dot(v, v)); }

static double det(pov_vec3 d, pov_vec3 a, pov_vec3 b) { return pov_dot(d, pov_cross_product(a, b)); }

/* In double, from a point of the ray that is near: passed on different sides for certain? */
static bool is_missed(const line *l, const pov_vec3 *c)
{
    const pov_vec3 p[3] = { pov_sub(c[0], l->near), pov_sub(c[1], l->near), pov_sub(c[2], l->near) };
    const double size = length(p[0]) + length(p[1]) + length(p[2]), error = length(l->dir) * size * (l->off + 1e-14 * size);
    double least = HUGE_VAL, most = -HUGE_VAL;

    for (int i = 0; i < 3; i++) {
        const double side = det(l->dir, p[i], p[(i + 1) % 3]);

        least = fmin(least, side);
        most = fmax(most, side);
    }
    return least < -error && most > error;
}

static int side_of(const line *l, pov_vec3 a, pov_vec3 b, double beside)
{
    const real side = real3_dot(l->d, real3_cross(real3_sub(real3_from(a), l->o), real3_sub(real3_from(b), l->o)));

    return fabs(real_double(side)) <= beside * length(l->dir) * length(pov_sub(b, a)) ? 0 : real_sign(side);
}

static void ask_face(const surface *s, const line *l, uint32_t face, double from, answer *out)
{
    const pov_vec3 *c = s->face[face];
    const int a = side_of(l, c[0], c[1], s->beside), b = side_of(l, c[1], c[2], s->beside), d = side_of(l, c[2], c[0], s->beside);
    const int least = a < b ? (a < d ? a : d) : b < d ? b : d, most = a > b ? (a > d ? a : d) : b > d ? b : d;
    real3 normal;
    real t, height;

    if (least < 0 && most > 0)
        return;
    if (a * b * d == 0) {
        out->open = true;
        return;
    }
    normal = real3_cross(real3_sub(real3_from(c[2]), real3_from(c[0])), real3_sub(real3_from(c[1]), real3_from(c[0])));
    t = real_div(real3_dot(normal, real3_sub(real3_from(c[0]), l->o)), real3_dot(normal, l->d));
    height = real_sub(real_add(l->o.y, real_mul(l->d.y, t)), real_of(s->water > 0.0 ? s->water : -1.0));
    out->open = out->open || fabs(real_double(height)) < TOUCH || fabs(real_double(t) - from) < TOUCH || out->count == MOST;
    if (real_double(height) > 0.0 && real_double(t) > from && out->count < MOST) {
        out->face[out->count] = face;
        out->at[out->count++] = real_double(t);
    }
}

static void find_all(const surface *s, const pov_ray *ray, answer *out)
{
    const double along = -pov_dot(ray->org, ray->dir) / pov_dot(ray->dir, ray->dir), far = length(ray->org) + fabs(along) * length(ray->dir);
    const bool starts = ray->origin_surface != POV_NO_OWNER;
    line l = { .near = pov_add(ray->org, pov_scale(ray->dir, along)), .dir = ray->dir, .off = 1e-14 * far };

    real_reset();
    out->count = 0;
    out->open = false;
    l.o = real3_add(real3_from(ray->org), real3_from(ray->org_lo));
    l.d = real3_from(ray->dir);
    for (int i = 0; i < s->count; i++) {
        const int mark = real_mark();

        if (!is_missed(&l, s->face[i]) && !(starts && ray->origin_mark.feature == (uint32_t)i))
            ask_face(s, &l, (uint32_t)i, 0.0, out);
        real_release(mark);
    }
}

/* ---- rays ---- */

static double distance(void) { return U() < 0.7 ? between(2.0, 5.0) : log_between(0.0, 7.0); }

static pov_vec3 somewhere(void) { return pov_vec3_of(between(-0.1, 1.1), between(-0.1, 1.1), between(-0.1, 1.1)); }

static pov_ray any_ray(void)
{
    const pov_vec3 d = families_direction();

    return ray_from(pov_sub(somewhere(), pov_scale(d, distance())), d);
}

/* At a corner, at an edge, or beside it. */
static pov_vec3 near_edge(const surface *s)
{
    const pov_vec3 *c = s->face[(int)(s->count * U())];
    const double u = U() < 0.3 ? 0.0 : U() < 0.2 ? 0.5 : U(), beside = U() < 0.3 ? 0.0 : log_between(-17.0, -1.0);
    const pov_vec3 at = pov_add(c[0], pov_scale(pov_sub(c[1 + (int)(2.0 * U())], c[0]), u));

    return pov_add(at, pov_scale(families_direction(), beside));
}

static pov_ray edge_ray(const surface *s)
{
    const pov_vec3 d = families_direction(), at = near_edge(s);
    pov_ray ray = ray_from(pov_sub(at, pov_scale(d, distance())), d);

    if (U() < 0.5)
        ray.dir = pov_sub(at, ray.org);
    return ray;
}

static pov_ray axis_ray(const surface *s)
{
    const pov_vec3 at = U() < 0.5 ? somewhere() : near_edge(s);
    const double by = either(log_between(-1.0, 1.0)), none = either(0.0), slight = U() < 0.5 ? none : either(log_between(-18.0, -1.0));
    const int axis = (int)(3.0 * U());
    const pov_vec3 d = pov_vec3_of(axis == 0 ? by : axis == 1 ? slight : none, axis == 1 ? by : axis == 2 ? slight : none, axis == 2 ? by : none);

    return ray_from(pov_sub(at, pov_scale(d, floor(distance()))), d);
}

/* Along a face, above or below it by little. */
static pov_ray skimming_ray(const surface *s)
{
    const pov_vec3 *c = s->face[(int)(s->count * U())];
    const pov_vec3 normal = pov_unit(pov_cross_product(pov_sub(c[1], c[0]), pov_sub(c[2], c[0]))), d = across(normal);
    const pov_vec3 at = pov_add(pov_scale(pov_add(pov_add(c[0], c[1]), c[2]), 1.0 / 3.0), pov_scale(normal, either(log_between(-12.0, -1.0))));

    return ray_from(pov_sub(at, pov_scale(d, distance())), d);
}

static uint32_t ask(const shape_class *c, const void *self, const pov_ray *ray, pov_want want, pov_crossing *at)
{
    pov_hits hits = hits_to(HUGE_VAL, want, at, MOST);

    hits.owner = 1;
    c->intersect(self, ray, &hits);
    return hits.count;
}

static pov_ray leaving_ray(const shape_class *c, const void *self)
{
    pov_ray from = any_ray(), ray;
    pov_crossing at[MOST];

    if (ask(c, self, &from, POV_WANT_NEAREST, at) == 0)
        return from;
    ray = ray_from(pov_add(from.org, pov_scale(from.dir, at[0].t)), families_direction());
    ray.origin_surface = 1;
    ray.origin_mark = at[0].mark;
    return ray;
}

static pov_ray draw_ray(const surface *s, const shape_class *c, const void *self)
{
    switch ((int)(5.0 * U())) {
    case 0: return any_ray();
    case 1: return edge_ray(s);
    case 2: return axis_ray(s);
    case 3: return skimming_ray(s);
    default: return leaving_ray(c, self);
    }
}

/* ---- the verdict ---- */

typedef struct score { long asked, open, wrong, crossings; double off; } score;

/* Is a crossing of the answer among those found, and is it where it should be? */
static bool has(const pov_crossing *at, uint32_t n, double t, uint32_t face, score *out)
{
    for (uint32_t i = 0; i < n; i++)
        if (at[i].mark.feature == face) {
            const double off = fabs(at[i].t - t);

            out->off = fmax(out->off, off - PART * fabs(t));
            return off <= OFF + PART * fabs(t);
        }
    return false;
}

/* The nearest, and any, are those of all; several may be as near as can be told. */
static bool agrees_nearest(const shape_class *c, const void *self, const pov_ray *ray, const pov_crossing *all, uint32_t n)
{
    pov_crossing one[MOST];
    double least = HUGE_VAL;

    for (uint32_t i = 0; i < n; i++)
        least = fmin(least, all[i].t);
    if (ask(c, self, ray, POV_WANT_NEAREST, one) != (n > 0) || (n > 0 && one[0].t != least))
        return false;
    return (ask(c, self, ray, POV_WANT_ANY, one) > 0) == (n > 0);
}

static void judge(const shape_class *c, const surface *s, const void *self, const pov_ray *ray, score *out)
{
    pov_crossing at[MOST];
    const uint32_t n = ask(c, self, ray, POV_WANT_ALL, at);
    answer there;
    bool same;

    find_all(s, ray, &there);
    same = agrees_nearest(c, self, ray, at, n) && (there.open || (int)n == there.count);
    for (int i = 0; same && i < there.count; i++)
        same = has(at, n, there.at[i], there.face[i], out) || there.open;
    out->asked++;
    out->crossings += there.count;
    out->open += there.open;
    if (!same && out->wrong++ == 0)
        fprintf(stderr, "ray <%a,%a,%a> <%a,%a,%a>: %d crossings, found %u\n", ray->org.x, ray->org.y, ray->org.z, ray->dir.x, ray->dir.y,
                ray->dir.z, there.count, n);
}

/* Up to some distance, at which another object's crossing may have been found before. */
static pov_hits ask_to_some_end(pov_want want, pov_crossing *at)
{
    const double end = U() < 0.4 ? HUGE_VAL : 4.0 * U();
    pov_hits hits = hits_to(end, want, at, 1);

    memset(at, 0, sizeof *at);
    hits.owner = 1;
    if (want == POV_WANT_NEAREST && end < HUGE_VAL && U() < 0.5) {
        at->t = end;
        at->owner = 2;
        hits.tmax = end + POV_COINCIDENT * end;
        hits.count = 1;
    }
    return hits;
}

/* Rays together find what each finds by itself, with the same bits. */
static void judge_together(const shape_class *c, const void *self, const pov_ray *rays_of, pov_want want)
{
    const void *selves[RAYS_A_SHAPE];
    const pov_ray *each[RAYS_A_SHAPE];
    pov_hits hits[RAYS_A_SHAPE], alone[RAYS_A_SHAPE], *to[RAYS_A_SHAPE];
    pov_crossing at[RAYS_A_SHAPE], own[RAYS_A_SHAPE];

    for (int i = 0; i < RAYS_A_SHAPE; i++) {
        selves[i] = self;
        each[i] = &rays_of[i];
        hits[i] = alone[i] = ask_to_some_end(want, &at[i]);
        own[i] = at[i];
        alone[i].at = &own[i];
        to[i] = &hits[i];
    }
    for (int from = 0, some; from < RAYS_A_SHAPE; from += some) {
        const int left = RAYS_A_SHAPE - from, wanted = 1 + (int)(80.0 * U());

        some = wanted < left ? wanted : left;
        c->intersect_many(selves + from, each + from, to + from, (uint32_t)some);
    }
    for (int i = 0; i < RAYS_A_SHAPE; i++) {
        c->intersect(self, each[i], &alone[i]);
        assert_int_equal(hits[i].count, alone[i].count);
        if (want == POV_WANT_NEAREST) {
            assert_memory_equal(&at[i].t, &own[i].t, sizeof own[i].t);
            assert_memory_equal(&at[i].t_lo, &own[i].t_lo, sizeof own[i].t_lo);
            assert_int_equal(at[i].owner, own[i].owner);
            assert_int_equal(at[i].mark.feature, own[i].mark.feature);
        }
    }
}

static void keeps_its_crossings(const char *keyword, void (*make)(surface *s, pov_reader *in))
{
    const shape_class *c = fake_reader_shape(keyword);
    surface *one = malloc(sizeof *one);
    score s = { 0, 0, 0, 0, 0.0 };
    pov_ray drawn[RAYS_A_SHAPE];

    assert_non_null(c);
    assert_non_null(one);
    families_seed(21);
    while (s.asked < rays) {
        pov_reader *in = fake_reader_create();
        void *self;

        make(one, in);
        self = fake_reader_parse(in, c);
        if (!self)
            fail_msg("%s: %s", keyword, fake_reader_message(in));
        for (int i = 0; i < RAYS_A_SHAPE; i++) {
            drawn[i] = draw_ray(one, c, self);
            judge(c, one, self, &drawn[i], &s);
        }
        if (c->intersect_many) {
            judge_together(c, self, drawn, POV_WANT_NEAREST);
            judge_together(c, self, drawn, POV_WANT_ANY);
        }
        fake_reader_destroy(in);
    }
    free(one);
    printf("%s: %ld rays, %ld crossings, %ld open, %ld misjudged, off by %.2g\n", keyword, s.asked, s.crossings, s.open, s.wrong, s.off);
    assert_int_equal(s.wrong, 0);
    assert_true(5 * s.open <= s.asked);
}

static void a_height_field_has_the_crossings_of_its_triangles(void **state) { (void)state; keeps_its_crossings("height_field", make_height_field); }
static void a_patch_has_the_crossings_of_its_triangles(void **state) { (void)state; keeps_its_crossings("bicubic_patch", make_patch); }

/* Straight down at a corner or an edge within the square. */
static void a_ray_straight_down_meets_a_height_field_once(void **state)
{
    const shape_class *c = fake_reader_shape("height_field");
    surface *one = malloc(sizeof *one);

    (void)state;
    assert_non_null(c);
    assert_non_null(one);
    families_seed(22);
    for (long asked = 0; asked < rays; asked += RAYS_A_SHAPE) {
        pov_reader *in = fake_reader_create();
        const uint32_t wide = 2 + (uint32_t)(20.0 * U()), deep = 2 + (uint32_t)(20.0 * U());
        pov_crossing at[MOST];
        void *self;

        draw_heights(one, wide, deep);
        fake_reader_heights(in, one->height, wide, deep);
        self = fake_reader_parse(in, c);
        assert_non_null(self);
        for (int i = 0; i < RAYS_A_SHAPE; i++) {
            const double u = U(), x = U() < 0.3 ? u : 0.5 * (1.0 + floor(u * (2 * wide - 3))), z = 0.5 * (1.0 + floor(U() * (2 * deep - 3)));
            const double up = either(1.0), at_x = x == u ? u : floor(x) == x ? x / (wide - 1.0) : 0.5 * (floor(x) / (wide - 1.0) + ceil(x) / (wide - 1.0));
            const double at_z = floor(z) == z ? z / (deep - 1.0) : 0.5 * (floor(z) / (deep - 1.0) + ceil(z) / (deep - 1.0));
            const pov_ray ray = ray_from(pov_vec3_of(at_x, -3.0 * up, at_z), pov_vec3_of(either(0.0), up, either(0.0)));

            if (at_x <= 0.0 || at_x >= 1.0 || at_z <= 0.0 || at_z >= 1.0)
                continue;
            assert_int_equal(ask(c, self, &ray, POV_WANT_ALL, at), 1);
        }
        fake_reader_destroy(in);
    }
    free(one);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_height_field_has_the_crossings_of_its_triangles),
        cmocka_unit_test(a_patch_has_the_crossings_of_its_triangles),
        cmocka_unit_test(a_ray_straight_down_meets_a_height_field_once),
    };

    rays = long_run_rays(argc, argv, 4000);
    return cmocka_run_group_tests(tests, NULL, long_run_end);
}
