/* sdl: a rich scene cut off anywhere, and memory that ends anywhere. */
#include "support/check.h"
#include "support/reading.h"
#include "sdl/lex.h"

#include <stdlib.h>
#include <string.h>

static const char scene[] =
    "#version 3.7; // caf\xC3\xA9\r\n"
    "global_settings { assumed_gamma 1.0 ambient_light rgb <.1, .2, .3> max_trace_level 7 adc_bailout 1e-3 "
    "}\n"
    "background { color rgb <.5, .5, 1> }\n"
    "camera {\n\tlocation <0, 1.5e0, -5> look_at <0, 0, 0>\n\tangle 40 sky <0, 1, 0> right <1, 0, 0> "
    "translate 1 }\n"
    "/* a /* nested */ comment */ light_source { <1, 2 3>, color red 1 green .5 rotate <0, 90, 0> }\n"
    "sphere { <1, 2, 3>, 4 texture { pigment { colour rgbf <1, 1, 1, .5> } finish { phong .5 metallic } } "
    "hollow }\n"
    "box { <-1, -1, -1> 1 pigment { rgb 1 transmit .25 } scale <1, 2, 3> matrix <1,0,0,0,1,0,0,0,1,4,5,6> }\n"
    "cone { 0, 1, <0, 1, 0>, 2 open no_shadow } cylinder { 0 1, .5 inverse interior { ior 1.5 } }\n"
    "quadric { <1, 2, 3>, <4, 5, 6>, <7, 8, 9>, -10 finish { reflection <.1, .2, .3> ambient 0 } }\n"
    "polygon { 4, <0, 0, 0>, <1, 0, 0>, <1, 1, 0>, <0, 0, 0> rotate 45 }\n"
    "blob7 { power 3 (4) }";

/* A program in the language: each kind of value, directive and macro. */
static const char language[] =
    "#version 3.7; #declare A = array[2][2] { { 1, 2 }, { 3, 4 } }; #local S = concat(\"a\", str(A[1][0], 0, 2));\n"
    "#macro Row(N, What) #local K = 0; #while (K < N) What #local K = K + 1; #end #end\n"
    "#declare B = A; #declare B[0][1] = vlength(<A[0][0], 2>) * 3;\n"
    "#declare F = function (a, b) { a*b + sum(i, 1, 3, max(i, a, select(b, 1, 2))) } #declare G = function { F(x, y) }\n"
    "#declare P = spline { natural_spline 0, x, 1, y, 2, <1, 2, 3> } #declare T = transform { rotate 30*y inverse }\n"
    "#declare Tex = texture { pigment { checker rgb 1, rgb <1, 0, 0> } finish { phong 1 } } texture { pigment { rgbt 1 } }\n"
    "#declare M = color_map { [0 rgb 0] [1 rgb 1] } #declare Globe = sphere { 0, F(1, 2) texture { Tex } transform T }\n"
    "#fopen Out \"t.txt\" write #write (Out, \"sphere {0,\", 3, \"}//\", x) #fclose Out #include \"t.txt\" #include \"t.txt\" #include \"t.txt\"\n"
    "#for (I, 1, 3) #switch (I) #case (2) union { object { Globe } Globe translate P(.5) } #break #else Row(I, Globe) #end #end\n"
    "#if (defined(Nobody) | G(1, 2, 3) > 1e9) nonsense #else camera { bokeh { rand(seed(1)), { 1 } } } #end #undef B\n"
    "#default { finish { ambient .2 } } #debug concat(S, chr(65), substr(S, 1, 2), strupr(S), vstr(3, x, \",\", 0, 2))\n"
    "difference { box { -1, 1 } sphere { 0, 1.2 } pigment { rgb .5 } } #warning \"w\" light_source { 0, rgb 1 }\n"
    "#declare N = y; box { trace(Globe, -5*z, z, N), 2 + N + max_extent(Globe) }\n";

/* The first length bytes: read or refused with a place within them, in any case without a read beyond them.
 * */
static bool try_first(size_t length, reading *r)
{
    char *exact = malloc(length ? length : 1);

    assert_non_null(exact);
    memcpy(exact, scene, length);
    reading_begin_bytes(r, exact, length, NULL, NULL);
    free(exact);
    if (r->status == POV_OK)
        return true;
    assert_true(r->status == POV_E_SYNTAX ||
                r->status == POV_E_UNSUPPORTED || /* of no_shadow, "no" is a word to come */
                r->status == POV_E_PLUGIN); /* of polygon, "poly" is a primitive */
    assert_string_equal(r->error.file, "scene.pov");
    assert_true(r->error.message[0] != '\0');
    return false;
}

/* The line and column of a byte of the scene, counted by hand. */
static void locate(size_t at, int *line, int *column)
{
    size_t i;

    *line = *column = 1;
    for (i = 0; i < at; i++) {
        (*column)++;
        if (scene[i] == '\n') {
            (*line)++;
            *column = 1;
        }
    }
}

