/* Linear values to stored ones. */
#include "base/srgb.h"
#include "render/encode.h"
#include "support/check.h"

#include <math.h>

static unsigned char stored(const encoder *e, float v)
{
    float rgba[4] = { 0.0f, 0.0f, 0.0f, 1.0f };
    unsigned char out[3];

    rgba[1] = v;
    encoder_row(e, rgba, 1, 3, out);
    return out[1];
}

/* As many thresholds as the value reaches, counted one by one. */
static int counted(const encoder *e, float v)
{
    int code = 0;

    while (code < 255 && v >= e->above[code])
        code++;
    return code;
}

static void check_transfer(pov_transfer transfer)
{
    encoder e;

    encoder_init(&e, 8, transfer, 0.0);
    for (int i = 0; i < 255; i++) {
        assert_int_equal(stored(&e, nextafterf(e.above[i], 0.0f)), i);
        assert_int_equal(stored(&e, e.above[i]), i + 1);
    }
    for (int i = 0; i <= 1 << 20; i++) {
        float v = (float)i / (1 << 20);

        assert_int_equal(stored(&e, v), counted(&e, v));
    }
}

static void eight_bits_are_the_nearest_code_of_the_curve(void **state)
{
    (void)state;
    check_transfer(POV_TRANSFER_LINEAR);
    check_transfer(POV_TRANSFER_SRGB);
}

static void the_thresholds_are_the_curves_halves(void **state)
{
    encoder e;

    (void)state;
    encoder_init(&e, 8, POV_TRANSFER_SRGB, 0.0);
    for (int i = 0; i < 255; i++)
        assert_true(fabs(255.0 * srgb_encode((double)e.above[i]) - (i + 0.5)) < 1e-4);
}

static void what_is_beyond_is_clamped_and_no_number_is_black(void **state)
{
    encoder e;

    (void)state;
    encoder_init(&e, 8, POV_TRANSFER_SRGB, 0.0);
    assert_int_equal(stored(&e, -1.0f), 0);
    assert_int_equal(stored(&e, -0.0f), 0);
    assert_int_equal(stored(&e, 1.0f), 255);
    assert_int_equal(stored(&e, 1e30f), 255);
    assert_int_equal(stored(&e, HUGE_VALF), 255);
    assert_int_equal(stored(&e, NAN), 0);
}

static void a_gamma_of_its_own_replaces_the_curve(void **state)
{
    const float rgba[4] = { 0.25f, 1.0f, 0.0f, 1.0f };
    uint16_t out[3];
    encoder e;

    (void)state;
    encoder_init(&e, 8, POV_TRANSFER_SRGB, 2.0);
    assert_int_equal(stored(&e, 0.25f), 128);
    encoder_init(&e, 16, POV_TRANSFER_SRGB, 2.0);
    encoder_row(&e, rgba, 1, 3, out);
    assert_int_equal(out[0], 32768);
    assert_int_equal(out[1], 65535);
    assert_int_equal(out[2], 0);
}

static void alpha_is_stored_without_a_curve(void **state)
{
    const float rgba[8] = { 0.0f, 0.0f, 0.0f, 0.25f, 0.0f, 0.0f, 0.0f, 1.5f };
    unsigned char bytes[8];
    uint16_t words[8];
    encoder e;

    (void)state;
    encoder_init(&e, 8, POV_TRANSFER_SRGB, 0.0);
    encoder_row(&e, rgba, 2, 4, bytes);
    assert_int_equal(bytes[3], 64);
    assert_int_equal(bytes[7], 255);
    encoder_init(&e, 16, POV_TRANSFER_SRGB, 0.0);
    encoder_row(&e, rgba, 2, 4, words);
    assert_int_equal(words[3], 16384);
    assert_int_equal(words[7], 65535);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(eight_bits_are_the_nearest_code_of_the_curve),
        cmocka_unit_test(the_thresholds_are_the_curves_halves),
        cmocka_unit_test(what_is_beyond_is_clamped_and_no_number_is_black),
        cmocka_unit_test(a_gamma_of_its_own_replaces_the_curve),
        cmocka_unit_test(alpha_is_stored_without_a_curve),
    };

    return cmocka_run_group_tests_name("storing colours", tests, NULL, NULL);
}
