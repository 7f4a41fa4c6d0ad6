#define _XOPEN_SOURCE 700   /* mkdtemp, setenv */
/* The list of the scenes that were shown last. */
#include "recent.h"
#include "support/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static char folder[] = "/tmp/povview-recent-XXXXXX";

static int make_folder(void **state)
{
    (void)state;
    return mkdtemp(folder) && chdir(folder) == 0 && setenv("XDG_STATE_HOME", folder, 1) == 0 ? 0 : -1;
}

static int remove_folder(void **state)
{
    char name[20];

    (void)state;
    unlink("povtrace/recent");
    rmdir("povtrace");
    for (int i = 0; i < 12; i++) {
        snprintf(name, sizeof name, "%d.pov", i);
        unlink(name);
    }
    return chdir("/") == 0 ? rmdir(folder) : -1;
}

static void show(int number)
{
    char name[20];
    FILE *f;

    snprintf(name, sizeof name, "%d.pov", number);
    f = fopen(name, "w");
    assert_non_null(f);
    fclose(f);
    recent_add(name);
}

static void assert_nth(const recent *r, int index, const char *name)
{
    const char *slash = strrchr(r->paths[index], '/');

    assert_true(r->paths[index][0] == '/');
    assert_string_equal(slash + 1, name);
}

static void recent_is_empty_at_first(void **state)
{
    recent r;

    (void)state;
    recent_read(&r);
    assert_int_equal(r.count, 0);
}

static void recent_has_nine_the_last_one_first_and_each_once(void **state)
{
    recent r;

    (void)state;
    for (int i = 0; i < 11; i++)
        show(i);
    show(5);
    recent_read(&r);
    assert_int_equal(r.count, RECENT_MOST);
    assert_nth(&r, 0, "5.pov");
    assert_nth(&r, 1, "10.pov");
    assert_nth(&r, 8, "2.pov");
}

static void recent_leaves_out_what_is_gone(void **state)
{
    recent r;

    (void)state;
    unlink("10.pov");
    recent_read(&r);
    assert_int_equal(r.count, RECENT_MOST - 1);
    assert_nth(&r, 1, "9.pov");
}

static void recent_takes_no_harm_from_a_broken_list(void **state)
{
    FILE *f = fopen("povtrace/recent", "w");
    recent r;

    (void)state;
    assert_non_null(f);
    for (int i = 0; i < 3000; i++)
        fputc('/', f);
    fputs("\nrelative.pov\n\n\x01\xff\n", f);
    fclose(f);
    recent_read(&r);
    assert_int_equal(r.count, 0);
    setenv("XDG_STATE_HOME", "/dev/null", 1);
    recent_add("9.pov");
    recent_read(&r);
    assert_int_equal(r.count, 0);
    setenv("XDG_STATE_HOME", folder, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(recent_is_empty_at_first),
        cmocka_unit_test(recent_has_nine_the_last_one_first_and_each_once),
        cmocka_unit_test(recent_leaves_out_what_is_gone),
        cmocka_unit_test(recent_takes_no_harm_from_a_broken_list),
    };

    return cmocka_run_group_tests_name("recent scenes", tests, make_folder, remove_folder);
}
