/* sdl/lex: bytes to tokens with their places. */
#include "support/check.h"

#include "sdl/lex.h"

#include <stdlib.h>
#include <string.h>

typedef struct lexing {
    env env;
    symbols words;
    source_list sources;
    source *text;
} lexing;

static int set_up(void **state)
{
    static lexing l;

    env_init(&l.env, NULL, NULL, NULL);
    assert_true(symbols_init(&l.words, &l.env));
    source_init(&l.sources, &l.env);
    *state = &l;
    return 0;
}

static int tear_down(void **state)
{
    lexing *l = *state;

    source_free(&l->sources);
    symbols_free(&l->words);
    return 0;
}

static lexing *begin(void **state, const char *text)
{
    lexing *l = *state;

    l->text = source_add(&l->sources, text, strlen(text), "scene.pov");
    assert_non_null(l->text);
    return l;
}

static token next(lexing *l)
{
    token t;

    lex_next(&l->words, l->text, &t);
    return t;
}

static void assert_next(lexing *l, int kind, const char *text, int line, int column)
{
    token t = next(l);

    assert_int_equal(t.kind, kind);
    assert_int_equal(t.at.length, strlen(text));
    assert_memory_equal(t.at.start, text, strlen(text));
    assert_int_equal(t.at.line, line);
    assert_int_equal(t.at.column, column);
}

static void lex_finds_words_numbers_and_marks(void **state)
{
    lexing *l = begin(state, "sphere{<0,-.5 1e3>,2}");

    assert_next(l, TOKEN_WORD, "sphere", 1, 1);
    assert_next(l, '{', "{", 1, 7);
    assert_next(l, '<', "<", 1, 8);
    assert_next(l, TOKEN_NUMBER, "0", 1, 9);
    assert_next(l, ',', ",", 1, 10);
    assert_next(l, '-', "-", 1, 11);
    assert_next(l, TOKEN_NUMBER, ".5", 1, 12);
    assert_next(l, TOKEN_NUMBER, "1e3", 1, 15);
    assert_next(l, '>', ">", 1, 18);
    assert_next(l, ',', ",", 1, 19);
    assert_next(l, TOKEN_NUMBER, "2", 1, 20);
    assert_next(l, '}', "}", 1, 21);
    assert_next(l, TOKEN_END, "", 1, 22);
    assert_next(l, TOKEN_END, "", 1, 22);
}

static void lex_knows_the_words_of_the_language(void **state)
{
    lexing *l = begin(state, "camera sphere_ prism _x1");

    assert_int_equal(next(l).symbol->id, KEYWORD_CAMERA);
    assert_int_equal(next(l).symbol->id, KEYWORD_OTHER);
    assert_int_equal(next(l).symbol->flags, KEYWORD_FLAG_SHAPE);
    assert_string_equal(next(l).symbol->name, "_x1");
}

static void lex_counts_every_kind_of_line_end_once(void **state)
{
    lexing *l = begin(state, "a\nb\r\nc\rd\n\re\tf");

    assert_next(l, TOKEN_WORD, "a", 1, 1);
    assert_next(l, TOKEN_WORD, "b", 2, 1);
    assert_next(l, TOKEN_WORD, "c", 3, 1);
    assert_next(l, TOKEN_WORD, "d", 4, 1);
    assert_next(l, TOKEN_WORD, "e", 6, 1);
    assert_next(l, TOKEN_WORD, "f", 6, 3);
}

static void lex_skips_nested_comments_and_other_bytes_in_them(void **state)
{
    lexing *l = begin(state, "// \xE9t\xE9 { /*\r\n/* a /* b\n*/ \"*/ c // */ d");

    assert_next(l, TOKEN_WORD, "c", 3, 8);
    assert_next(l, TOKEN_END, "", 3, 17);
}

static void lex_skips_a_byte_order_mark(void **state)
{
    lexing *l = begin(state, "\xEF\xBB\xBFx");

    assert_next(l, TOKEN_WORD, "x", 1, 1);
}

static void lex_keeps_a_quoted_quote_in_its_string(void **state)
{
    lexing *l = begin(state, "\"a\\\"\xE9\" \"\" b");

    assert_next(l, TOKEN_STRING, "\"a\\\"\xE9\"", 1, 1);
    assert_next(l, TOKEN_STRING, "\"\"", 1, 8);
    assert_next(l, TOKEN_WORD, "b", 1, 11);
}

static void lex_marks_what_is_wrong_and_goes_on(void **state)
{
    lexing *l = begin(state, "1.2.3 @ \xC3\xA9 \xE9 \"a\nb");

    assert_next(l, TOKEN_BAD, "1.2.3", 1, 1);
    assert_next(l, TOKEN_BAD, "@", 1, 7);
    assert_next(l, TOKEN_BAD, "\xC3\xA9", 1, 9);
    assert_next(l, TOKEN_BAD, "\xE9", 1, 12);
    assert_next(l, TOKEN_BAD, "\"a", 1, 14);
    assert_int_equal(next(l).kind, TOKEN_END);
}

