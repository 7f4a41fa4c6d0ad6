/* model/transform: composed maps and their inverses against MPFR at 300 bits. */
#include "support/check.h"

#include "model/transform.h"

#include <mpfr.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { BITS = 300 };

typedef struct big_map { mpfr_t at[3][4]; } big_map;

static void big_init(big_map *m)
{
    int i, j;

    for (i = 0; i < 3; i++)
        for (j = 0; j < 4; j++) {
            mpfr_init2(m->at[i][j], BITS);
            mpfr_set_d(m->at[i][j], i == j, MPFR_RNDN);
        }
}

static void big_clear(big_map *m)
{
    int i, j;

    for (i = 0; i < 3; i++)
        for (j = 0; j < 4; j++)
            mpfr_clear(m->at[i][j]);
}

/* m = step after m. */
static void big_join(big_map *m, const big_map *step)
{
    big_map r;
    mpfr_t p;
    int i, j, k;

    big_init(&r);
    mpfr_init2(p, BITS);
    for (i = 0; i < 3; i++)
        for (j = 0; j < 4; j++) {
            mpfr_set(r.at[i][j], step->at[i][3], MPFR_RNDN);
            if (j < 3)
                mpfr_set_d(r.at[i][j], 0.0, MPFR_RNDN);
            for (k = 0; k < 3; k++) {
                mpfr_mul(p, step->at[i][k], m->at[k][j], MPFR_RNDN);
                mpfr_add(r.at[i][j], r.at[i][j], p, MPFR_RNDN);
            }
        }
    for (i = 0; i < 3; i++)
        for (j = 0; j < 4; j++)
            mpfr_set(m->at[i][j], r.at[i][j], MPFR_RNDN);
    mpfr_clear(p);
    big_clear(&r);
}

static void big_sincos(mpfr_t s, mpfr_t c, double degrees)
{
    mpfr_t x;

    mpfr_init2(x, BITS);
    mpfr_const_pi(x, MPFR_RNDN);
    mpfr_mul_d(x, x, degrees, MPFR_RNDN);
    mpfr_div_ui(x, x, 180, MPFR_RNDN);
    mpfr_sin_cos(s, c, x, MPFR_RNDN);
    mpfr_clear(x);
}

static void big_rotate(big_map *m, int axis, double degrees)
{
    int u = (axis + 1) % 3, v = (axis + 2) % 3;
    big_map step;

    big_init(&step);
    big_sincos(step.at[v][u], step.at[u][u], degrees);
    mpfr_set(step.at[v][v], step.at[u][u], MPFR_RNDN);
    mpfr_neg(step.at[u][v], step.at[v][u], MPFR_RNDN);
    big_join(m, &step);
    big_clear(&step);
}

static void big_apply(big_map *m, transform_kind kind, const double *v)
{
    big_map step;
    int i, j;

    if (kind == TRANSFORM_ROTATE) {
        for (i = 0; i < 3; i++)
            big_rotate(m, i, v[i]);
        return;
    }
    big_init(&step);
    for (i = 0; i < 3; i++) {
        if (kind == TRANSFORM_TRANSLATE)
            mpfr_set_d(step.at[i][3], v[i], MPFR_RNDN);
        else if (kind == TRANSFORM_SCALE)
            mpfr_set_d(step.at[i][i], v[i], MPFR_RNDN);
        else
            for (j = 0; j < 4; j++)
                mpfr_set_d(step.at[i][j], v[3 * j + i], MPFR_RNDN);
    }
    big_join(m, &step);
    big_clear(&step);
}

/* |(hi + lo) - exact| relative to `size`. */
static double error_of(double hi, double lo, mpfr_t exact, double size)
{
    mpfr_t d;
    double e;

    mpfr_init2(d, BITS);
    mpfr_set_d(d, hi, MPFR_RNDN);
    mpfr_add_d(d, d, lo, MPFR_RNDN);
    mpfr_sub(d, d, exact, MPFR_RNDN);
    e = fabs(mpfr_get_d(d, MPFR_RNDN));
    mpfr_clear(d);
    return size > 0.0 ? e / size : e;
}

static double uniform(double lo, double hi)
{
    return lo + (hi - lo) * ((double)rand() / RAND_MAX);
}

static double log_uniform(double lo, double hi)
{
    double x = pow(10.0, uniform(lo, hi));

    return rand() & 1 ? x : -x;
}

