/* test_outlines.c - shapes with an outline of splines: lathes, prisms along both sweeps, and text, by polynomials of the outline's
 * parameter in 512 bits: each crossing that is there is found, and no other (numerics/kinds.h). test_outlines RAYS for a long run
 * of each. */
#include "numerics/draw.h"
#include "numerics/font.h"
#include "numerics/long_run.h"
#include "numerics/spline_real.h"

#include "support/check.h"
#include "support/fake_reader.h"
#include "support/rays.h"

#include <stdio.h>
#include <stdlib.h>

static long rays;

static void put_number(shape *s, pov_reader *in, double number)
{
    s->number[s->count++] = number;
    fake_reader_number(in, number);
}

static void put_point(shape *s, pov_reader *in, double x, double y)
{
    fake_reader_word(in, "<");
    put_number(s, in, x);
    put_number(s, in, y);
    fake_reader_word(in, ">");
}

/* ---- lathes ---- */

/* Some have points that are the same, on the axis, or at one height; and some more pieces than are looked at side by side. */
static void make_lathe(shape *s, pov_reader *in, const spline_basis *b)
{
    const int pieces = U() < 0.2 ? 9 + (int)(3.0 * U()) : 1 + (int)(3.0 * U()), n = b == &spline_bezier ? 4 * pieces : pieces + b->points - 1;
    double r = 0.5, y = -1.0;

    s->count = 0;
    fake_reader_word(in, b->keyword);
    fake_reader_number(in, n);
    for (int i = 0; i < n; i++) {
        const bool repeats = b == &spline_bezier ? i > 0 && i % 4 == 0 : U() < 0.1;

        r = repeats ? r : U() < 0.1 ? 0.0 : between(0.0, 1.0);
        y = repeats || U() < 0.1 ? y : between(-1.0, 1.0);
        put_point(s, in, r, y);
    }
}

static void make_quadratic_lathe(shape *s, pov_reader *in) { make_lathe(s, in, &spline_quadratic); }
static void make_cubic_lathe(shape *s, pov_reader *in) { make_lathe(s, in, &spline_cubic); }
static void make_bezier_lathe(shape *s, pov_reader *in) { make_lathe(s, in, &spline_bezier); }

static poly_real square_off(const poly_real *line, const poly_real *rise, real speed)
{
    const poly_real start = poly_of(real_mul(line->c[0], speed)), way = poly_scale(rise, line->c[1]), p = poly_add(&start, &way);

    return poly_mul(&p, &p);
}

static void put_level(const poly_real *r, real u, const along *a, answer *out)
{
    const real square = real_add(real_mul(a->x.c[1], a->x.c[1]), real_mul(a->z.c[1], a->z.c[1])), radius = poly_at(r, u);
    const real half = real_add(real_mul(a->x.c[0], a->x.c[1]), real_mul(a->z.c[0], a->z.c[1]));
    const real off = real_add(real_mul(a->x.c[0], a->x.c[0]), real_mul(a->z.c[0], a->z.c[0]));
    const real inner = real_sub(real_mul(half, half), real_mul(square, real_sub(off, real_mul(radius, radius))));

    for (int sign = -1; real_sign(inner) > 0 && sign <= 1; sign += 2) {
        const real t = real_div(real_sub(real_mul(real_of(sign), real_sqrt(inner)), half), square);

        if (real_sign(t) > 0 && real_compare(t, a->end) < 0 && out->count < KIND_CROSSINGS)
            out->at[out->count++] = real_double(t);
    }
}

/* Of a ray that does not rise the height alone says where. */
static void cross_level(const poly_real *r, const poly_real *y, const along *a, answer *out)
{
    const poly_real start = poly_of(a->y.c[0]);
    const poly_piece piece = { poly_sub(y, &start), real_of(0.0), real_of(1.0) };
    double u[3];
    const int n = poly_roots(&piece, u, 3);

    for (int k = 0; k < n; k++)
        put_level(r, real_of(u[k]), a, out);
}