static void the_whole_scene_is_read(void **state)
{
    reading r;

    (void)state;
    reading_begin(&r, scene);
    if (r.status != POV_OK)
        fail_msg("%d:%d %s", r.error.line, r.error.column, r.error.message);
    assert_int_equal(r.model.leaves.count, 7);
    assert_int_equal(r.model.lights.count, 1);
    assert_int_equal(r.model.warnings, 0);
    reading_end(&r);
}

static void a_scene_cut_at_any_byte_is_read_or_refused(void **state)
{
    size_t length, read = 0;
    int line, column;

    (void)state;
    for (length = 0; length < sizeof scene - 1; length++) {
        reading r;

        if (try_first(length, &r)) {
            read++;
        } else {
            locate(length, &line, &column);
            if (r.error.line < 1 || r.error.line > line || r.error.column < 1 ||
                (r.error.line == line && r.error.column > column))
                fail_msg("cut at %d:%d gave %d:%d %s", line, column, r.error.line, r.error.column,
                         r.error.message);
        }
        reading_end(&r);
    }
    /* Between statements, and within the blanks and comments there, nothing is missing. */
    assert_in_range(read, 12, 80);
}

/* Cut before a token, within braces: the place is just behind the token before. */
static void a_scene_cut_at_any_token_says_what_is_missing_and_where(void **state)
{
    int depth = 0, line = 1, column = 1;
    env e;
    symbols words;
    source_list sources;
    source *s;
    token t;

    (void)state;
    env_init(&e, NULL, NULL, NULL);
    assert_true(symbols_init(&words, &e));
    source_init(&sources, &e);
    s = source_add(&sources, scene, sizeof scene - 1, "scene.pov");
    assert_non_null(s);
    for (lex_next(&words, s, &t); t.kind != TOKEN_END; lex_next(&words, s, &t)) {
        reading r;
        bool read = try_first((size_t)(t.at.start - scene), &r);

        if (depth > 0) {
            assert_false(read);
            if (r.error.line != line || r.error.column != column)
                fail_msg("%d:%d, not %d:%d: %s", r.error.line, r.error.column, line, column, r.error.message);
            assert_non_null(strstr(r.error.message, "the end of the text"));
            assert_non_null(strstr(r.error.message, "is still open"));
        }
        reading_end(&r);
        depth += t.kind == '{' ? 1 : t.kind == '}' ? -1 : 0;
        line = t.at.line;
        column = t.at.column + (int)t.at.length;
    }
    source_free(&sources);
    symbols_free(&words);
}

/* ---- memory ---- */

typedef struct purse {
    long left, out;
} purse;

static void *spend(void *user, void *block, size_t bytes)
{
    purse *p = user;

    if (bytes == 0) {
        p->out -= block != NULL;
        free(block);
        return NULL;
    }
    if (p->left-- <= 0)
        return NULL;
    p->out += block == NULL;
    return realloc(block, bytes);
}

static void sweep(const char *text, size_t length)
{
    long allowed;
    pov_status status = POV_E_MEMORY;

    for (allowed = 0; status != POV_OK; allowed++) {
        purse p = {0, 0};
        pov_allocator allocator = {spend, NULL};
        reading r;

        p.left = allowed;
        allocator.user = &p;
        reading_begin_bytes(&r, text, length, NULL, &allocator);
        status = r.status;
        if (status != POV_OK && status != POV_E_MEMORY)
            fail_msg("%ld: %d:%d %s", allowed, r.error.line, r.error.column, r.error.message);
        reading_end(&r);
        assert_int_equal(p.out, 0);
        assert_true(allowed < 100000);
    }
    assert_true(allowed > 10);
}

static void memory_that_ends_anywhere_is_told_and_given_back(void **state)
{
    (void)state;
    sweep(scene, sizeof scene - 1);
    sweep(language, sizeof language - 1);
}

static void a_program_cut_at_any_byte_is_read_or_refused(void **state)
{
    size_t length;

    (void)state;
    for (length = 0; length < sizeof language; length++) {
        char *exact = malloc(length ? length : 1);
        reading r;

        assert_non_null(exact);
        memcpy(exact, language, length);
        reading_begin_bytes(&r, exact, length, NULL, NULL);
        free(exact);
        assert_true(r.status == POV_OK || r.error.line > 0);
        assert_true(length < sizeof language - 1 || r.status == POV_OK);
        reading_end(&r);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_whole_scene_is_read),
        cmocka_unit_test(a_scene_cut_at_any_byte_is_read_or_refused),
        cmocka_unit_test(a_scene_cut_at_any_token_says_what_is_missing_and_where),
        cmocka_unit_test(a_program_cut_at_any_byte_is_read_or_refused),
        cmocka_unit_test(memory_that_ends_anywhere_is_told_and_given_back),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
