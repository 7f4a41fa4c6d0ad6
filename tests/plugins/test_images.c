/* test_images.c - each image format plugin, asked as the library asks it. */
#include <povtrace/image.h>
#include <povtrace/plugin.h>

#include <dlfcn.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>
#include <png.h>

typedef struct bytes {
    unsigned char data[1 << 16];
    size_t count, limit;      /* puts that would pass the limit fail */
} bytes;

static bool put(void *user, const void *data, size_t count)
{
    bytes *b = user;

    if (b->count + count > b->limit)
        return false;
    memcpy(b->data + b->count, data, count);
    b->count += count;
    return true;
}

static const pov_image_format *open_format(const char *ending)
{
    char path[1024];
    void *handle;
    const pov_plugin *plugin;

    snprintf(path, sizeof path, "%s/lib/povtrace/images/%s.so", TEST_BUILD, ending);
    handle = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    assert_non_null(handle);
    plugin = dlsym(handle, POV_PLUGIN_SYMBOL);
    assert_non_null(plugin);
    assert_int_equal(plugin->abi, POV_PLUGIN_ABI);
    assert_string_equal(plugin->images[0]->ending, ending);
    return plugin->images[0];
}

static const char *write_image(const char *ending, pov_image image, bytes *out, size_t limit)
{
    pov_output output = { out, put };

    image.size = sizeof image;
    out->count = 0;
    out->limit = limit;
    return open_format(ending)->write(&image, &output);
}

/* Two rows of three pixels, with a gap behind each row that must not be stored. */
static const uint8_t pixels8[2][12] = { { 1, 2, 3, 4, 5, 6, 7, 8, 9, 99, 99, 99 },
                                        { 11, 12, 13, 14, 15, 16, 17, 18, 255, 99, 99, 99 } };
static const uint16_t pixels16[2][10] = { { 0x0102, 3, 0xfffe, 4, 5, 6, 7, 8, 9, 99 },
                                          { 11, 12, 13, 14, 15, 16, 17, 18, 0xffff, 99 } };

static pov_image image8(pov_transfer transfer)
{
    pov_image image = { .width = 3, .height = 2, .bits = 8, .transfer = transfer, .stride = 12,
                        .pixels = pixels8 };
    return image;
}

static pov_image image16(void)
{
    pov_image image = { .width = 3, .height = 2, .bits = 16, .stride = 20, .pixels = pixels16 };
    return image;
}

static void ppm_stores_rows_from_the_top_without_their_gaps(void **state)
{
    static bytes out;
    static const char header[] = "P6\n3 2\n255\n";
    size_t head = strlen(header);

    (void)state;
    assert_null(write_image("ppm", image8(POV_TRANSFER_LINEAR), &out, sizeof out.data));
    assert_int_equal(out.count, head + 18);
    assert_memory_equal(out.data, header, head);
    assert_memory_equal(out.data + head, pixels8[0], 9);
    assert_memory_equal(out.data + head + 9, pixels8[1], 9);
}

static void ppm_stores_16_bits_high_byte_first(void **state)
{
    static bytes out;
    static const char header[] = "P6\n3 2\n65535\n";
    static const unsigned char first[] = { 1, 2, 0, 3, 0xff, 0xfe };
    size_t head = strlen(header);

    (void)state;
    assert_null(write_image("ppm", image16(), &out, sizeof out.data));
    assert_int_equal(out.count, head + 36);
    assert_memory_equal(out.data + head, first, 6);
    assert_memory_equal(out.data + out.count - 2, "\xff\xff", 2);
}

/* The header as POV-Ray 3.7 writes it with +FT, then blue, green, red from the top left. */
static void tga_has_the_header_of_povrays(void **state)
{
    static const unsigned char header[18] = { 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 3, 0, 2, 0, 24, 32 }, first[] = { 3, 2, 1, 6, 5, 4 };
    static bytes out;

    (void)state;
    assert_null(write_image("tga", image8(POV_TRANSFER_SRGB), &out, sizeof out.data));
    assert_int_equal(out.count, 18 + 18);
    assert_memory_equal(out.data, header, 18);
    assert_memory_equal(out.data + 18, first, 6);
}

