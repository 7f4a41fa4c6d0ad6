/* What the halves of the pixels' samples say of the error. */
#include "render/cells.h"

#include "support/check.h"
#include "support/near.h"

/* A picture of one set, 8x8 pixels, two samples a pixel that differ by .5 in every channel. */
static showing measure(int alike)
{
    static double halves[6 * SET_EDGE * SET_EDGE];
    static refinement r = { .halves = halves };
    static float pixels[4 * SET_EDGE * SET_EDGE];
    const cells c = { .width = SET_EDGE, .height = SET_EDGE, .sums = 6, .alike = alike };
    const pov_rect all = { 0, 0, SET_EDGE, SET_EDGE };
    encoding linear = { .decode = 1.0 };

    for (int i = 0; i < GROUPS * SET_CELLS * SET_CELLS; i++)
        r.groups[i].count = r.groups[i].target = 2;
    for (int i = 0; i < SET_EDGE * SET_EDGE; i++)
        for (int k = 0; k < 6; k++)
            halves[6 * i + k] = k < 3 ? 0.25 : 0.75;
    cells_measure(&c, all, &linear, &r, pixels);
    return r.shown[0];
}

enum { PIXELS = CELL_EDGE * CELL_EDGE / GROUPS };

static void the_halves_difference_tells_the_error(void **state)
{
    const showing s = measure(0);

    (void)state;
    assert_near(s.square, PIXELS * 0.0625, 1e-12);
    assert_near(s.fourth, PIXELS * 0.0625 * 0.0625, 1e-12);
}

/* Pixels that err alike are as one: the band is that of sets. */
static void the_band_of_sets_is_wider(void **state)
{
    const showing s = measure(ALIKE_SETS);

    (void)state;
    assert_near(s.square, PIXELS * 0.0625, 1e-12);
    assert_near(s.fourth * SET_CELLS * SET_CELLS, SET_PIXELS * 0.0625 * SET_PIXELS * 0.0625, 1e-9);
}

static void the_band_of_photons_is_that_of_cells(void **state)
{
    const showing s = measure(ALIKE_PHOTONS);

    (void)state;
    assert_near(s.fourth * GROUPS, GROUPS * PIXELS * 0.0625 * GROUPS * PIXELS * 0.0625, 1e-9);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_halves_difference_tells_the_error),
        cmocka_unit_test(the_band_of_sets_is_wider),
        cmocka_unit_test(the_band_of_photons_is_that_of_cells),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
