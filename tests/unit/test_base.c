/* base: memory, names, words, files. */
#include "support/check.h"

#include "base/arena.h"
#include "base/clock.h"
#include "base/file.h"
#include "base/map.h"
#include "base/pages.h"
#include "base/str.h"
#include "base/thread.h"
#include "base/vec.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static env libc_env(void)
{
    env e;

    env_init(&e, NULL, NULL, NULL);
    return e;
}

/* ---- memory ---- */

static void *never(void *user, void *block, size_t bytes)
{
    (void)user;
    (void)block;
    (void)bytes;
    return NULL;
}

static void allocation_whose_size_overflows_fails(void **state)
{
    env e = libc_env();

    (void)state;
    assert_null(env_alloc(&e, SIZE_MAX / 2, 3));
    assert_null(env_resize(&e, NULL, SIZE_MAX / 2, 3));
    assert_null(env_alloc_aligned(&e, SIZE_MAX - 8, 64));
}

static void aligned_blocks_are_aligned_and_zero(void **state)
{
    env e = libc_env();
    size_t align, i;

    (void)state;
    for (align = 16; align <= 4096; align *= 2) {
        unsigned char *block = env_alloc_aligned(&e, 100, align);
        assert_non_null(block);
        assert_int_equal((uintptr_t)block % align, 0);
        for (i = 0; i < 100; i++)
            assert_int_equal(block[i], 0);
        env_free_aligned(&e, block);
    }
    env_free_aligned(&e, NULL);
}

static void large_blocks_are_there_to_their_last_byte(void **state)
{
    const size_t sizes[] = { 1, 4096, ((size_t)4 << 20) - 1, (size_t)4 << 20, ((size_t)4 << 20) + 1 };
    env e = libc_env();
    size_t i;

    (void)state;
    for (i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        unsigned char *block = pages_reserve(&e, sizes[i]);

        assert_non_null(block);
        assert_int_equal((uintptr_t)block % 64, 0);
        memset(block, 7, sizes[i]);
        for (size_t part = 0; part < 3; part++)
            pages_prefetch(block, sizes[i], part, 3);
        assert_int_equal(block[0], 7);
        assert_memory_equal(block, block + 1, sizes[i] - 1);
        pages_free(&e, block);
    }
    pages_free(&e, NULL);
    assert_null(pages_reserve(&e, SIZE_MAX));
}

static void arena_gives_aligned_zeroed_memory_of_any_size(void **state)
{
    static const size_t sizes[] = { 1, 7, 32, 4096, 100000, 3, 5000000, 64 };
    env e = libc_env();
    arena a;
    size_t i, j;

    (void)state;
    arena_init(&a, &e);
    for (i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        unsigned char *block = arena_alloc(&a, sizes[i], 64);
        assert_non_null(block);
        assert_int_equal((uintptr_t)block % 64, 0);
        for (j = 0; j < sizes[i]; j++)
            assert_int_equal(block[j], 0);
        memset(block, 0xff, sizes[i]);
    }
    assert_string_equal(arena_printf(&a, "%d of %s", 3, "them"), "3 of them");
    assert_string_equal(arena_text(&a, "whole", 3), "who");
    arena_free(&a);
}

static void arena_says_when_memory_ends(void **state)
{
    pov_allocator none = { never, NULL };
    env e;
    arena a;

    (void)state;
    env_init(&e, &none, NULL, NULL);
    arena_init(&a, &e);
    assert_null(arena_alloc(&a, 1, 8));
    assert_null(arena_alloc(&a, SIZE_MAX - 8, 8));
    assert_null(arena_text(&a, "x", 1));
    arena_free(&a);
}

static void vec_keeps_what_was_pushed(void **state)
{
    env e = libc_env();
    struct { int *items; size_t count, capacity; } list = { NULL, 0, 0 };
    int i;

    (void)state;
    for (i = 0; i < 1000; i++)
        assert_true(VEC_PUSH(&e, &list, i));
    for (i = 0; i < 1000; i++)
        assert_int_equal(list.items[i], i);
    env_free(&e, list.items);
}

/* ---- names and words ---- */

static void map_finds_each_of_many_names(void **state)
{
    env e = libc_env();
    map m;
    char name[16];
    static int values[500];
    int i;

    (void)state;
    map_init(&m, &e);
    assert_null(map_get(&m, "nothing"));
    for (i = 0; i < 500; i++) {
        snprintf(name, sizeof name, "name%d", i);
        assert_true(map_put(&m, name, &values[i]));
    }
    assert_true(map_put(&m, "name7", &values[8]));
    assert_ptr_equal(map_get(&m, "name7"), &values[8]);
    assert_ptr_equal(map_get(&m, "name499"), &values[499]);
    assert_null(map_get(&m, "name500"));
    assert_int_equal(m.count, 500);
    map_free(&m);
}

static const char *nearest(const char *word)
{
    static const char *const words[] = { "sphere", "box", "cylinder", "location", "look_at" };
    const char *best = NULL;
    size_t i;
    int edits = 0;

    for (i = 0; i < sizeof words / sizeof *words; i++)
        str_nearer(word, words[i], &best, &edits);
    return best;
}

