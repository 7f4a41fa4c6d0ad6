/* test_images_load.c - each image format plugin, asked for the samples of a file as they are stored. */
#include <povtrace/image.h>
#include <povtrace/plugin.h>

#include <dlfcn.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

typedef struct loaded {
    pov_raster about;
    unsigned char palette[256][4], pixels[4096];
    bool refuses;
} loaded;

static void *begin(void *user, const pov_raster *about)
{
    loaded *l = user;

    l->about = *about;
    if (about->palette)
        memcpy(l->palette, about->palette, 4 * (size_t)about->colours);
    return l->refuses || (size_t)about->height * about->stride > sizeof l->pixels ? NULL : l->pixels;
}

static const pov_image_format *open_format(const char *ending)
{
    char path[1024];
    void *handle;
    const pov_plugin *plugin;

    snprintf(path, sizeof path, "%s/lib/povtrace/images/%s.so", TEST_BUILD, strcmp(ending, "pot") == 0 ? "gif" : ending);
    handle = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (!handle)
        return NULL;
    plugin = dlsym(handle, POV_PLUGIN_SYMBOL);
    assert_non_null(plugin);
    for (int i = 0; plugin->images[i]; i++)
        if (strcmp(plugin->images[i]->ending, ending) == 0 && plugin->images[i]->load)
            return plugin->images[i];
    fail_msg("%s does not load .%s", path, ending);
    return NULL;
}

static const char *load(const char *ending, const void *bytes, size_t count, loaded *out)
{
    const pov_image_format *format = open_format(ending);
    pov_raster_target target = { out, begin };

    assert_non_null(format);
    memset(out, 0, sizeof *out);
    return format->load(bytes, count, &target);
}

/* However early the file ends, it is refused, and so it is without memory. */
static void refuses_what_is_cut(const char *ending, const void *bytes, size_t count, size_t needed)
{
    const pov_image_format *format = open_format(ending);
    static loaded out;
    pov_raster_target target = { &out, begin };

    for (size_t n = 0; n < needed; n++) {
        void *copy = malloc(n + 1);

        memcpy(copy, bytes, n);
        if (!format->load(copy, n, &target))
            fail_msg("%zu of %zu bytes of a .%s file were accepted", n, count, ending);
        free(copy);
    }
    memset(&out, 0, sizeof out);
    out.refuses = true;
    assert_non_null(format->load(bytes, count, &target));
}

static void expect_size(const loaded *l, int width, int height, int channels, int bits)
{
    assert_int_equal(l->about.width, width);
    assert_int_equal(l->about.height, height);
    assert_int_equal(l->about.channels, channels);
    assert_int_equal(l->about.bits, bits);
}

/* ---- the formats ---- */

static const unsigned char gif[] = {
    'G', 'I', 'F', '8', '9', 'a', 4, 0, 3, 0, 0x81, 0, 0, 10, 20, 30, 40, 50, 60, 70, 80, 90, 255, 0, 1,
    0x21, 0xf9, 4, 1, 0, 0, 2, 0, 0x2c, 0, 0, 0, 0, 4, 0, 3, 0, 0, 2, 0x05, 0x84, 0x11, 0x19, 0x32, 0x5c, 0, 0x3b };

static void gif_has_a_palette_and_a_transparent_colour(void **state)
{
    static const unsigned char pixels[] = { 0, 0, 0, 0, 1, 1, 1, 1, 2, 3, 2, 3 };
    static loaded l;

    (void)state;
    assert_null(load("gif", gif, sizeof gif, &l));
    expect_size(&l, 4, 3, 1, 8);
    assert_memory_equal(l.pixels, pixels, sizeof pixels);
    assert_int_equal(l.about.colours, 4);
    assert_true(l.about.has_alpha);
    assert_memory_equal(l.palette[1], "\x28\x32\x3c\xff", 4);
    assert_memory_equal(l.palette[2], "\x46\x50\x5a\x00", 4);
    refuses_what_is_cut("gif", gif, sizeof gif, sizeof gif - 6);
}

static void pot_pairs_the_bytes_of_both_halves(void **state)
{
    static const uint16_t heights[] = { 0, 0, 0x101, 0x101, 0x202, 0x303 };
    unsigned char odd[sizeof gif];
    static loaded l;

    (void)state;
    assert_null(load("pot", gif, sizeof gif, &l));
    expect_size(&l, 2, 3, 1, 16);
    assert_memory_equal(l.pixels, heights, sizeof heights);
    assert_int_equal(l.about.colours, 0);
    refuses_what_is_cut("pot", gif, sizeof gif, sizeof gif - 6);
    memcpy(odd, gif, sizeof gif);
    odd[38] = 3;   /* the picture's width */
    assert_non_null(load("pot", odd, sizeof odd, &l));
}

/* Two columns, two rows, the lower one first; the second row is a packet of one colour. */
static const unsigned char tga[] = { 0, 0, 10, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 2, 0, 32, 8,
                                     1, 1, 2, 3, 4, 5, 6, 7, 8, 0x81, 9, 10, 11, 12 };