/* ---- the tests ---- */

static void sine_and_cosine_are_right_to_98_bits(void **state)
{
    double s[2], c[2], degrees, worst = 0.0;
    mpfr_t es, ec;
    int i;

    (void)state;
    mpfr_inits2(BITS, es, ec, (mpfr_ptr)0);
    for (i = 0; i < 20000; i++) {
        degrees = i < 1000 ? i - 500.0 : i < 10000 ? uniform(-400.0, 400.0) : log_uniform(-12.0, 6.0);
        transform_sincos(degrees, s, c);
        big_sincos(es, ec, degrees);
        if (fmod(degrees, 90.0) == 0.0) {
            assert_true(s[0] == rint(s[0]) && s[1] == 0.0 && c[0] == rint(c[0]) && c[1] == 0.0);
            continue;
        }
        worst = fmax(worst, error_of(s[0], s[1], es, fabs(s[0])));
        worst = fmax(worst, error_of(c[0], c[1], ec, fabs(c[0])));
    }
    mpfr_clears(es, ec, (mpfr_ptr)0);
    print_message("worst relative error 2^%.1f\n", log2(worst));
    assert_true(worst < ldexp(1.0, -98));
}

static const transform *random_list(arena *memory, big_map *exact, int length, double stiffness)
{
    const transform *list = NULL;
    double v[12];
    int i, k, kind;

    for (i = 0; i < length; i++) {
        kind = rand() % 3;
        for (k = 0; k < 3; k++)
            v[k] = kind == TRANSFORM_ROTATE ? uniform(-360.0, 360.0) : log_uniform(-stiffness, stiffness);
        list = transform_append(memory, list, (transform_kind)kind, v);
        assert_non_null(list);
        big_apply(exact, (transform_kind)kind, v);
    }
    return list;
}

/* An entry may be small against what it is the sum of, so rows are measured by their largest entry. */
static double worst_of(double hi[3][4], double lo[3][4], big_map *exact)
{
    double worst = 0.0, size;
    int i, j;

    for (i = 0; i < 3; i++) {
        size = 0.0;
        for (j = 0; j < 3; j++)
            size = fmax(size, fabs(hi[i][j]));
        for (j = 0; j < 3; j++)
            worst = fmax(worst, error_of(hi[i][j], lo[i][j], exact->at[i][j], size));
    }
    return worst;
}

static void composed_maps_are_exact_to_double_double(void **state)
{
    env e;
    arena memory;
    pov_affine f;
    big_map exact;
    double worst = 0.0;
    int i;

    (void)state;
    env_init(&e, NULL, NULL, NULL);
    srand(1);
    for (i = 0; i < 1000; i++) {
        const transform *list;
        arena_init(&memory, &e);
        big_init(&exact);
        list = random_list(&memory, &exact, 1 + i % 5, 0.5);
        assert_true(transform_compose(list, &f));
        worst = fmax(worst, worst_of(f.m, f.m_lo, &exact));
        big_clear(&exact);
        arena_free(&memory);
    }
    print_message("worst error against the row's largest entry 2^%.1f\n", log2(worst));
    assert_true(worst < ldexp(1.0, -98));
}

/* inverse (map p) = p, in MPFR, for stiff lists: relative to the sizes that the products pass through. */
static double round_trip(const pov_affine *f)
{
    mpfr_t sum, p, a;
    double worst = 0.0, size;
    int i, j, k;

    mpfr_inits2(BITS, sum, p, a, (mpfr_ptr)0);
    for (i = 0; i < 3; i++)
        for (j = 0; j < 4; j++) {
            mpfr_set_d(sum, j == 3 ? f->inv[i][3] : 0.0, MPFR_RNDN);
            if (j == 3)
                mpfr_add_d(sum, sum, f->inv_lo[i][3], MPFR_RNDN);
            size = fabs(mpfr_get_d(sum, MPFR_RNDN));
            for (k = 0; k < 3; k++) {
                mpfr_set_d(a, f->inv[i][k], MPFR_RNDN);
                mpfr_add_d(a, a, f->inv_lo[i][k], MPFR_RNDN);
                mpfr_set_d(p, f->m[k][j], MPFR_RNDN);
                mpfr_add_d(p, p, f->m_lo[k][j], MPFR_RNDN);
                mpfr_mul(p, p, a, MPFR_RNDN);
                size = fmax(size, fabs(mpfr_get_d(p, MPFR_RNDN)));
                mpfr_add(sum, sum, p, MPFR_RNDN);
            }
            mpfr_sub_ui(sum, sum, i == j, MPFR_RNDN);
            worst = fmax(worst, fabs(mpfr_get_d(sum, MPFR_RNDN)) / size);
        }
    mpfr_clears(sum, p, a, (mpfr_ptr)0);
    return worst;
}

