/* test_samples.c - asks the language for every value that was measured from POV-Ray: function { pattern { } } and #debug.
 *
 * samples.txt has values of patterns, tiles.txt those of tiles through pigments (floats), warps.txt where warps take points
 * to. */
#include "support/near.h"
#include "support/reading.h"
#include "support/samples.h"

#include <stdarg.h>
#include <stdlib.h>

enum { TEXT = 1 << 16, WARP_ROWS = 12 };

typedef struct text { char bytes[TEXT]; size_t used; } text;

static void put(text *t, const char *format, ...)
{
    va_list args;
    int n;

    va_start(args, format);
    n = vsnprintf(t->bytes + t->used, TEXT - t->used, format, args);
    va_end(args);
    assert_true(n >= 0 && (size_t)n < TEXT - t->used);
    t->used += (size_t)n;
}

static void read_text(reading *r, const text *t)
{
    reading_begin_bytes(r, t->bytes, t->used, NULL, NULL);
    if (r->status != POV_OK)
        fail_msg("%s", r->error.message);
}

/* The i-th number that the text printed. */
static double printed(const reading *r, uint32_t i)
{
    assert_true((int)i < r->note_count);
    return strtod(r->notes[i].message, NULL);
}

/* ---- patterns ---- */

/* `noise2` is a generator, `vturb.x 2.3 0.6 5` a component of vturbulence(), all else the text of a pattern. */
static void put_call(text *t, const samples *s, uint32_t i)
{
    char lambda[16] = "2", omega[16] = ".5", octaves[16] = "1";
    const pov_vec3 p = s->at[i];

    if (strncmp(s->text, "noise", 5) == 0) {
        put(t, "F(%.17g, %.17g, %.17g, %c)", p.x, p.y, p.z, s->text[5]);
    } else if (strncmp(s->text, "dnoise", 6) == 0 || strncmp(s->text, "vturb", 5) == 0) {
        sscanf(strchr(s->text, '.') + 2, "%15s %15s %15s", lambda, omega, octaves);
        put(t, "vturbulence(%s, %s, %s, <%.17g, %.17g, %.17g>).%c", lambda, omega, octaves, p.x, p.y, p.z,
            strchr(s->text, '.')[1]);
    } else {
        put(t, "F(%.17g, %.17g, %.17g)", p.x, p.y, p.z);
    }
}

static void check_pattern(const samples *s, double tolerance, uint32_t *rows)
{
    const bool is_noise = strncmp(s->text, "noise", 5) == 0;
    const bool is_vector = strncmp(s->text, "dnoise", 6) == 0 || strncmp(s->text, "vturb", 5) == 0;
    static text t;
    reading r;

    t.used = 0;
    put(&t, "#version 3.7;\n");
    if (is_noise)
        put(&t, "#declare F = function { internal(78) }\n");
    else if (!is_vector)
        put(&t, "#declare F = function { pattern { %s } }\n", s->text);
    for (uint32_t i = 0; i < s->count; i++) {
        put(&t, "#debug str(");
        put_call(&t, s, i);
        put(&t, ", 0, 17)\n");
    }
    read_text(&r, &t);
    for (uint32_t i = 0; i < s->count; i++, ++*rows)
        assert_near(printed(&r, i), s->value[i], tolerance);
    reading_end(&r);
}

static void every_pattern_has_its_measured_values(void **state)
{
    FILE *file = samples_open("samples.txt");
    uint32_t rows = 0;
    samples s;
    (void)state;

    while (samples_next(file, &s))
        check_pattern(&s, 1e-12, &rows);
    assert_int_equal(rows, 5034);
    fclose(file);
}

static void every_pavement_and_penroses_tilings_have_their_measured_values(void **state)
{
    FILE *file = samples_open("tiles.txt");
    uint32_t rows = 0;
    samples s;
    (void)state;

    while (samples_next(file, &s))
        check_pattern(&s, 2e-6, &rows);
    assert_int_equal(rows, 1077);
    fclose(file);
}

/* ---- warps ---- */

typedef struct warp_rows { char text[SAMPLES_TEXT]; double from[WARP_ROWS][3], to[WARP_ROWS][3]; } warp_rows;

static bool next_warp(FILE *file, warp_rows *w)
{
    if (fscanf(file, " : %159[^\n]", w->text) != 1)
        return false;
    for (int i = 0; i < WARP_ROWS; i++) {
        double *a = w->from[i], *b = w->to[i];

        assert_int_equal(fscanf(file, "%lf %lf %lf %lf %lf %lf", a, a + 1, a + 2, b, b + 1, b + 2), 6);
    }
    return true;
}

/* A gradient so long that nothing folds shows a coordinate of a point that was moved. */
static void check_warp(const warp_rows *w)
{
    static text t;
    reading r;

    t.used = 0;
    put(&t, "#version 3.7;\n");
    for (char axis = 'x'; axis <= 'z'; axis++)
        put(&t, "#declare F%c = function { pattern { gradient %c scale 100 translate -50 warp { %s } } }\n", axis, axis, w->text);
    for (int i = 0; i < WARP_ROWS; i++)
        for (char axis = 'x'; axis <= 'z'; axis++)
            put(&t, "#debug str(F%c(%.17g, %.17g, %.17g) * 100 - 50, 0, 17)\n", axis, w->from[i][0], w->from[i][1], w->from[i][2]);
    read_text(&r, &t);
    for (uint32_t i = 0; i < 3 * WARP_ROWS; i++)
        assert_near(printed(&r, i), w->to[i / 3][i % 3], 1e-10);
    reading_end(&r);
}