static void tga_rows_come_from_the_top_and_channels_in_order(void **state)
{
    static const unsigned char pixels[] = { 11, 10, 9, 12, 11, 10, 9, 12, 3, 2, 1, 4, 7, 6, 5, 8 };
    static loaded l;

    (void)state;
    assert_null(load("tga", tga, sizeof tga, &l));
    expect_size(&l, 2, 2, 4, 8);
    assert_memory_equal(l.pixels, pixels, sizeof pixels);
    refuses_what_is_cut("tga", tga, sizeof tga, sizeof tga);
}

static const unsigned char bmp[] = { 'B', 'M', 0, 0, 0, 0, 0, 0, 0, 0, 62, 0, 0, 0, 40, 0, 0, 0, 3, 0, 0, 0, 2, 0, 0, 0, 1, 0,
    4, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 3, 2, 1, 0, 6, 5, 4, 0,
    0x01, 0x10, 0, 0, 0x10, 0x00, 0, 0 };

static void bmp_unpacks_indices(void **state)
{
    static const unsigned char pixels[] = { 1, 0, 0, 0, 1, 1 };
    static loaded l;

    (void)state;
    assert_null(load("bmp", bmp, sizeof bmp, &l));
    expect_size(&l, 3, 2, 1, 8);
    assert_memory_equal(l.pixels, pixels, sizeof pixels);
    assert_int_equal(l.about.colours, 2);
    assert_memory_equal(l.palette[1], "\x04\x05\x06\xff", 4);
    refuses_what_is_cut("bmp", bmp, sizeof bmp, sizeof bmp);
}

static void hdr_gives_the_middle_of_what_a_mantissa_stands_for(void **state)
{
    static const char text[] = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 1\n\x80\x40\x00\x81\x01\x02\x03\x00";
    static loaded l;
    float v[6];

    (void)state;
    assert_null(load("hdr", text, sizeof text - 1, &l));
    expect_size(&l, 1, 2, 3, 32);
    assert_int_equal(l.about.encoding, POV_ENCODING_LINEAR);
    memcpy(v, l.pixels, sizeof v);
    assert_true(v[0] == 128.5f / 128 && v[1] == 64.5f / 128 && v[2] == 0.5f / 128 && v[3] == 0.0f);
    refuses_what_is_cut("hdr", text, sizeof text - 1, sizeof text - 1);
}

static void ppm_takes_grey_and_text_and_any_largest_value(void **state)
{
    static const char text[] = "P3 # a comment\n2 1 10\n0 5 10 1 2 3", grey[] = "P5 2 1 255\n\x07\xff";
    static loaded l;
    float v[6];

    (void)state;
    assert_null(load("ppm", text, strlen(text), &l));
    expect_size(&l, 2, 1, 3, 32);
    memcpy(v, l.pixels, sizeof v);
    assert_true(v[0] == 0.0f && v[1] == 0.5f && v[2] == 1.0f && v[5] == 0.3f);
    assert_null(load("ppm", grey, sizeof grey - 1, &l));
    expect_size(&l, 2, 1, 1, 8);
    assert_int_equal(l.about.encoding, POV_ENCODING_STORED);
    assert_memory_equal(l.pixels, "\x07\xff", 2);
    refuses_what_is_cut("ppm", grey, sizeof grey - 1, sizeof grey - 1);
}

/* ---- written by the same plugin ---- */

typedef struct bytes { unsigned char data[1 << 14]; size_t count; } bytes;

static bool put(void *user, const void *data, size_t count)
{
    bytes *b = user;

    if (b->count + count > sizeof b->data)
        return false;
    memcpy(b->data + b->count, data, count);
    b->count += count;
    return true;
}

static void write_grey(const char *ending, bytes *out)
{
    unsigned char pixels[8 * 8 * 3];
    pov_image image = { .size = sizeof image, .width = 8, .height = 8, .bits = 8, .transfer = POV_TRANSFER_SRGB,
                        .stride = 24, .pixels = pixels };
    pov_output output = { out, put };

    memset(pixels, 77, sizeof pixels);
    out->count = 0;
    assert_null(open_format(ending)->write(&image, &output));
}

static void alpha_is_written_and_loaded(void **state)
{
    static const unsigned char pixels[8] = { 10, 20, 30, 0, 40, 50, 60, 255 };
    pov_image image = { .size = sizeof image, .width = 2, .height = 1, .bits = 8, .stride = 8, .pixels = pixels, .alpha = 1,
                        .gamma = 2.0 };
    static loaded l;
    static bytes b;
    pov_output output = { &b, put };

    (void)state;
    assert_true(open_format("png")->depths & POV_IMAGE_ALPHA);
    assert_null(open_format("png")->write(&image, &output));
    assert_null(load("png", b.data, b.count, &l));
    expect_size(&l, 2, 1, 4, 8);
    assert_memory_equal(l.pixels, pixels, sizeof pixels);
    assert_int_equal(l.about.encoding, POV_ENCODING_POWER);
    assert_true(l.about.power > 1.999 && l.about.power < 2.001);
}