static void the_inverse_undoes_stiff_maps(void **state)
{
    env e;
    arena memory;
    pov_affine f;
    big_map unused;
    double worst = 0.0;
    int i;

    (void)state;
    env_init(&e, NULL, NULL, NULL);
    srand(2);
    for (i = 0; i < 1000; i++) {
        const transform *list;
        arena_init(&memory, &e);
        big_init(&unused);
        list = random_list(&memory, &unused, 1 + i % 4, 9.0);
        assert_true(transform_compose(list, &f));
        worst = fmax(worst, round_trip(&f));
        big_clear(&unused);
        arena_free(&memory);
    }
    print_message("worst round trip against the largest product 2^%.1f\n", log2(worst));
    assert_true(worst < ldexp(1.0, -96));
}

static void a_matrix_composes_like_what_it_spells(void **state)
{
    static const double quarter[3] = { 0, 0, 90 }, move[3] = { 1e9, -3, 0.1 }, definite_pair[3] = { 2, 2, 2 };
    static const double same[12] = { 0, 2, 0, -2, 0, 0, 0, 0, 2, 1e9, -3, 0.1 };
    env e;
    arena memory;
    pov_affine a, b;
    const transform *list;

    (void)state;
    env_init(&e, NULL, NULL, NULL);
    arena_init(&memory, &e);
    list = transform_append(&memory, NULL, TRANSFORM_ROTATE, quarter);
    list = transform_append(&memory, list, TRANSFORM_SCALE, definite_pair);
    list = transform_append(&memory, list, TRANSFORM_TRANSLATE, move);
    assert_true(transform_compose(list, &a));
    assert_true(transform_compose(transform_append(&memory, NULL, TRANSFORM_MATRIX, same), &b));
    assert_memory_equal(a.m, b.m, sizeof a.m);
    assert_true(a.inv[0][1] == b.inv[0][1] && a.inv[1][0] == b.inv[1][0] && a.inv[0][3] == b.inv[0][3]);
    arena_free(&memory);
}

static void what_changes_nothing_is_not_kept(void **state)
{
    static const double zero[3] = { 0, 0, 0 }, one[3] = { 1, 1, 1 }, turns[3] = { 360, -720, 0 };
    env e;
    arena memory;

    (void)state;
    env_init(&e, NULL, NULL, NULL);
    arena_init(&memory, &e);
    assert_null(transform_append(&memory, NULL, TRANSFORM_TRANSLATE, zero));
    assert_null(transform_append(&memory, NULL, TRANSFORM_SCALE, one));
    assert_null(transform_append(&memory, NULL, TRANSFORM_ROTATE, turns));
    arena_free(&memory);
}

static void singular_matrices_are_refused(void **state)
{
    static const double flat[12] = { 1, 2, 3, 2, 4, 6, 0, 0, 1, 5, 5, 5 };
    static const double huge[12] = { 1e308, 0, 0, 0, 1e-308, 0, 0, 0, 1, 0, 0, 0 };
    env e;
    arena memory;
    pov_affine f;

    (void)state;
    env_init(&e, NULL, NULL, NULL);
    arena_init(&memory, &e);
    assert_false(transform_compose(transform_append(&memory, NULL, TRANSFORM_MATRIX, flat), &f));
    assert_false(transform_compose(transform_append(&memory, NULL, TRANSFORM_MATRIX, huge), &f));
    arena_free(&memory);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sine_and_cosine_are_right_to_98_bits),
        cmocka_unit_test(composed_maps_are_exact_to_double_double),
        cmocka_unit_test(the_inverse_undoes_stiff_maps),
        cmocka_unit_test(a_matrix_composes_like_what_it_spells),
        cmocka_unit_test(what_changes_nothing_is_not_kept),
        cmocka_unit_test(singular_matrices_are_refused),
    };

    return cmocka_run_group_tests_name("transform", tests, NULL, NULL);
}
