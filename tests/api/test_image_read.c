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
    assert_near(there_and_back(context, "ppm", 8, POV_TRANSFER_LINEAR, 1.0f), 0.0, 0.502 / 255.0);
    assert_near(there_and_back(context, "ppm", 16, POV_TRANSFER_LINEAR, 1.0f), 0.0, 0.502 / 65535.0);
    /* Towards white a step of the sRGB curve is 2.28 times as wide. */
    assert_near(there_and_back(context, "png", 16, POV_TRANSFER_SRGB, 1.0f), 0.0, 2.3 * 0.502 / 65535.0);
    assert_near(there_and_back(context, "png", 8, POV_TRANSFER_SRGB, 1.0f), 0.0, 2.3 * 0.502 / 255.0);
    pov_context_destroy(context);
}

/* Each file cut off at each byte: refused, with the file's name, and nothing is leaked. */
static void what_is_cut_off_is_refused(void **state)
{
    static const char *const endings[] = { "pfm", "png", "ppm" };
    pov_context *context = scenes_context();
    float rgba[4 * PIXELS];
    char path[64], bytes[4096];
    (void)state;

    fill(rgba, 1.0f);
    for (int e = 0; e < 3; e++) {
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

/* Text as a PPM of one pixel, and how many bits it has. */
static pov_status read_ppm(const char *text, size_t length, float *rgba, int *bits, pov_error *err)
{
    pov_context *context = scenes_context();
    pov_bitmap back = POV_INIT(back);
    pov_status status;
    char path[64];
    FILE *f;

    snprintf(path, sizeof path, "/tmp/povtrace-read-%ld.ppm", (long)getpid());
    f = fopen(path, "wb");
    fwrite(text, 1, length, f);
    fclose(f);
    status = pov_image_read(context, path, &back, err);
    remove(path);
    if (status == POV_OK) {
        assert_true(back.width == 1 && back.height == 1);
        memcpy(rgba, back.rgba, 4 * sizeof *rgba);
        *bits = back.bits;
    }
    pov_image_free(context, &back);
    pov_context_destroy(context);
    return status;
}

static void assert_ppm_reads(const char *text, size_t length, int bits, float r, float g, float b)
{
    float rgba[4];
    int read;

    assert_int_equal(read_ppm(text, length, rgba, &read, NULL), POV_OK);
    assert_int_equal(read, bits);
    assert_near(rgba[0], r, 1e-7);
    assert_near(rgba[1], g, 1e-7);
    assert_near(rgba[2], b, 1e-7);
    assert_near(rgba[3], 1.0, 0.0);
}

static void ppm_takes_comments_any_largest_value_and_what_follows(void **state)
{
    static const char commented[] = "P6 # by hand\n1\t1\r\n# the largest value\n255\n\x00\x33\xff";
    static const char small[] = "P6\n1 1\n5\n\x00\x01\x05", wide[] = "P6\n1 1\n65535\n\x00\x00\x80\x00\xff\xff";
    static const char odd[] = "P6\n1 1\n1000\n\x00\x00\x00\xfa\x03\xe8 and another picture";
    (void)state;

    assert_ppm_reads(commented, sizeof commented - 1, 8, 0.0f, 0.2f, 1.0f);
    assert_ppm_reads(small, sizeof small - 1, 8, 0.0f, 0.2f, 1.0f);
    assert_ppm_reads(wide, sizeof wide - 1, 16, 0.0f, 32768.0f / 65535.0f, 1.0f);
    assert_ppm_reads(odd, sizeof odd - 1, 16, 0.0f, 16384.0f / 65535.0f, 1.0f);
}

static void assert_ppm_wrong(const char *text, const char *feature)
{
    pov_error err = { 0 };
    float rgba[4];
    int bits;

    assert_int_equal(read_ppm(text, strlen(text), rgba, &bits, &err), POV_E_IO);
    if (!strstr(err.message, feature))
        fail_msg("\"%s\" does not say \"%s\"", err.message, feature);
}

static void f8_a_wrong_ppm_is_told_apart(void **state)
{
    (void)state;

    assert_ppm_wrong("", "does not begin like a PPM");
    assert_ppm_wrong("P5\n1 1\n255\nabc", "does not begin like a PPM");
    assert_ppm_wrong("P3\n1 1\n255\n1 2 3\n", "plain text");
    assert_ppm_wrong("P6\n1 1\n255", "cut off in its header");
    assert_ppm_wrong("P6\n1 1\n255\nab", "cut off: its header promises");
    assert_ppm_wrong("P6\n0 1\n255\nabc", "header is wrong");
    assert_ppm_wrong("P6\n-1 1\n255\nabc", "header is wrong");
    assert_ppm_wrong("P6\n1 1\n65536\nabcabc", "header is wrong");
    assert_ppm_wrong("P6\n99999999999 1\n255\nabc", "header is wrong");
    /* F8 of the review. */
    assert_ppm_wrong("P6\n2684354569 1\n255\nabc", "header is wrong");
    assert_ppm_wrong("P6\n1 1\n255#\nabc", "header is wrong");
    assert_ppm_wrong("P6\n268435456 268435456\n65535\nabc", "cut off: its header promises");
    assert_ppm_wrong("P6\n1 1\n50\nabc", "larger than its header's largest");
}

static void a_format_that_cannot_be_read_says_so(void **state)
{
    pov_context *context = scenes_context();
    pov_bitmap back = POV_INIT(back);
    pov_error err = { 0 };
    (void)state;

    assert_int_equal(pov_image_read(context, "nowhere/any.pfm", &back, &err), POV_E_IO);
    assert_int_equal(pov_image_read(context, "any", &back, &err), POV_E_ARGUMENT);
    pov_context_destroy(context);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_was_written_is_read),
        cmocka_unit_test(what_is_cut_off_is_refused),
        cmocka_unit_test(ppm_takes_comments_any_largest_value_and_what_follows),
        cmocka_unit_test(f8_a_wrong_ppm_is_told_apart),
        cmocka_unit_test(a_format_that_cannot_be_read_says_so),
    };

    return cmocka_run_group_tests_name("image_read", tests, NULL, NULL);
}