static void lex_tells_where_an_endless_comment_begins(void **state)
{
    lexing *l = begin(state, "a\n /* b /* c */");

    next(l);
    assert_next(l, TOKEN_BAD, "/*", 2, 2);
    assert_next(l, TOKEN_END, "", 2, 14);
}

static void lex_ends_each_line_of_a_long_string_once(void **state)
{
    lexing *l = begin(state, "\"a\r\n\\\"b\n\" c");

    assert_next(l, TOKEN_STRING, "\"a\r\n\\\"b\n\"", 1, 1);
    assert_next(l, TOKEN_WORD, "c", 3, 3);
}

static void lex_joins_the_two_characters_of_a_comparison(void **state)
{
    lexing *l = begin(state, "<=>=!=< =");

    assert_next(l, TOKEN_AT_MOST, "<=", 1, 1);
    assert_next(l, TOKEN_AT_LEAST, ">=", 1, 3);
    assert_next(l, TOKEN_UNEQUAL, "!=", 1, 5);
    assert_next(l, '<', "<", 1, 7);
    assert_next(l, '=', "=", 1, 9);
}

static void lex_skips_to_the_next_directive(void **state)
{
    lexing *l = begin(state, "a(1.5) /* #if /* */ # */ \"#\\\"#\r\n\" // #\n \xC3\xA9 / b\r#end c");

    lex_skip(l->text);
    assert_next(l, '#', "#", 4, 1);
    assert_next(l, TOKEN_WORD, "end", 4, 2);
    lex_skip(l->text);
    assert_next(l, TOKEN_END, "", 4, 7);
}

static void lex_skips_what_has_no_end(void **state)
{
    static const char *const texts[] = {"a /* # ", "a \" # ", "a // # ", "a \"\\", "/", ""};

    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) {
        lexing *l = begin(state, texts[i]);

        lex_skip(l->text);
        assert_int_equal(next(l).kind, TOKEN_END);
    }
}

static void lex_resolves_escapes(void **state)
{
    lexing *l = begin(state, "\"\\n\\u00e9\\u20AC\\\"\" \"a\\q\"");
    const char *bad;
    char out[32];
    token t = next(l);

    assert_int_equal(lex_unescape(&t.at, out, &bad), 7);
    assert_memory_equal(out, "\n\xC3\xA9\xE2\x82\xAC\"", 7);
    assert_null(bad);
    t = next(l);
    lex_unescape(&t.at, out, &bad);
    assert_ptr_equal(bad, t.at.start + 2);
}

static void lex_needs_no_end_mark(void **state)
{
    static const char *const texts[] = {"sphere1", "12.5", "/",  "//",  "/*", "\"",
                                        "\"\\",    ".",    "1e", "1e-", "\r", "\xC3"};
    lexing *l = *state;
    size_t i, length;

    for (i = 0; i < sizeof texts / sizeof texts[0]; i++)
        for (length = 0; length <= strlen(texts[i]); length++) {
            char *exact = malloc(length ? length : 1);

            memcpy(exact, texts[i], length);
            l->text = source_add(&l->sources, exact, length, "scene.pov");
            assert_non_null(l->text);
            while (next(l).kind != TOKEN_END)
                continue;
            free(exact);
            source_free(&l->sources);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(lex_finds_words_numbers_and_marks, set_up, tear_down),
        cmocka_unit_test_setup_teardown(lex_knows_the_words_of_the_language, set_up, tear_down),
        cmocka_unit_test_setup_teardown(lex_counts_every_kind_of_line_end_once, set_up, tear_down),
        cmocka_unit_test_setup_teardown(lex_skips_nested_comments_and_other_bytes_in_them, set_up, tear_down),
        cmocka_unit_test_setup_teardown(lex_skips_a_byte_order_mark, set_up, tear_down),
        cmocka_unit_test_setup_teardown(lex_keeps_a_quoted_quote_in_its_string, set_up, tear_down),
        cmocka_unit_test_setup_teardown(lex_marks_what_is_wrong_and_goes_on, set_up, tear_down),
        cmocka_unit_test_setup_teardown(lex_tells_where_an_endless_comment_begins, set_up, tear_down),
        cmocka_unit_test_setup_teardown(lex_ends_each_line_of_a_long_string_once, set_up, tear_down),
        cmocka_unit_test_setup_teardown(lex_joins_the_two_characters_of_a_comparison, set_up, tear_down),
        cmocka_unit_test_setup_teardown(lex_skips_to_the_next_directive, set_up, tear_down),
        cmocka_unit_test_setup_teardown(lex_skips_what_has_no_end, set_up, tear_down),
        cmocka_unit_test_setup_teardown(lex_resolves_escapes, set_up, tear_down),
        cmocka_unit_test_setup_teardown(lex_needs_no_end_mark, set_up, tear_down),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
