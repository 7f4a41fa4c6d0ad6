/* test_strokes.c - sphere sweeps, by polynomials of their parameter in 512 bits: each crossing that is there is found, and
 * no other (numerics/kinds.h). test_strokes RAYS for a long run of each. */
#include "numerics/draw.h"
#include "numerics/long_run.h"
#include "numerics/spline_real.h"

#include "support/check.h"
#include "support/fake_reader.h"
#include "support/rays.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static long rays;

static void put_number(shape *s, pov_reader *in, double number)
{
    s->number[s->count++] = number;
    fake_reader_number(in, number);
}

/* ---- sphere sweeps ---- */

static void make_sweep(shape *s, pov_reader *in, const char *spline, int least)
{
    const int n = least + (int)(3.0 * U());

    s->count = 0;
    fake_reader_word(in, spline);
    fake_reader_number(in, n);
    for (int i = 0; i < n; i++) {
        fake_reader_word(in, "<");
        for (int k = 0; k < 3; k++)
            put_number(s, in, between(-0.7, 0.7));
        fake_reader_word(in, ">");
        put_number(s, in, U() < 0.2 ? 0.2 : between(0.05, 0.4));
    }
    fake_reader_text(in, "tolerance 0.000001");
}

static void make_straight(shape *s, pov_reader *in) { make_sweep(s, in, "linear_spline", 2); }
static void make_cubic(shape *s, pov_reader *in) { make_sweep(s, in, "cubic_spline", 4); }
static void make_b_spline(shape *s, pov_reader *in) { make_sweep(s, in, "b_spline", 4); }

/* A ray in the sphere at u from (-half - root) / square to (-half + root) / square, root^2 = inner. */
typedef struct field { real square; poly_real half, inner; } field;

static field field_of(const spline_basis *b, const double *points, const along *a)
{
    const poly_real *line[3] = { &a->x, &a->y, &a->z };
    poly_real half = poly_of(real_of(0.0)), rest = poly_of(real_of(0.0)), r = spline_piece(b, points + 3, 4), more;
    field f = { .square = real_of(0.0) };

    for (int i = 0; i < 3; i++) {
        const poly_real centre = spline_piece(b, points + i, 4), start = poly_of(line[i]->c[0]), w = poly_sub(&start, &centre);

        more = poly_scale(&w, line[i]->c[1]);
        half = poly_add(&half, &more);
        more = poly_mul(&w, &w);
        rest = poly_add(&rest, &more);
        f.square = real_add(f.square, real_mul(line[i]->c[1], line[i]->c[1]));
    }
    more = poly_mul(&r, &r);
    rest = poly_sub(&rest, &more);
    rest = poly_scale(&rest, f.square);
    f.half = half;
    more = poly_mul(&half, &half);
    f.inner = poly_sub(&more, &rest);
    return f;
}

/* Where the ray may enter or leave first or last: 4 half'^2 inner = inner'^2. */
static poly_real turning_points(const field *f)
{
    const poly_real a = poly_slope(&f->half), b = poly_slope(&f->inner), aa = poly_mul(&a, &a), bb = poly_mul(&b, &b);
    poly_real p = poly_mul(&aa, &f->inner);

    p = poly_scale(&p, real_of(4.0));
    return poly_sub(&p, &bb);
}

typedef struct stretch { double from, to; } stretch;
typedef struct stretches { int count; stretch at[KIND_CROSSINGS]; } stretches;

static void widen(const field *f, double u, stretch *s)
{
    const int mark = real_mark();
    const real inner = poly_at(&f->inner, real_of(u)), half = poly_at(&f->half, real_of(u));
    const real root = real_sign(inner) > 0 ? real_sqrt(inner) : real_of(0.0);

    s->from = fmin(s->from, real_double(real_div(real_neg(real_add(half, root)), f->square)));
    s->to = fmax(s->to, real_double(real_div(real_sub(root, half), f->square)));
    real_release(mark);
}

/* Between neighbouring ends where the root is real: spheres there overlap one another. */
static void add_piece(const field *f, stretches *out)
{
    const poly_real turns = turning_points(f);
    const poly_piece inner = { f->inner, real_of(0.0), real_of(1.0) }, turned = { turns, real_of(0.0), real_of(1.0) };
    double ends[KIND_CROSSINGS] = { 0.0 }, at[KIND_CROSSINGS];
    const int n = 1 + poly_roots(&inner, ends + 1, KIND_CROSSINGS - 2), m = poly_roots(&turned, at, KIND_CROSSINGS);

    ends[n] = 1.0;
    for (int i = 0; i < n; i++) {
        stretch s = { HUGE_VAL, -HUGE_VAL };

        if (real_sign(poly_at(&f->inner, real_of(0.5 * (ends[i] + ends[i + 1])))) < 0 || out->count == KIND_CROSSINGS)
            continue;
        widen(f, ends[i], &s);
        widen(f, ends[i + 1], &s);
        for (int k = 0; k < m; k++)
            if (at[k] > ends[i] && at[k] < ends[i + 1])
                widen(f, at[k], &s);
        out->at[out->count++] = s;
    }
}

