/* hdr.c - Radiance pictures (RGBE): three mantissas and an exponent a pixel, in runs of equal bytes or not. */
#include "common/bytes.h"

#include <povtrace/image.h>
#include <povtrace/plugin.h>

#include <math.h>
#include <stdio.h>
#include <string.h>

/* A line of the header, without its end; false: there is none. */
static bool next_line(common_bytes *in, const char **text, size_t *length)
{
    const unsigned char *end = memchr(in->at, '\n', common_bytes_left(in));

    *text = (const char *)in->at;
    if (!end)
        return false;
    *length = (size_t)(end - in->at);
    in->at = end + 1;
    return true;
}

static int read_number(const char **at, const char *end)
{
    int value = 0;

    for (; *at < end && **at >= '0' && **at <= '9' && value < 100000000; (*at)++)
        value = 10 * value + (**at - '0');
    return value;
}

/* "-Y 480 +X 640": rows from the top, as nearly all files have them. */
static bool read_size(const char *text, size_t length, pov_raster *about)
{
    const char *end = text + length;

    if (length < 8 || memcmp(text, "-Y ", 3) != 0)
        return false;
    text += 3;
    about->height = read_number(&text, end);
    if (end - text < 5 || memcmp(text, " +X ", 4) != 0)
        return false;
    text += 4;
    about->width = read_number(&text, end);
    return about->width > 0 && about->height > 0;
}

static const char *read_header(common_bytes *in, pov_raster *about)
{
    const char *text;
    size_t length;

    if (common_bytes_left(in) < 2 || memcmp(in->at, "#?", 2) != 0)
        return "it does not begin like a Radiance picture";
    do
        if (!next_line(in, &text, &length))
            return "it is cut off in its header";
    while (length > 0);
    if (!next_line(in, &text, &length) || !read_size(text, length, about))
        return "its header has no size of the form \"-Y height +X width\"";
    about->bits = 32;
    about->channels = 3;
    about->encoding = POV_ENCODING_LINEAR;
    about->stride = 3 * sizeof(float) * (size_t)about->width;
    return NULL;
}

/* The middle of the interval that a mantissa stands for; exponent 0 is black. */
static float value_of(unsigned mantissa, unsigned exponent)
{
    return exponent == 0 ? 0.0f : (float)ldexp(mantissa + 0.5, (int)exponent - 136);
}

/* A row whose components stand one after the other, each in runs. They meet in the row of floats, whose bytes are at
 * first those of the file: component c of pixel x is byte 12 x + c. */
static bool read_runs(common_bytes *in, size_t width, unsigned char *bytes)
{
    for (size_t c = 0; c < 4; c++)
        for (size_t x = 0; x < width;) {
            const unsigned word = common_byte(in);
            const size_t n = word > 128 ? word - 128 : word;
            const unsigned char *from = common_bytes_take(in, word > 128 ? 1 : n);

            if (!from || n == 0 || n > width - x)
                return false;
            for (size_t i = 0; i < n; i++, x++)
                bytes[12 * x + c] = from[word > 128 ? 0 : i];
        }
    return true;
}

/* Four bytes a pixel. In the oldest files red, green and blue of 1 repeat the pixel before. */
static bool read_plain(common_bytes *in, size_t width, unsigned char *bytes)
{
    unsigned shift = 0;

    for (size_t x = 0; x < width;) {
        const unsigned char *from = common_bytes_take(in, 4);
        size_t n;

        if (!from)
            return false;
        if (x == 0 || from[0] != 1 || from[1] != 1 || from[2] != 1) {
            memcpy(bytes + 12 * x++, from, 4);
            shift = 0;
            continue;
        }
        for (n = shift < 32 ? (size_t)from[3] << shift : 0; n > 0 && x < width; n--, x++)
            memcpy(bytes + 12 * x, bytes + 12 * (x - 1), 4);
        shift += 8;
    }
    return true;
}

static bool read_row(common_bytes *in, size_t width, unsigned char *bytes)
{
    const unsigned char *at = in->at;
    bool in_runs = common_bytes_left(in) >= 4 && at[0] == 2 && at[1] == 2 && (size_t)(at[2] << 8 | at[3]) == width;

    if (in_runs)
        common_bytes_take(in, 4);
    if (!(in_runs ? read_runs(in, width, bytes) : read_plain(in, width, bytes)))
        return false;
    for (size_t x = 0; x < width; x++, bytes += 12) {
        const float colour[3] = { value_of(bytes[0], bytes[3]), value_of(bytes[1], bytes[3]), value_of(bytes[2], bytes[3]) };

        memcpy(bytes, colour, sizeof colour);
    }
    return true;
}