/* Three pixels a row, so that a row of BMP ends with bytes that stand for nothing. */
static void tga_and_bmp_load_what_they_wrote(void **state)
{
    static const char *const endings[] = { "tga", "bmp" };
    static const unsigned char pixels[2][16] = { { 1, 2, 3, 4, 5, 6, 7, 8, 9, 99, 99, 99, 99, 99, 99, 99 },
                                                 { 11, 12, 13, 14, 15, 16, 17, 18, 255, 99, 99, 99, 99, 99, 99, 99 } };
    pov_image image = { .size = sizeof image, .width = 3, .height = 2, .bits = 8, .stride = 16, .pixels = pixels };
    static loaded l;
    static bytes b;
    pov_output output = { &b, put };

    (void)state;
    for (size_t i = 0; i < 2; i++)
        for (int alpha = 0; alpha < 2; alpha++) {
            const size_t row = alpha ? 12 : 9;

            image.alpha = alpha;
            b.count = 0;
            assert_null(open_format(endings[i])->write(&image, &output));
            assert_null(load(endings[i], b.data, b.count, &l));
            expect_size(&l, 3, 2, alpha ? 4 : 3, 8);
            assert_memory_equal(l.pixels, pixels[0], row);
            assert_memory_equal(l.pixels + row, pixels[1], row);
            refuses_what_is_cut(endings[i], b.data, b.count, b.count - 3);
        }
}

static void what_is_written_is_loaded(void **state)
{
    static const char *const endings[] = { "png", "jpeg" };
    static loaded l;
    static bytes b;

    (void)state;
    for (size_t i = 0; i < 2; i++) {
        if (!open_format(endings[i]))
            continue;
        write_grey(endings[i], &b);
        assert_null(load(endings[i], b.data, b.count, &l));
        expect_size(&l, 8, 8, 3, 8);
        assert_int_equal(l.about.encoding, POV_ENCODING_SRGB);
        for (size_t k = 0; k < 192; k++)
            assert_int_equal(l.pixels[k], 77);
        refuses_what_is_cut(endings[i], b.data, b.count, b.count / 2);
    }
}

/* Floats come back as they were. */
static void exr_is_loaded_as_it_was_written(void **state)
{
    static const float pixels[2][6] = { { 1.0f, -2.0f, 0.5f, 1e30f, 3.0f, 0.0f }, { 7.0f, 8.0f, 9.0f, 10.0f, 11.0f, 12.0f } };
    pov_image image = { .size = sizeof image, .width = 2, .height = 2, .bits = 32, .stride = 24, .pixels = pixels };
    static loaded l;
    static bytes b;
    pov_output output = { &b, put };

    (void)state;
    if (!open_format("exr"))
        skip();
    assert_null(open_format("exr")->write(&image, &output));
    assert_null(load("exr", b.data, b.count, &l));
    expect_size(&l, 2, 2, 3, 32);
    assert_int_equal(l.about.encoding, POV_ENCODING_LINEAR);
    assert_memory_equal(l.pixels, pixels[0], sizeof pixels[0]);
    assert_memory_equal(l.pixels + l.about.stride, pixels[1], sizeof pixels[1]);
    refuses_what_is_cut("exr", b.data, b.count, b.count);
}

/* Layers stand between the colours by their names, and do not disturb these. */
static void exr_with_layers_has_its_colours(void **state)
{
    static const float pixels[2][6] = { { 1, 2, 3, 4, 5, 6 }, { 7, 8, 9, 10, 11, 12 } }, more[12] = { 90, 91, 92, 93 };
    const pov_layer layers[3] = { { "depth.Z", more, 1 }, { "Gx", more, 2 }, { "A.A", more + 1, 3 } };
    pov_image image = { .size = sizeof image, .width = 2, .height = 2, .bits = 32, .stride = 24, .pixels = pixels,
                        .layers = layers, .layer_count = 3 };
    static loaded l;
    static bytes b;
    pov_output output = { &b, put };

    (void)state;
    if (!open_format("exr"))
        skip();
    assert_null(open_format("exr")->write(&image, &output));
    assert_null(load("exr", b.data, b.count, &l));
    expect_size(&l, 2, 2, 3, 32);
    assert_memory_equal(l.pixels, pixels[0], sizeof pixels[0]);
    assert_memory_equal(l.pixels + l.about.stride, pixels[1], sizeof pixels[1]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gif_has_a_palette_and_a_transparent_colour),
        cmocka_unit_test(pot_pairs_the_bytes_of_both_halves),
        cmocka_unit_test(tga_rows_come_from_the_top_and_channels_in_order),
        cmocka_unit_test(bmp_unpacks_indices),
        cmocka_unit_test(hdr_gives_the_middle_of_what_a_mantissa_stands_for),
        cmocka_unit_test(ppm_takes_grey_and_text_and_any_largest_value),
        cmocka_unit_test(what_is_written_is_loaded),
        cmocka_unit_test(tga_and_bmp_load_what_they_wrote),
        cmocka_unit_test(exr_is_loaded_as_it_was_written),
        cmocka_unit_test(exr_with_layers_has_its_colours),
        cmocka_unit_test(alpha_is_written_and_loaded),
    };

    return cmocka_run_group_tests_name("images for textures", tests, NULL, NULL);
}