static int by_start(const void *a, const void *b)
{
    const stretch *s = a, *t = b;

    return (s->from > t->from) - (s->from < t->from);
}

static void report(double t, const along *a, answer *out)
{
    if (t > 0.0 && t < real_double(a->end) && out->count < KIND_CROSSINGS)
        out->at[out->count++] = t;
}

static void solve_sweep(const shape *s, const spline_basis *b, const along *a, answer *out)
{
    stretches in = { 0, { { 0.0, 0.0 } } };

    for (int i = 0; 4 * (i + b->points) <= s->count; i++) {
        const field f = field_of(b, s->number + 4 * i, a);

        add_piece(&f, &in);
    }
    qsort(in.at, (size_t)in.count, sizeof *in.at, by_start);
    for (int i = 0, next; i < in.count; i = next) {
        double to = in.at[i].to;

        for (next = i + 1; next < in.count && in.at[next].from <= to; next++)
            to = fmax(to, in.at[next].to);
        report(in.at[i].from, a, out);
        report(to, a, out);
    }
}

static void solve_straight(const shape *s, const along *a, answer *out) { solve_sweep(s, &spline_linear, a, out); }
static void solve_cubic(const shape *s, const along *a, answer *out) { solve_sweep(s, &spline_cubic, a, out); }
static void solve_b_spline(const shape *s, const along *a, answer *out) { solve_sweep(s, &spline_b, a, out); }

static const kind_row kinds[] = {
    { "sphere_sweep", make_straight, solve_straight }, { "sphere_sweep", make_cubic, solve_cubic },
    { "sphere_sweep", make_b_spline, solve_b_spline },
};

static void a_straight_sweep_has_its_crossings(void **state) { (void)state; kinds_keep_crossings(&kinds[0], rays); }
static void a_cubic_sweep_has_its_crossings(void **state) { (void)state; kinds_keep_crossings(&kinds[1], rays); }
static void a_sweep_along_a_b_spline_has_its_crossings(void **state) { (void)state; kinds_keep_crossings(&kinds[2], rays); }

/* Its chord of 1e-4 came out as 4e-8: the least entry and the greatest exit were roots that noise hid. */
static void a_ray_that_hardly_enters_a_sweep_keeps_its_chord(void **state)
{
    static const double at[5][4] = {
        { 0x1.ea390935b5a6p-6, -0x1.0690431de7dbbp-1, -0x1.21a8d9ef04c68p-4, 0x1.5a08cb663c40fp-2 },
        { -0x1.2eb34e4723e2p-3, -0x1.007bea698c179p-1, 0x1.88944a9191b7cp-2, 0x1.5baab57d23333p-2 },
        { 0x1.80ba32768142p-6, 0x1.5d6a1669293cp-1, -0x1.6951723b5fe2cp-3, 0x1.9127a927f03e4p-2 },
        { -0x1.939347ab6c82cp-3, 0x1.4001830cbb62ap-1, 0x1.388c74022c64cp-2, 0x1.45c0538b3e69ep-2 },
        { 0x1.0f4662ba15beep-1, -0x1.ec3d3f3988a2p-4, 0x1.28e5049689ddap-1, 0x1.5846df594e379p-2 },
    };
    const pov_ray ray = ray_from(pov_vec3_of(-0x1.2b083277ec11ep+2, 0x1.cb8ce46cf5231p-1, -0x1.91c8fc782ae76p-1),
                                 pov_vec3_of(0x1.ef3330540a52ep-1, 0x1.288cb686e6436p-6, 0x1.03801e790970fp-2));
    const shape_class *c = fake_reader_shape("sphere_sweep");
    pov_reader *in = fake_reader_create();
    union { char bytes[1 << 12]; double aligned; } scratch;
    pov_crossing found[4];
    pov_hits hits;
    void *self;

    (void)state;
    assert_non_null(c);
    fake_reader_text(in, "cubic_spline 5");
    for (int i = 0; i < 5; i++) {
        fake_reader_word(in, "<");
        for (int k = 0; k < 3; k++)
            fake_reader_number(in, at[i][k]);
        fake_reader_word(in, ">");
        fake_reader_number(in, at[i][3]);
    }
    self = fake_reader_parse(in, c);
    assert_non_null(self);
    hits = hits_to(HUGE_VAL, POV_WANT_ALL, found, 4);
    hits.scratch = &scratch;
    c->intersect(self, &ray, &hits);
    assert_int_equal(hits.count, 2);
    assert_true(fabs(fmin(found[0].t, found[1].t) - 4.5656203075542381) < 1e-9);
    assert_true(fabs(fmax(found[0].t, found[1].t) - 4.5657188572660337) < 1e-9);
    fake_reader_destroy(in);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_straight_sweep_has_its_crossings), cmocka_unit_test(a_cubic_sweep_has_its_crossings),
        cmocka_unit_test(a_sweep_along_a_b_spline_has_its_crossings),
        cmocka_unit_test(a_ray_that_hardly_enters_a_sweep_keeps_its_chord),
    };

    rays = long_run_rays(argc, argv, 2000);
    return cmocka_run_group_tests(tests, NULL, long_run_end);
}