static const char *load_hdr(const void *bytes, size_t count, const pov_raster_target *target)
{
    common_bytes in = common_bytes_of(bytes, count);
    pov_raster about = POV_INIT(about);
    const char *wrong = read_header(&in, &about);
    unsigned char *pixels;

    if (wrong)
        return wrong;
    if (common_bytes_left(&in) / 4 < (size_t)about.height || (size_t)about.width / 32 > common_bytes_left(&in))
        return "it is cut off";
    pixels = target->begin(target->user, &about);
    if (!pixels)
        return "there is no memory for it";
    for (int y = 0; y < about.height; y++)
        if (!read_row(&in, (size_t)about.width, pixels + (size_t)y * about.stride))
            return "it is cut off or damaged";
    return NULL;
}

/* ---- writing ---- */

enum { ROW_PIXELS = 128, RUNS_LEAST = 8, RUNS_MOST = 32767 };

/* The largest component has a mantissa of 128 to 255. What is not above 0 is black, what is too large the largest. */
static void put_pixel(const float *colour, unsigned char out[4])
{
    const double most = ldexp(255.0, 127 - 8);
    double largest = 0.0;
    int exponent;

    for (int c = 0; c < 3; c++)
        if (colour[c] > largest)
            largest = colour[c];
    memset(out, 0, 4);
    if (!(largest > 1e-38))
        return;
    frexp(largest < most ? largest : most, &exponent);
    for (int c = 0; c < 3; c++)
        out[c] = colour[c] > 0.0f ? (unsigned char)pov_min(ldexp(colour[c], 8 - exponent), 255.0) : 0;
    out[3] = (unsigned char)(exponent + 128);
}

/* Readers take a row that begins with 2, 2 for one in runs: so it is one, of runs of different bytes, where it may. */
static bool put_runs(const pov_output *output, const float *row, int width)
{
    const unsigned char head[4] = { 2, 2, (unsigned char)(width >> 8), (unsigned char)(width & 255) };

    if (!output->put(output->user, head, sizeof head))
        return false;
    for (int c = 0; c < 4; c++)
        for (int x = 0; x < width; x += ROW_PIXELS) {
            unsigned char run[1 + ROW_PIXELS], pixel[4];
            const int n = width - x < ROW_PIXELS ? width - x : ROW_PIXELS;

            run[0] = (unsigned char)n;
            for (int i = 0; i < n; i++) {
                put_pixel(row + 3 * (size_t)(x + i), pixel);
                run[1 + i] = pixel[c];
            }
            if (!output->put(output->user, run, (size_t)n + 1))
                return false;
        }
    return true;
}

static bool put_row(const pov_output *output, const float *row, int width)
{
    if (width >= RUNS_LEAST && width <= RUNS_MOST)
        return put_runs(output, row, width);
    for (int x = 0; x < width; x++) {
        unsigned char pixel[4];

        put_pixel(row + 3 * (size_t)x, pixel);
        if (!output->put(output->user, pixel, sizeof pixel))
            return false;
    }
    return true;
}

static const char *write_hdr(const pov_image *image, const pov_output *output)
{
    char header[96];
    const int length = snprintf(header, sizeof header, "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y %d +X %d\n",
                                image->height, image->width);

    if (!output->put(output->user, header, (size_t)length))
        return "could not write the header";
    for (int y = 0; y < image->height; y++)
        if (!put_row(output, (const float *)(const void *)((const char *)image->pixels + (size_t)y * image->stride),
                     image->width))
            return "could not write a row";
    return NULL;
}

static const pov_image_format hdr = {
    .size = sizeof(pov_image_format),
    .depths = POV_IMAGE_FLOAT,
    .ending = "hdr",
    .write = write_hdr,
    .load = load_hdr,
};
static const pov_image_format *const formats[] = { &hdr, NULL };

POV_PLUGIN(hdr) = {
    .abi = POV_PLUGIN_ABI, .size = sizeof(pov_plugin), .name = "hdr", .version = "0.1.0", .images = formats,
};