static void pfm_stores_little_endian_floats_from_the_bottom(void **state)
{
    static bytes out;
    static const float pixels[2][3] = { { 1.0f, -2.0f, 0.0f }, { 1e30f, 0.5f, 3.0f } };
    static const unsigned char half[] = { 0, 0, 0, 0x3f }, one[] = { 0, 0, 0x80, 0x3f };
    pov_image image = { .width = 1, .height = 2, .bits = 32, .stride = 12, .pixels = pixels };
    static const char header[] = "PF\n1 2\n-1.0\n";
    size_t head = strlen(header);

    (void)state;
    assert_null(write_image("pfm", image, &out, sizeof out.data));
    assert_int_equal(out.count, head + 24);
    assert_memory_equal(out.data, header, head);
    assert_memory_equal(out.data + head + 4, half, 4);
    assert_memory_equal(out.data + head + 12, one, 4);
}

static void hdr_stores_mantissas_and_an_exponent(void **state)
{
    static bytes out;
    static const float pixels[2][3] = { { 1.0f, 0.5f, -2.0f }, { 0.0f, 0.0f, 0.0f } };
    static float wide[9][3];
    pov_image image = { .width = 1, .height = 2, .bits = 32, .stride = 12, .pixels = pixels };
    static const char header[] = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 1\n";
    size_t head = strlen(header);

    (void)state;
    assert_null(write_image("hdr", image, &out, sizeof out.data));
    assert_int_equal(out.count, head + 8);
    assert_memory_equal(out.data, header, head);
    assert_memory_equal(out.data + head, "\x80\x40\x00\x81\0\0\0\0", 8);
    for (int i = 0; i < 9; i++)
        wide[i][1] = 255.0f;
    image = (pov_image){ .width = 9, .height = 1, .bits = 32, .stride = sizeof wide, .pixels = wide };
    assert_null(write_image("hdr", image, &out, sizeof out.data));
    assert_memory_equal(out.data + out.count - 44, "\x02\x02\0\x09\x09", 5);
    assert_memory_equal(out.data + out.count - 30, "\x09\xff\xff\xff\xff\xff\xff\xff\xff\xff", 10);
    assert_memory_equal(out.data + out.count - 10, "\x09\x88\x88\x88\x88\x88\x88\x88\x88\x88", 10);
}

static bool has_chunk(const bytes *file, const char *name)
{
    for (size_t i = 0; i + 4 <= file->count; i++) {
        if (memcmp(file->data + i, name, 4) == 0)
            return true;
    }
    return false;
}

static void decode(const bytes *file, int format, void *pixels)
{
    png_image image = { .version = PNG_IMAGE_VERSION };

    assert_true(png_image_begin_read_from_memory(&image, file->data, file->count));
    assert_int_equal(image.width, 3);
    assert_int_equal(image.height, 2);
    image.format = (png_uint_32)format;
    assert_true(png_image_finish_read(&image, NULL, pixels, 0, NULL));
}

static void png_of_8_bits_reads_back_the_same(void **state)
{
    static bytes out;
    uint8_t back[2][9];

    (void)state;
    assert_null(write_image("png", image8(POV_TRANSFER_SRGB), &out, sizeof out.data));
    decode(&out, PNG_FORMAT_RGB, back);
    assert_memory_equal(back[0], pixels8[0], 9);
    assert_memory_equal(back[1], pixels8[1], 9);
}

/* libpng's simplified reader converts 16 bits, so the samples are read by the low-level one. */
typedef struct source { const bytes *file; size_t at; } source;

static void get_bytes(png_structp png, png_bytep to, png_size_t count)
{
    source *from = png_get_io_ptr(png);

    assert_true(from->at + count <= from->file->count);
    memcpy(to, from->file->data + from->at, count);
    from->at += count;
}