/* Where the ray has the height y(u) its distance to the axis is |r(u)|; times the square of how fast it rises. */
static void cross_lathe(const poly_real *r, const poly_real *y, const along *a, answer *out)
{
    const poly_real start = poly_of(a->y.c[0]), rise = poly_sub(y, &start), x = square_off(&a->x, &rise, a->y.c[1]);
    const poly_real z = square_off(&a->z, &rise, a->y.c[1]), square = poly_mul(r, r), across = poly_add(&x, &z);
    const poly_real radius = poly_scale(&square, real_mul(a->y.c[1], a->y.c[1]));
    const poly_piece piece = { poly_sub(&across, &radius), real_of(0.0), real_of(1.0) };
    double u[6];
    const int n = poly_roots(&piece, u, 6);

    for (int k = 0; k < n; k++) {
        const real t = real_div(poly_at(&rise, real_of(u[k])), a->y.c[1]);

        if (real_sign(t) > 0 && real_compare(t, a->end) < 0 && out->count < KIND_CROSSINGS)
            out->at[out->count++] = real_double(t);
    }
}

/* An end of the curve that is no other's is a rim. */
static void near_rim(const double *p, const along *a, answer *out)
{
    const bool level = real_sign(a->y.c[1]) == 0;
    const real t = level ? real_of(0.0) : real_div(real_sub(real_of(p[1]), a->y.c[0]), a->y.c[1]), x = poly_at(&a->x, t), z = poly_at(&a->z, t);
    const double across = sqrt(real_double(real_add(real_mul(x, x), real_mul(z, z))));

    out->open = out->open || (level ? p[1] == real_double(a->y.c[0]) : fabs(across - fabs(p[0])) < KIND_TOUCH);
}

static void solve_lathe(const shape *s, const spline_basis *b, const along *a, answer *out)
{
    for (int i = 0; 2 * (i + b->points) <= s->count; i += b->step) {
        const double *p = s->number + 2 * i;
        const poly_real r = spline_piece(b, p, 2), y = spline_piece(b, p + 1, 2);

        near_rim(p + 2 * b->first, a, out);
        near_rim(p + (b == &spline_bezier ? 6 : 2 * b->first + 2), a, out);
        (real_sign(a->y.c[1]) == 0 ? cross_level : cross_lathe)(&r, &y, a, out);
    }
}

static void solve_quadratic_lathe(const shape *s, const along *a, answer *out) { solve_lathe(s, &spline_quadratic, a, out); }
static void solve_cubic_lathe(const shape *s, const along *a, answer *out) { solve_lathe(s, &spline_cubic, a, out); }
static void solve_bezier_lathe(const shape *s, const along *a, answer *out) { solve_lathe(s, &spline_bezier, a, out); }

/* ---- prisms ---- */

/* A ring about a place, either way around; numbers of its points one after the other. */
static int draw_ring(double *at, int n, double x, double y, double size)
{
    const double turn = either(6.28318530717958648 / n), first = between(0.0, 6.0);

    for (int i = 0; i < n; i++) {
        const double r = size * between(0.4, 1.0);

        at[2 * i] = x + r * cos(first + i * turn);
        at[2 * i + 1] = y + r * sin(first + i * turn);
    }
    return n;
}

/* Of its points in order those from the last one on, as many as a closed curve has: of Beziers with two points in between. */
static void write_ring(const spline_basis *b, const double *at, int n, double *out, int *count)
{
    const int many = b == &spline_bezier ? 4 * n : n + b->points - 1;

    for (int i = 0; i < many; i++, ++*count) {
        const int from = b == &spline_bezier ? i / 4 : (i + n - b->first) % n, to = (from + 1) % n, third = b == &spline_bezier ? i % 4 : 0;

        for (int k = 0; k < 2; k++) {
            const double off = third == 1 || third == 2 ? between(-0.2, 0.2) : 0.0, p = at[2 * from + k], q = at[2 * to + k];

            out[2 * *count + k] = third == 0 ? p : third == 3 ? q : p + (q - p) * third / 3.0 + off;
        }
    }
}

