/* sdl: every scene of the tree, with the real plugins, whole and cut off before its tokens. */
#include "support/check.h"

#include "base/file.h"
#include "sdl/lex.h"
#include "sdl/reader.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Cuts of one scene; long ones are cut at as many tokens spread over the text. */
enum { CUTS = 250 };

typedef struct bench {
    env env;
    registry *plugins;
    symbols words;
    const char *folder;
    int scenes, cuts;
} bench;

static pov_status read_first(bench *b, const char *name, const char *text, size_t length, pov_error *error)
{
    char *exact = malloc(length ? length : 1);
    pov_status status;
    model m;

    assert_non_null(exact);
    memcpy(exact, text, length);
    memset(error, 0, sizeof *error);
    model_init(&m, &b->env);
    status = reader_read(&m, b->plugins, exact, length, name, NULL, error);
    model_free(&m);
    free(exact);
    return status;
}

static int count_tokens(bench *b, const char *text, size_t length)
{
    source_list sources;
    source *s;
    token t;
    int count = 0;

    source_init(&sources, &b->env);
    s = source_add(&sources, text, length, "");
    assert_non_null(s);
    for (lex_next(&b->words, s, &t); t.kind != TOKEN_END; lex_next(&b->words, s, &t))
        count++;
    source_free(&sources);
    return count;
}

static void cut_everywhere(bench *b, const char *name, const char *text, size_t length)
{
    const int tokens = count_tokens(b, text, length), step = tokens / CUTS + 1;
    int index = 0, depth = 0;
    pov_error error;
    source_list sources;
    source *s;
    token t;

    source_init(&sources, &b->env);
    s = source_add(&sources, text, length, name);
    assert_non_null(s);
    for (lex_next(&b->words, s, &t); t.kind != TOKEN_END; lex_next(&b->words, s, &t), index++) {
        if (index % step == 0) {
            pov_status status = read_first(b, name, text, (size_t)(t.at.start - text), &error);

            b->cuts++;
            if (depth > 0 && (status != POV_E_SYNTAX || error.line < 1 || error.column < 1 ||
                              strcmp(error.file, name) != 0))
                fail_msg("%s cut at %d:%d: %d, %d:%d %s", name, t.at.line, t.at.column, status, error.line,
                         error.column, error.message);
        }
        depth += t.kind == '{' ? 1 : t.kind == '}' ? -1 : 0;
    }
    source_free(&sources);
}

static void see(void *user, const char *name)
{
    bench *b = user;
    char path[1024], *text;
    size_t length, n = strlen(name);
    pov_error error;

    if (n < 4 || strcmp(name + n - 4, ".pov") != 0)
        return;
    snprintf(path, sizeof path, "%s/%s/%s", TEST_ROOT, b->folder, name);
    assert_int_equal(file_read(&b->env, path, &text, &length, &error), POV_OK);
    /* By its whole path, for files that it names stand beside it. */
    if (read_first(b, path, text, length, &error) != POV_OK)
        fail_msg("%s:%d:%d: %s", path, error.line, error.column, error.message);
    cut_everywhere(b, path, text, length);
    env_free(&b->env, text);
    b->scenes++;
}

static void every_scene_is_read_and_no_part_of_it_breaks_the_reader(void **state)
{
    static const char *const folders[] = { "scenes/test", "scenes/gallery" };
    char path[1024];
    pov_error error;
    bench b;
    size_t i;

    (void)state;
    memset(&b, 0, sizeof b);
    env_init(&b.env, NULL, NULL, NULL);
    assert_true(symbols_init(&b.words, &b.env));
    b.plugins = registry_create(&b.env, TEST_BUILD "/lib/povtrace", &error);
    assert_non_null(b.plugins);
    for (i = 0; i < 2; i++) {
        b.folder = folders[i];
        snprintf(path, sizeof path, "%s/%s", TEST_ROOT, b.folder);
        file_list(path, see, &b);
    }
    assert_true(b.scenes > 0 && b.cuts > 20 * b.scenes);
    print_message("%d scenes, %d cuts\n", b.scenes, b.cuts);
    symbols_free(&b.words);
    registry_destroy(b.plugins);
}

static void real_shapes_refuse_what_is_missing(void **state)
{
    static const struct {
        const char *text, *message;
    } cases[] = {
        { "sphere { <1, 2, 3> }", "expected a number after \">\", found \"}\"" },
        { "sphere { <0, 0, 0>, <1, 1, 1> }", "expected a number, found a vector" },
        { "polygon { 1e9, <0, 0, 0> }", "expected a vector after \">\", found \"}\"" },
        { "cone { 0, 1, 2 }", "expected a number after \"2\", found \"}\"" },
        { "quadric { 1, 2, 3 }", "expected a number after \"3\", found \"}\"" },
        { "box { 1 pigment { } }", "expected a vector after \"1\", found \"pigment\"" },
        { "cylinder { 0, <1, 0, 0>, 1 close }", "unknown word \"close\" in \"cylinder\"" },
    };
    pov_error error;
    bench b;
    size_t i;

    (void)state;
    memset(&b, 0, sizeof b);
    env_init(&b.env, NULL, NULL, NULL);
    b.plugins = registry_create(&b.env, TEST_BUILD "/lib/povtrace", &error);
    assert_non_null(b.plugins);
    for (i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        read_first(&b, "scene.pov", cases[i].text, strlen(cases[i].text), &error);
        assert_int_equal(error.status, POV_E_SYNTAX);
        assert_string_equal(error.message, cases[i].message);
    }
    registry_destroy(b.plugins);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_scene_is_read_and_no_part_of_it_breaks_the_reader),
        cmocka_unit_test(real_shapes_refuse_what_is_missing),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