static void every_warp_moves_points_as_measured(void **state)
{
    FILE *file = fopen(TEST_ROOT "/tests/patterns/warps.txt", "r");
    warp_rows w;
    int count = 0;
    (void)state;

    assert_non_null(file);
    for (; next_warp(file, &w); count++)
        check_warp(&w);
    assert_int_equal(count, 34);
    fclose(file);
}

/* ---- formulas ---- */

static void formulas_ask_patterns_pigments_and_maps(void **state)
{
    reading r;
    (void)state;

    reading_begin(&r, "#version 3.7;\n"
                      "#declare P = function { pattern { granite scale 2 } }\n"
                      "#declare C = function { pigment { gradient x color_map { [0 rgb <0, .5, 1>] [1 rgb <1, .25, 0>] } } }\n"
                      "#declare T = function { transform { scale 2 translate <1, 2, 3> } }\n"
                      "#declare F = function(x, y) { P(x, y, .5) + 2 * C(x, 0, 0).red - C(.5, x, y).green + T(x, y, 7).z }\n"
                      "#debug str(F(.25, .75) - P(.25, .75, .5), 0, 15)\n"
                      "#declare N = function { internal(76) }\n"
                      "#declare G = function { N(x, 2 * y, z) * 2 - 1 }\n"
                      "#debug str(G(.3, .2, .1) - (2 * N(.3, .4, .1) - 1), 0, 15)\n");
    assert_int_equal(r.status, POV_OK);
    assert_near(printed(&r, 0), 2.0 * 0.25 - 0.375 + 17.0, 1e-6);   /* colours are floats */
    assert_near(printed(&r, 1), 0.0, 1e-15);
    reading_end(&r);
}

/* f_noise3d is noise as patterns have it: by the scene's generator, or the version's. */
static void noise_of_formulas_has_the_generator_of_the_scene(void **state)
{
    static const struct { const char *text; double value; } cases[] = {
        { "#version 3.7;", 0.4171920327 },
        { "#version 3.1;", 0.29924290901 },
        { "#version 3.7; global_settings { noise_generator 1 }", 0.29924290901 },
        { "#version 3.1; global_settings { noise_generator 3 }", 0.6522608537 },
    };
    (void)state;

    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        static text t;
        reading r;

        t.used = 0;
        put(&t, "%s\n#declare F = function { internal(76) }\n#declare G = function { pattern { bozo } }\n", cases[i].text);
        put(&t, "#debug str(F(.1, .2, .3), 0, 10)\n#debug str(G(.1, .2, .3), 0, 10)\n");
        read_text(&r, &t);
        assert_near(printed(&r, 0), cases[i].value, 1e-7);
        assert_near(printed(&r, 1), cases[i].value, 1e-7);
        reading_end(&r);
    }
}

/* As in POV-Ray: where images begin again the pixels to the right and above count, and one that is there once has all its
 * edges. */
static void images_begin_at_their_lower_left_corner(void **state)
{
    static const char *const words[] = { "", "once" };
    (void)state;

    for (int once = 0; once < 2; once++) {
        static text t;
        reading r;

        t.used = 0;
        put(&t, "#version 3.7;\n#declare F = function { pattern { image_pattern { function 8, 8 { .2 + .7*y - .1*x } %s } } }\n", words[once]);
        put(&t, "#debug str(F(.3, 0, 0) - F(.3, 1e-9, 0), 0, 9)\n#debug str(F(.3, 1, 0) - F(.3, 1e-9, 0), 0, 9)\n");
        put(&t, "#debug str(F(0, .3, 0) - F(1e-9, .3, 0), 0, 9)\n#debug str(F(1, .3, 0) - F(1e-9, .3, 0), 0, 9)\n");
        put(&t, "#debug str(F(1, 1, 0) - F(1e-9, 1e-9, 0), 0, 9)\n#debug str(F(.3, -1e-20, 0) - F(.3, 1e-9, 0) * %d, 0, 9)\n", !once);
        read_text(&r, &t);
        for (uint32_t i = 0; i < 6; i++)
            assert_near(printed(&r, i), 0.0, 1e-9);
        reading_end(&r);
    }
}

static void patterns_that_need_a_surface_have_no_function(void **state)
{
    static const char *const wrong[] = { "slope y", "average", "aoi" };
    (void)state;

    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        static text t;
        reading r;

        t.used = 0;
        put(&t, "#version 3.7;\n#declare F = function { pattern { %s } }\n", wrong[i]);
        reading_begin_bytes(&r, t.bytes, t.used, NULL, NULL);
        assert_int_equal(r.status, POV_E_SYNTAX);
        reading_end(&r);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_pattern_has_its_measured_values),
        cmocka_unit_test(every_pavement_and_penroses_tilings_have_their_measured_values),
        cmocka_unit_test(every_warp_moves_points_as_measured),
        cmocka_unit_test(formulas_ask_patterns_pigments_and_maps),
        cmocka_unit_test(noise_of_formulas_has_the_generator_of_the_scene),
        cmocka_unit_test(images_begin_at_their_lower_left_corner),
        cmocka_unit_test(patterns_that_need_a_surface_have_no_function),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