static void slips_of_the_pen_are_guessed_and_other_words_are_not(void **state)
{
    (void)state;
    assert_string_equal(nearest("sphare"), "sphere");
    assert_string_equal(nearest("cylnider"), "cylinder");
    assert_string_equal(nearest("lookat"), "look_at");
    assert_string_equal(nearest("BOX"), "box");
    assert_string_equal(nearest("bxo"), "box");
    assert_null(nearest("torus"));
    assert_null(nearest(""));
    assert_null(nearest("a_word_that_is_much_longer_than_any_keyword_there_is"));
}

static void copied_text_always_ends(void **state)
{
    char small[4];

    (void)state;
    str_copy(small, sizeof small, "longer");
    assert_string_equal(small, "lon");
}

/* ---- files ---- */

typedef struct folder { char path[64], file[96]; } folder;

static folder make_folder(void)
{
    folder f = { "/tmp/povtrace-test-XXXXXX", "" };

    assert_non_null(mkdtemp(f.path));
    snprintf(f.file, sizeof f.file, "%s/file", f.path);
    return f;
}

static void count_entry(void *user, const char *name)
{
    *(int *)user += name[0] != '.';
}

static int entries(const folder *f)
{
    int n = 0;

    file_list(f->path, count_entry, &n);
    return n;
}

static void remove_folder(const folder *f)
{
    unlink(f->file);
    assert_int_equal(rmdir(f->path), 0);
}

static pov_status replace(const folder *f, const char *text, size_t times, bool commit)
{
    env e = libc_env();
    file_writer *w = malloc(sizeof *w);
    pov_error err;
    pov_status status;
    size_t i;

    assert_non_null(w);
    status = file_writer_open(w, &e, f->file, &err);
    for (i = 0; status == POV_OK && i < times; i++)
        file_writer_put(w, text, strlen(text));
    if (status == POV_OK && commit)
        status = file_writer_commit(w, &err);
    else if (status == POV_OK)
        file_writer_discard(w);
    free(w);
    return status;
}

static void assert_holds(const folder *f, const char *text, size_t times)
{
    env e = libc_env();
    pov_error err;
    char *bytes;
    size_t count, i, n = strlen(text);

    assert_int_equal(file_read(&e, f->file, &bytes, &count, &err), POV_OK);
    assert_int_equal(count, n * times);
    assert_int_equal(bytes[count], 0);
    for (i = 0; i < times; i++)
        assert_memory_equal(bytes + i * n, text, n);
    env_free(&e, bytes);
}

static void a_written_file_is_the_new_one_or_the_old_one(void **state)
{
    folder f = make_folder();
    struct stat about;

    (void)state;
    assert_int_equal(replace(&f, "first ", 20000, true), POV_OK);
    assert_holds(&f, "first ", 20000);
    chmod(f.file, 0640);
    assert_int_equal(replace(&f, "second", 3, false), POV_OK);
    assert_holds(&f, "first ", 20000);
    assert_int_equal(replace(&f, "second", 3, true), POV_OK);
    assert_holds(&f, "second", 3);
    stat(f.file, &about);
    assert_int_equal(about.st_mode & 0777, 0640);
    assert_int_equal(entries(&f), 1);
    remove_folder(&f);
}

static void reading_says_what_is_wrong(void **state)
{
    env e = libc_env();
    folder f = make_folder();
    pov_error err;
    char *bytes;
    size_t count;

    (void)state;
    assert_int_equal(file_read(&e, f.file, &bytes, &count, &err), POV_E_IO);
    assert_string_equal(err.message, "cannot open: No such file or directory");
    assert_string_equal(err.file, f.file);
    assert_int_equal(file_read(&e, f.path, &bytes, &count, &err), POV_E_IO);
    assert_string_equal(err.message, "is a folder, not a file");
    remove_folder(&f);
}

static void a_target_in_a_missing_folder_is_an_error(void **state)
{
    folder f = { "/tmp", "/tmp/povtrace-no-such-folder/file" };

    (void)state;
    assert_int_equal(replace(&f, "x", 1, true), POV_E_IO);
}

/* ---- time ---- */

static void waiting_ends_at_its_time(void **state)
{
    mutex m;
    condition c;
    double start = clock_seconds();

    (void)state;
    assert_true(mutex_init(&m) && condition_init(&c));
    mutex_lock(&m);
    while (condition_wait_until(&c, &m, start + 0.02))
        continue;
    mutex_unlock(&m);
    assert_true(clock_seconds() >= start + 0.02);
    assert_true(thread_cores() >= 1);
    condition_destroy(&c);
    mutex_destroy(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(allocation_whose_size_overflows_fails),
        cmocka_unit_test(aligned_blocks_are_aligned_and_zero),
        cmocka_unit_test(large_blocks_are_there_to_their_last_byte),
        cmocka_unit_test(arena_gives_aligned_zeroed_memory_of_any_size),
        cmocka_unit_test(arena_says_when_memory_ends),
        cmocka_unit_test(vec_keeps_what_was_pushed),
        cmocka_unit_test(map_finds_each_of_many_names),
        cmocka_unit_test(slips_of_the_pen_are_guessed_and_other_words_are_not),
        cmocka_unit_test(copied_text_always_ends),
        cmocka_unit_test(a_written_file_is_the_new_one_or_the_old_one),
        cmocka_unit_test(reading_says_what_is_wrong),
        cmocka_unit_test(a_target_in_a_missing_folder_is_an_error),
        cmocka_unit_test(waiting_ends_at_its_time),
    };

    return cmocka_run_group_tests_name("base", tests, NULL, NULL);
}