/* Numbers: heights, how many points the first ring has, then the points. */
static void make_prism(shape *s, pov_reader *in, const spline_basis *b, bool conic)
{
    const int rings = U() < 0.4 ? 2 : 1;
    double at[16], low = conic ? either(between(0.1, 0.4)) : between(-0.8, 0.0);
    int count = 0;

    s->count = 0;
    fake_reader_word(in, conic ? "conic_sweep" : "linear_sweep");
    fake_reader_word(in, b->keyword);
    put_number(s, in, conic && U() < 0.1 ? 0.0 : low);
    put_number(s, in, between(0.5, 1.2));
    for (int i = 0; i < rings; i++) {
        const int n = draw_ring(at, 3 + (int)(4.0 * U()), i == 0 ? 0.0 : between(-0.3, 0.3), 0.0, i == 0 ? 1.0 : 0.4);

        write_ring(b, at, n, s->number + 3, &count);
        s->number[2] = i == 0 ? count : s->number[2];
    }
    fake_reader_number(in, count);
    s->count = 3;
    for (int i = 0; i < count; i++)
        put_point(s, in, s->number[s->count], s->number[s->count + 1]);
}

static void solve_prism(const shape *s, const spline_basis *b, bool conic, const along *a, answer *out)
{
    const int first = (int)s->number[2], all = (s->count - 3) / 2;
    swept_real swept = { .count = 0, .low = s->number[0], .high = s->number[1], .conic = conic };

    for (int i = 0; i + b->points <= all; i += b->step) {
        const double *p = s->number + 3 + 2 * i;

        if (i < first && i + b->points > first)      /* between two rings */
            continue;
        swept.x[swept.count] = spline_piece(b, p, 2);
        swept.y[swept.count++] = spline_piece(b, p + 1, 2);
    }
    swept_solve(&swept, &a->x, &a->z, &a->y, a->end, out);
}

#define PRISM(name, basis, conic)                                                                                            \
    static void make_##name(shape *s, pov_reader *in) { make_prism(s, in, basis, conic); }                                   \
    static void solve_##name(const shape *s, const along *a, answer *out) { solve_prism(s, basis, conic, a, out); }

PRISM(straight, &spline_linear, false)
PRISM(quadratic, &spline_quadratic, false)
PRISM(cubic, &spline_cubic, false)
PRISM(bezier, &spline_bezier, false)
PRISM(straight_cone, &spline_linear, true)
PRISM(quadratic_cone, &spline_quadratic, true)
PRISM(cubic_cone, &spline_cubic, true)
PRISM(bezier_cone, &spline_bezier, true)

/* ---- text ---- */

/* A font of one glyph, whose outline is drawn by chance; numbers: the depth, and six for each piece. */
static void make_text(shape *s, pov_reader *in)
{
    static font one;

    font_make(&one, U);
    fake_reader_file(in, one.bytes, one.size);
    s->count = 0;
    fake_reader_text(in, "ttf font A");
    put_number(s, in, between(0.1, 1.0));
    fake_reader_number(in, 0.0);
    for (int i = 0; i < one.pieces; i++)
        for (int k = 0; k < 6; k++)
            s->number[s->count++] = one.piece[i][k];
}

/* A coordinate of a piece of the second order over its parameter. */
static poly_real bezier(double a, double b, double c)
{
    poly_real p;

    p.degree = 2;
    p.c[0] = real_of(a);
    p.c[1] = real_of(2.0 * (b - a));
    p.c[2] = real_of(a - 2.0 * b + c);
    return p;
}

static void solve_text(const shape *s, const along *a, answer *out)
{
    swept_real swept = { .count = 0, .low = 0.0, .high = s->number[0], .conic = false };

    for (int i = 1; i + 6 <= s->count; i += 6) {
        const double *c = s->number + i;

        swept.x[swept.count] = bezier(c[0], c[2], c[4]);
        swept.y[swept.count++] = bezier(c[1], c[3], c[5]);
    }
    swept_solve(&swept, &a->x, &a->y, &a->z, a->end, out);
}

static const kind_row lathes[] = {
    { "lathe", make_quadratic_lathe, solve_quadratic_lathe }, { "lathe", make_cubic_lathe, solve_cubic_lathe },
    { "lathe", make_bezier_lathe, solve_bezier_lathe },
};
static const kind_row prisms[] = {
    { "prism", make_straight, solve_straight }, { "prism", make_quadratic, solve_quadratic }, { "prism", make_cubic, solve_cubic },
    { "prism", make_bezier, solve_bezier }, { "prism", make_straight_cone, solve_straight_cone },
    { "prism", make_quadratic_cone, solve_quadratic_cone }, { "prism", make_cubic_cone, solve_cubic_cone },
    { "prism", make_bezier_cone, solve_bezier_cone },
};
static const kind_row text = { "text", make_text, solve_text };

