/* Images written and read again, through the public calls. */
#include "support/check.h"
#include "support/near.h"
#include "support/scenes.h"

#include <povtrace/povtrace.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { WIDTH = 7, HEIGHT = 5, PIXELS = WIDTH * HEIGHT };

static void fill(float *rgba, float scale)
{
    for (int i = 0; i < 4 * PIXELS; i++)
        rgba[i] = i % 4 == 3 ? 1.0f : scale * (float)(i * 37 % 101) / 100.0f;
}

/* The largest difference after a file of this ending, bits and transfer. */
static double there_and_back(pov_context *context, const char *ending, int bits, pov_transfer transfer, float scale)
{
    pov_image_options options = POV_INIT(options);
    pov_bitmap back = POV_INIT(back);
    float rgba[4 * PIXELS];
    char path[64];
    double most = 0.0;

    fill(rgba, scale);
    options.bits = bits;
    options.transfer = transfer;
    snprintf(path, sizeof path, "/tmp/povtrace-read-%ld.%s", (long)getpid(), ending);
    assert_int_equal(pov_image_write(context, path, WIDTH, HEIGHT, rgba, WIDTH * 16, &options, NULL), POV_OK);
    assert_int_equal(pov_image_read(context, path, &back, NULL), POV_OK);
    remove(path);
    assert_true(back.width == WIDTH && back.height == HEIGHT && (bits == 0 || back.bits == bits));
    for (int i = 0; i < 4 * PIXELS; i++) {
        double off = fabs((double)back.rgba[i] - (double)rgba[i]);
        most = off > most ? off : most;
    }
    pov_image_free(context, &back);
    assert_null(back.rgba);
    return most;
}

static void what_was_written_is_read(void **state)
{
    pov_context *context = scenes_context();
    (void)state;

    assert_near(there_and_back(context, "pfm", 0, POV_TRANSFER_LINEAR, 7.5f), 0.0, 0.0);
    assert_near(there_and_back(context, "png", 8, POV_TRANSFER_LINEAR, 1.0f), 0.0, 0.502 / 255.0);
    assert_near(there_and_back(context, "png", 16, POV_TRANSFER_LINEAR, 1.0f), 0.0, 0.502 / 65535.0);
    /* Towards white a step of the sRGB curve is 2.28 times as wide. */
    assert_near(there_and_back(context, "png", 16, POV_TRANSFER_SRGB, 1.0f), 0.0, 2.3 * 0.502 / 65535.0);
    assert_near(there_and_back(context, "png", 8, POV_TRANSFER_SRGB, 1.0f), 0.0, 2.3 * 0.502 / 255.0);
    pov_context_destroy(context);
}

/* Each file cut off at each byte: refused, with the file's name, and nothing is leaked. */
static void what_is_cut_off_is_refused(void **state)
{
    static const char *const endings[] = { "pfm", "png" };
    pov_context *context = scenes_context();
    float rgba[4 * PIXELS];
    char path[64], bytes[4096];
    (void)state;

    fill(rgba, 1.0f);
    for (int e = 0; e < 2; e++) {
        size_t length;
        FILE *f;

        snprintf(path, sizeof path, "/tmp/povtrace-read-%ld.%s", (long)getpid(), endings[e]);
        assert_int_equal(pov_image_write(context, path, WIDTH, HEIGHT, rgba, WIDTH * 16, NULL, NULL), POV_OK);
        f = fopen(path, "rb");
        length = fread(bytes, 1, sizeof bytes, f);
        fclose(f);
        /* The last chunk of a PNG says nothing of the picture. */
        for (size_t n = 0; n < length - (e == 1 ? 20 : 0); n++) {
            pov_bitmap back = POV_INIT(back);
            pov_error err = { 0 };

            f = fopen(path, "wb");
            fwrite(bytes, 1, n, f);
            fclose(f);
            assert_int_equal(pov_image_read(context, path, &back, &err), POV_E_IO);
            assert_string_equal(err.file, path);
        }
        remove(path);
    }
    pov_context_destroy(context);
}

static void a_format_that_cannot_be_read_says_so(void **state)
{
    pov_context *context = scenes_context();
    pov_bitmap back = POV_INIT(back);
    pov_error err = { 0 };
    (void)state;

    assert_int_equal(pov_image_read(context, "any.ppm", &back, &err), POV_E_UNSUPPORTED);
    assert_int_equal(pov_image_read(context, "nowhere/any.pfm", &back, &err), POV_E_IO);
    assert_int_equal(pov_image_read(context, "any", &back, &err), POV_E_ARGUMENT);
    pov_context_destroy(context);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_was_written_is_read),
        cmocka_unit_test(what_is_cut_off_is_refused),
        cmocka_unit_test(a_format_that_cannot_be_read_says_so),
    };

    return cmocka_run_group_tests_name("image_read", tests, NULL, NULL);
}
