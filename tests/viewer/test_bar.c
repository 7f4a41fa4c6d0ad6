/* The numbers of colour bars stand where their colours are. */
#include "bar.h"
#include "support/check.h"
#include "support/near.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The numbers of a bar's line, and where they stand. */
typedef struct ticks { int count; double share[16], value[16]; } ticks;

static ticks read_ticks(const char *line, char kind)
{
    const char *at = line + 2;
    ticks t = { 0 };

    assert_int_equal(line[0], '~');
    assert_int_equal(line[1], kind);
    do {
        assert_true(t.count < 16);
        assert_int_equal(sscanf(at, "%lf %lf", &t.share[t.count], &t.value[t.count]), 2);
        t.count++;
        at = strchr(at, '\t');
    } while (at && *++at);
    assert_int_equal(line[strlen(line) - 1], '\n');
    return t;
}

static void bar_numbers_are_powers_of_ten(void **state)
{
    char line[200] = "";
    ticks t;

    (void)state;
    bar_write(&bar_error, 1.0, line, sizeof line);
    assert_string_equal(line, "~m0.0000 0.0001\t0.3333 0.001\t0.6667 0.01\t1.0000 0.1\n");
    line[0] = '\0';
    bar_write(&bar_seconds, 1e-6, line, sizeof line);
    assert_string_equal(line, "~m0.0000 1\t0.2500 10\t0.5000 100\t0.7500 1000\t1.0000 1e4\n");
    line[0] = '\0';
    bar_write(&bar_samples, 1.0, line, sizeof line);
    t = read_ticks(line, 'm');
    assert_int_equal(t.count, 4);
    for (int i = 0; i < t.count; i++)
        assert_near(t.share[i], bar_share(&bar_samples, t.value[i]), 1e-4);
    assert_near(bar_share(&bar_samples, 32.0), 0.5, 1e-12);
}

static void bar_of_depths_has_round_numbers_apart(void **state)
{
    (void)state;
    for (double middle = 1e-6; middle < 1e7; middle *= 1.37) {
        char line[200] = "";
        ticks t;

        bar_write_depth(middle, line, sizeof line);
        t = read_ticks(line, 'd');
        assert_true(t.count >= 3 && t.count <= 5);
        for (int i = 0; i < t.count; i++) {
            assert_near(t.share[i], bar_depth_share(middle, t.value[i]), 1e-4);
            assert_true(i == 0 || t.share[i] >= t.share[i - 1] + 0.18);
        }
    }
}

static void bar_colors_are_the_maps(void **state)
{
    uint8_t c[4];

    (void)state;
    bar_color('d', bar_depth_share(7.0, 7.0), c);
    assert_true(c[0] == 128 && c[1] == 128 && c[2] == 128 && c[3] == 255);
    bar_color('d', 0.0, c);
    assert_int_equal(c[0], 255);
    bar_color('y', 1.0, c);
    assert_true(c[0] == 0 && c[1] == 255 && c[2] == 0);
    bar_color('z', 0.5, c);
    assert_int_equal(c[2], 128);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bar_numbers_are_powers_of_ten),
        cmocka_unit_test(bar_of_depths_has_round_numbers_apart),
        cmocka_unit_test(bar_colors_are_the_maps),
    };

    return cmocka_run_group_tests_name("colour bars", tests, NULL, NULL);
}