static void a_quadratic_lathe_has_its_crossings(void **state) { (void)state; kinds_keep_crossings(&lathes[0], rays); }
static void a_cubic_lathe_has_its_crossings(void **state) { (void)state; kinds_keep_crossings(&lathes[1], rays); }
static void a_bezier_lathe_has_its_crossings(void **state) { (void)state; kinds_keep_crossings(&lathes[2], rays); }
static void a_straight_prism_has_its_crossings(void **state) { (void)state; kinds_keep_crossings(&prisms[0], rays); }
static void a_quadratic_prism_has_its_crossings(void **state) { (void)state; kinds_keep_crossings(&prisms[1], rays); }
static void a_cubic_prism_has_its_crossings(void **state) { (void)state; kinds_keep_crossings(&prisms[2], rays); }
static void a_bezier_prism_has_its_crossings(void **state) { (void)state; kinds_keep_crossings(&prisms[3], rays); }
static void a_straight_cone_has_its_crossings(void **state) { (void)state; kinds_keep_crossings(&prisms[4], rays); }
static void a_quadratic_cone_has_its_crossings(void **state) { (void)state; kinds_keep_crossings(&prisms[5], rays); }
static void a_cubic_cone_has_its_crossings(void **state) { (void)state; kinds_keep_crossings(&prisms[6], rays); }
static void a_bezier_cone_has_its_crossings(void **state) { (void)state; kinds_keep_crossings(&prisms[7], rays); }

static void text_has_its_crossings(void **state)
{
    (void)state;
    if (!fake_reader_shape(text.keyword))
        skip();
    kinds_keep_crossings(&text, rays);
}

/* Also where all of them are the one that stands for a missing one. The z of the offset that is added behind each counts for nothing,
 * as in POV-Ray. */
static void glyphs_of_a_text_stand_side_by_side_in_one_plane(void **state)
{
    const shape_class *c = fake_reader_shape("text");
    pov_reader *in = fake_reader_create();
    static font one;
    pov_box box;
    void *self;

    (void)state;
    if (!c)
        skip();
    families_seed(3);
    font_make(&one, U);
    fake_reader_file(in, one.bytes, one.size);
    fake_reader_text(in, "ttf font AAA 0.5 < 0.1 0.2 0.25 >");
    self = fake_reader_parse(in, c);
    assert_non_null(self);
    assert_true(c->bounds(self, &box));
    assert_true(fabs(box.lo.z) < 1e-9 && fabs(box.hi.z - 0.5) < 1e-9);
    assert_true(box.hi.x - box.lo.x > 2.2 && box.hi.y - box.lo.y > 0.4);
    fake_reader_destroy(in);
}

static void *parse_text(const shape_class *c, pov_reader *in, const font *of, const char *written)
{
    void *self;

    fake_reader_file(in, of->bytes, of->size);
    fake_reader_text(in, written);
    self = fake_reader_parse(in, c);
    assert_non_null(self);
    return self;
}

static uint32_t count_crossings(const shape_class *c, const void *self, const pov_ray *ray)
{
    static union { char bytes[1 << 16]; double aligned; } scratch;
    pov_crossing at[256];
    pov_hits hits = hits_to(HUGE_VAL, POV_WANT_ALL, at, 256);

    hits.scratch = &scratch;
    c->intersect(self, ray, &hits);
    return hits.count;
}

/* How many crossings a ray has with glyphs that stand `step` apart. */
static uint32_t count_of_each(const shape_class *c, const void *glyph, const pov_ray *ray, double step, int n)
{
    uint32_t sum = 0;

    for (int i = 0; i < n; i++) {
        const pov_ray moved = ray_from(pov_vec3_of(ray->org.x - step * i, ray->org.y, ray->org.z), ray->dir);

        sum += count_crossings(c, glyph, &moved);
    }
    return sum;
}

