/* test_text.c - a line of scene text on a terminal, and the blanks before a caret. */
#include "text.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static void assert_printable(const char *line, const char *expected)
{
    char out[64];

    text_printable(line, out, sizeof out);
    assert_string_equal(out, expected);
}

static void assert_indent(const char *line, int bytes, const char *expected)
{
    char out[64];

    text_indent(line, bytes, out, sizeof out);
    assert_string_equal(out, expected);
}

static void text_keeps_tabs_and_utf8_and_replaces_what_a_terminal_would_obey(void **state)
{
    (void)state;
    assert_printable("\tbox { } // caf\xc3\xa9", "\tbox { } // caf\xc3\xa9");
    assert_printable("a\033[2Jb\x7f\r", "a?[2Jb??");
    assert_printable("\xc2\x9b" "1m", "?1m");
    assert_printable("\xe2\x80\xae", "?");
}

static void text_replaces_bytes_that_are_no_utf8(void **state)
{
    (void)state;
    assert_printable("caf\xe9 }", "caf? }");
    assert_printable("\xc0\xaf", "??");
    assert_printable("\xed\xa0\x80", "???");
    assert_printable("\xf5\x80\x80\x80", "????");
    assert_printable("end\xe2\x82", "end??");
}

static void text_indents_by_columns_and_not_by_bytes(void **state)
{
    (void)state;
    assert_indent("  box", 2, "  ");
    assert_indent("\t\tbox", 2, "\t\t");
    assert_indent("caf\xc3\xa9 x", 6, "     ");
    assert_indent("\xe4\xb8\xad x", 4, "   ");
    assert_indent("e\xcc\x81x", 3, " ");
    assert_indent("\xe9x", 1, " ");
    assert_indent("short", 40, "     ");
}

static void text_fits_any_size(void **state)
{
    char out[8];

    (void)state;
    text_printable("0123456789", out, sizeof out);
    assert_string_equal(out, "0123456");
    text_printable("012345\xe4\xb8\xad", out, sizeof out);
    assert_string_equal(out, "012345");
    text_indent("0123456789", 10, out, sizeof out);
    assert_true(strlen(out) < sizeof out);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(text_keeps_tabs_and_utf8_and_replaces_what_a_terminal_would_obey),
        cmocka_unit_test(text_replaces_bytes_that_are_no_utf8),
        cmocka_unit_test(text_indents_by_columns_and_not_by_bytes),
        cmocka_unit_test(text_fits_any_size),
    };

    return cmocka_run_group_tests_name("scene text on a terminal", tests, NULL, NULL);
}
