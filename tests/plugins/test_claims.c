/* The contract's own test: classes that claim to be certified, and are not, are caught by it, and it says of what shape
 * and by what numbers. What they are built of is in tests/tests.mk. */
#include "support/check.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>

/* What the contract says of one plugin. The caller frees it. True: it passed. */
static bool contract_says(const char *plugin, char **said)
{
    char command[2048];
    size_t length = 0, room = 1 << 16;
    FILE *from;
    int status;

    snprintf(command, sizeof command, "%s/tests/plugins/test_contract %s/tests/plugins/claims/%s 2>&1", TEST_BUILD,
             TEST_BUILD, plugin);
    from = popen(command, "r");
    assert_non_null(from);
    *said = calloc(room, 1);
    assert_non_null(*said);
    while (length < room - 1 && fread(*said + length, 1, 1, from) == 1)
        length++;
    status = pclose(from);
    assert_true(WIFEXITED(status));
    return WEXITSTATUS(status) == 0;
}

static void assert_caught(const char *plugin, const char *test, const char *shape, const char *sides)
{
    char *said, failed[128];

    snprintf(failed, sizeof failed, "[  FAILED  ] %s\n", test);
    assert_false(contract_says(plugin, &said));
    if (!strstr(said, failed) || !strstr(said, shape) || !strstr(said, sides))
        fail_msg("%s: expected \"%s\", \"%s\" and \"%s\" in\n%s", plugin, test, shape, sides, said);
    free(said);
}

static void a_solid_in_plain_double_is_caught(void **state)
{
    (void)state;
    assert_caught("naive/torus.so", "a_certified_distance_is_where_inside_changes", "torus { 1, 0.25 }",
                  "inside() changes");
}

static void a_solid_off_by_a_billionth_is_caught(void **state)
{
    (void)state;
    assert_caught("off/torus.so", "a_certified_distance_is_where_inside_changes", "torus { 1, 0.25 }",
                  "inside() changes");
}

static void a_surface_off_by_a_billionth_is_caught(void **state)
{
    (void)state;
    assert_caught("off/disc.so", "a_certified_distance_is_the_same_from_the_other_side", "disc { <0, 0, 0>, <0, 1, 0>, 1 }",
                  " back are ");
    assert_caught("off/disc.so", "a_certified_planar_surface_is_planar", "disc { <0, 0, 0>, <0, 1, 0>, 1 }",
                  " off one plane");
}

static void a_claim_that_holds_is_let_pass(void **state)
{
    char *said;

    (void)state;
    if (!contract_says("right/disc.so", &said))
        fail_msg("%s", said);
    assert_null(strstr(said, "is not certified"));
    free(said);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_solid_in_plain_double_is_caught),
        cmocka_unit_test(a_solid_off_by_a_billionth_is_caught),
        cmocka_unit_test(a_surface_off_by_a_billionth_is_caught),
        cmocka_unit_test(a_claim_that_holds_is_let_pass),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