/* Boxes of glyphs are tested side by side: however many there are, a ray has the crossings that it has with each alone. */
static void check_long_text(const shape_class *c, const font *of, int n)
{
    static const char *const longest = "ttf font AAAAAAAAAAAAAAAAAAAAA 0.5 < 0.1 0 0 >";
    enum { MOST = 21, EACH = 2000 };
    pov_reader *in[3] = { fake_reader_create(), fake_reader_create(), fake_reader_create() };
    const void *const glyph = parse_text(c, in[0], of, "ttf font A 0.5 < 0.1 0 0 >");
    const void *const two = parse_text(c, in[1], of, "ttf font AA 0.5 < 0.1 0 0 >");
    uint32_t crossed = 0;
    char written[64];
    pov_box box[2];
    const void *line;

    snprintf(written, sizeof written, "ttf font %s", strchr(longest, 'A') + (MOST - n));
    line = parse_text(c, in[2], of, written);
    assert_true(c->bounds(glyph, &box[0]) && c->bounds(two, &box[1]));
    for (int i = 0; i < EACH; i++) {
        const double step = box[1].hi.x - box[0].hi.x;
        const pov_ray ray = ray_from(pov_vec3_of(between(-1.0, step * n), between(-0.2, 0.8), between(-0.1, 0.6)),
                                     pov_vec3_of(between(-3.0, 3.0), between(-1.0, 1.0), i % 2 ? between(-1.0, 1.0) : 0.0));
        const uint32_t count = count_of_each(c, glyph, &ray, step, n);

        assert_int_equal(count_crossings(c, line, &ray), count);
        crossed += count > 0;
    }
    assert_true(crossed > EACH / 10);
    for (int i = 0; i < 3; i++)
        fake_reader_destroy(in[i]);
}

static void a_long_text_is_crossed_where_its_glyphs_are(void **state)
{
    static const int lengths[] = { 1, 2, 3, 8, 9, 11, 16, 21 };
    const shape_class *c = fake_reader_shape("text");
    static font one;

    (void)state;
    if (!c)
        skip();
    families_seed(5);
    font_make(&one, U);
    for (size_t i = 0; i < sizeof lengths / sizeof *lengths; i++)
        check_long_text(c, &one, lengths[i]);
}

/* A glyph without an outline counts as the place where it begins, as in POV-Ray: the line is as long as up to there. */
static void blanks_count_for_the_box_of_a_text(void **state)
{
    static const char *const texts[] = { "ttf font AA 0.5 < 0.7 0.2 0 >", "ttf font AA_ 0.5 < 0.7 0.2 0 >" };
    const shape_class *c = fake_reader_shape("text");
    pov_box box[2];

    (void)state;
    if (!c)
        skip();
    for (int i = 0; i < 2; i++) {
        pov_reader *in = fake_reader_create();
        static font one;
        void *self;

        families_seed(3);
        font_make(&one, U);
        fake_reader_file(in, one.bytes, one.size);
        fake_reader_text(in, texts[i]);
        self = fake_reader_parse(in, c);
        assert_non_null(self);
        assert_true(c->bounds(self, &box[i]));
        fake_reader_destroy(in);
    }
    assert_true(box[0].lo.x == box[1].lo.x);
    assert_true(box[1].hi.x > box[0].hi.x + 0.1);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_quadratic_lathe_has_its_crossings), cmocka_unit_test(a_cubic_lathe_has_its_crossings),
        cmocka_unit_test(a_bezier_lathe_has_its_crossings), cmocka_unit_test(a_straight_prism_has_its_crossings),
        cmocka_unit_test(a_quadratic_prism_has_its_crossings), cmocka_unit_test(a_cubic_prism_has_its_crossings),
        cmocka_unit_test(a_bezier_prism_has_its_crossings), cmocka_unit_test(a_straight_cone_has_its_crossings),
        cmocka_unit_test(a_quadratic_cone_has_its_crossings), cmocka_unit_test(a_cubic_cone_has_its_crossings),
        cmocka_unit_test(a_bezier_cone_has_its_crossings), cmocka_unit_test(text_has_its_crossings),
        cmocka_unit_test(glyphs_of_a_text_stand_side_by_side_in_one_plane),
        cmocka_unit_test(a_long_text_is_crossed_where_its_glyphs_are), cmocka_unit_test(blanks_count_for_the_box_of_a_text),
    };

    rays = long_run_rays(argc, argv, 2000);
    return cmocka_run_group_tests(tests, NULL, long_run_end);
}