static void png_of_16_bits_reads_back_the_same(void **state)
{
    static bytes out;
    source from = { &out, 0 };
    png_structp png;
    png_infop info;

    (void)state;
    assert_null(write_image("png", image16(), &out, sizeof out.data));
    png = png_create_read_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    info = png_create_info_struct(png);
    png_set_read_fn(png, &from, get_bytes);
    png_read_png(png, info, PNG_TRANSFORM_IDENTITY, NULL);
    assert_int_equal(png_get_bit_depth(png, info), 16);
    assert_int_equal(png_get_color_type(png, info), PNG_COLOR_TYPE_RGB);
    for (int y = 0; y < 2; y++) {
        const unsigned char *row = png_get_rows(png, info)[y];

        for (int i = 0; i < 9; i++)
            assert_int_equal(row[2 * i] << 8 | row[2 * i + 1], pixels16[y][i]);
    }
    png_destroy_read_struct(&png, &info, NULL);
}

static void png_says_srgb_of_encoded_values_and_nothing_of_plain_ones(void **state)
{
    static bytes out;

    (void)state;
    assert_null(write_image("png", image8(POV_TRANSFER_SRGB), &out, sizeof out.data));
    assert_true(has_chunk(&out, "sRGB"));
    assert_null(write_image("png", image8(POV_TRANSFER_LINEAR), &out, sizeof out.data));
    assert_false(has_chunk(&out, "sRGB"));
    assert_false(has_chunk(&out, "gAMA"));
}

/* However early the output ends, write says what went wrong and puts no more. */
static void every_format_stops_when_the_output_is_full(void **state)
{
    static bytes out;
    static const float floats[2][9];
    pov_image image = { .width = 3, .height = 2, .bits = 32, .stride = 36, .pixels = floats };
    size_t whole;

    (void)state;
    assert_null(write_image("png", image16(), &out, sizeof out.data));
    whole = out.count;
    for (size_t limit = 0; limit < whole; limit++)
        assert_non_null(write_image("png", image16(), &out, limit));
    assert_null(write_image("png", image16(), &out, whole));
    for (size_t limit = 0; limit < 12 + 72; limit += 3)
        assert_non_null(write_image("pfm", image, &out, limit));
    for (size_t limit = 0; limit < 13 + 36; limit += 3)
        assert_non_null(write_image("ppm", image16(), &out, limit));
    for (size_t limit = 0; limit < 18 + 18; limit++)
        assert_non_null(write_image("tga", image8(POV_TRANSFER_SRGB), &out, limit));
    for (size_t limit = 0; limit < 54 + 24; limit++)
        assert_non_null(write_image("bmp", image8(POV_TRANSFER_SRGB), &out, limit));
}

static void png_refuses_a_size_that_it_cannot_hold(void **state)
{
    static bytes out;
    pov_image image = image8(POV_TRANSFER_LINEAR);

    (void)state;
    image.width = 0;
    assert_non_null(write_image("png", image, &out, sizeof out.data));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ppm_stores_rows_from_the_top_without_their_gaps),
        cmocka_unit_test(ppm_stores_16_bits_high_byte_first),
        cmocka_unit_test(hdr_stores_mantissas_and_an_exponent),
        cmocka_unit_test(tga_has_the_header_of_povrays),
        cmocka_unit_test(pfm_stores_little_endian_floats_from_the_bottom),
        cmocka_unit_test(png_of_8_bits_reads_back_the_same),
        cmocka_unit_test(png_of_16_bits_reads_back_the_same),
        cmocka_unit_test(png_says_srgb_of_encoded_values_and_nothing_of_plain_ones),
        cmocka_unit_test(every_format_stops_when_the_output_is_full),
        cmocka_unit_test(png_refuses_a_size_that_it_cannot_hold),
    };

    return cmocka_run_group_tests_name("image plugins", tests, NULL, NULL);
}
