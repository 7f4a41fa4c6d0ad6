/* What the scene calculates in, assumed_gamma, changes no colour that says how it is encoded: srgb and images. The numbers
 * are those of POV-Ray 3.7. */
#include "support/check.h"
#include "support/scenes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { SIZE = 16 };

static const char *const gammas[] = { "assumed_gamma 1", "assumed_gamma 2.2", "assumed_gamma srgb", "" };

static float *draw(const char *gamma, const char *text)
{
    char all[1024];

    snprintf(all, sizeof all, "#version 3.7; global_settings { %s } camera { orthographic location -z right 2*x up 2*y } %s",
             gamma, text);
    return scenes_draw(all, SIZE, SIZE, 1, 1);
}

static void encoded_colours_are_the_same_in_every_gamma(void **state)
{
    static const double seen[3] = { 0.1328683, 0.0835351, 0.2428668 };

    (void)state;
    for (size_t i = 0; i < sizeof gammas / sizeof gammas[0]; i++) {
        float *picture = draw(gammas[i], "background { srgb <.4,.32,.53> }");

        for (int c = 0; c < 3; c++)
            if (fabs((double)picture[c] - seen[c]) > 1e-6)
                fail_msg("%s: %.8f for %f", gammas[i], (double)picture[c], seen[c]);
        free(picture);
    }
}

static void images_are_the_same_in_every_gamma(void **state)
{
    const char *text = "plane { z, 0 pigment { image_map { png \"" TEST_ROOT "/scenes/test/images/rings.png\" } } "
                       "finish { ambient 1 diffuse 0 } }";
    float *first = draw(gammas[0], text);

    (void)state;
    for (size_t i = 1; i < sizeof gammas / sizeof gammas[0]; i++) {
        float *picture = draw(gammas[i], text);

        for (int k = 0; k < 4 * SIZE * SIZE; k++)
            if (fabs((double)picture[k] - (double)first[k]) > 1e-5)
                fail_msg("%s: %.8f for %.8f", gammas[i], (double)picture[k], (double)first[k]);
        free(picture);
    }
    free(first);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(encoded_colours_are_the_same_in_every_gamma),
        cmocka_unit_test(images_are_the_same_in_every_gamma),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
