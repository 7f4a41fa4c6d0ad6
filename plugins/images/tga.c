/* tga.c - Truevision TGA. Written: true colour, not packed. Read: indexed, true colour and grey, packed or not. */
#include "common/bgr.h"
#include "common/bytes.h"

#include <povtrace/image.h>
#include <povtrace/plugin.h>

#include <string.h>

enum { INDEXED = 1, COLOUR = 2, GREY = 3, PACKED = 8 };

typedef struct header {
    int kind;                 /* without PACKED */
    bool is_packed, from_top, from_right;
    unsigned first, colours, colour_bits, bits;
    size_t bytes;             /* of a pixel as stored */
    pov_raster about;
    unsigned char palette[256][4];
} header;

static unsigned wide5(unsigned v) { return (v << 3) | (v >> 2); }

/* Blue, green, red, alpha, or 5 bits each, to red, green, blue, alpha. */
static void unpack_colour(const unsigned char *from, unsigned bits, unsigned char to[4])
{
    const unsigned both = from[0] | (bits > 8 ? (unsigned)from[1] << 8 : 0u);

    if (bits <= 16) {
        to[0] = (unsigned char)wide5(both >> 10 & 31);
        to[1] = (unsigned char)wide5(both >> 5 & 31);
        to[2] = (unsigned char)wide5(both & 31);
        to[3] = 255;
    } else {
        to[0] = from[2];
        to[1] = from[1];
        to[2] = from[0];
        to[3] = bits == 32 ? from[3] : 255;
    }
}

static const char *read_palette(common_bytes *in, header *h)
{
    const size_t bytes = (h->colour_bits + 7) / 8;

    if (h->kind != INDEXED)
        return common_bytes_take(in, h->colours * bytes) ? NULL : "it is cut off in its colour map";
    if (h->colours == 0 || h->first + h->colours > 256 || bytes < 2 || bytes > 4)
        return "its colour map is wrong";
    for (unsigned i = 0; i < h->colours; i++) {
        const unsigned char *from = common_bytes_take(in, bytes);

        if (!from)
            return "it is cut off in its colour map";
        unpack_colour(from, h->colour_bits, h->palette[h->first + i]);
    }
    h->about.palette = h->palette[0];
    h->about.colours = (int)(h->first + h->colours);
    return NULL;
}

static bool is_known(const header *h)
{
    if (h->kind == INDEXED || h->kind == GREY)
        return h->bits == 8;
    return h->kind == COLOUR && (h->bits == 15 || h->bits == 16 || h->bits == 24 || h->bits == 32);
}

static const char *read_header(common_bytes *in, header *h)
{
    const unsigned text = common_byte(in);
    unsigned kind, place;

    common_byte(in);
    kind = common_byte(in);
    h->first = common_byte2(in);
    h->colours = common_byte2(in);
    h->colour_bits = common_byte(in);
    common_byte4(in);
    h->about.width = (int)common_byte2(in);
    h->about.height = (int)common_byte2(in);
    h->bits = common_byte(in);
    place = common_byte(in);
    h->kind = (int)(kind & 7u);
    h->is_packed = (kind & PACKED) != 0;
    h->from_right = (place & 16) != 0;
    h->from_top = (place & 32) != 0;
    h->bytes = (h->bits + 7) / 8;
    if (in->is_cut || (kind & ~15u) != 0 || !is_known(h) || h->about.width < 1 || h->about.height < 1)
        return "it does not begin like a TGA that is known here";
    if (!common_bytes_take(in, text))
        return "it is cut off in its header";
    h->about.channels = h->kind == COLOUR ? (h->bits == 32 && (place & 15u) ? 4 : 3) : 1;
    h->about.bits = 8;
    h->about.stride = (size_t)h->about.width * (size_t)h->about.channels;
    return read_palette(in, h);
}

/* A pixel goes where it belongs in rows from the top. */
static void put(const header *h, unsigned char *pixels, size_t index, const unsigned char *from)
{
    const size_t width = (size_t)h->about.width, row = index / width, column = index % width;
    const size_t y = h->from_top ? row : (size_t)h->about.height - 1 - row, x = h->from_right ? width - 1 - column : column;
    unsigned char *to = pixels + y * h->about.stride + x * (size_t)h->about.channels, colour[4];

    if (h->kind != COLOUR) {
        to[0] = from[0];
        return;
    }
    unpack_colour(from, h->bits, colour);
    memcpy(to, colour, (size_t)h->about.channels);
}

static const char *read_pixels(common_bytes *in, const header *h, unsigned char *pixels)
{
    const size_t total = (size_t)h->about.width * (size_t)h->about.height;
    size_t i = 0;

    while (i < total) {
        const unsigned word = h->is_packed ? common_byte(in) : 127u;
        const size_t length = (word & 127u) + 1, n = length < total - i ? length : total - i;
        const bool repeats = word > 127;
        const unsigned char *from = common_bytes_take(in, (repeats ? 1 : n) * h->bytes);

        if (!from)
            return "it is cut off";
        for (size_t k = 0; k < n; k++)
            put(h, pixels, i++, from + (repeats ? 0 : k * h->bytes));
    }
    return NULL;
}

static const char *load_tga(const void *bytes, size_t count, const pov_raster_target *target)
{
    common_bytes in = common_bytes_of(bytes, count);
    header h = { .about = POV_INIT(h.about) };
    const char *wrong = read_header(&in, &h);
    unsigned char *pixels;

    if (wrong)
        return wrong;
    /* A packet of 128 pixels takes two bytes at least. */
    if ((size_t)h.about.width * (size_t)h.about.height / 128 > common_bytes_left(&in))
        return "it is cut off";
    pixels = target->begin(target->user, &h.about);
    return pixels ? read_pixels(&in, &h, pixels) : "there is no memory for it";
}

/* ---- writing ---- */

static const char *write_tga(const pov_image *image, const pov_output *output)
{
    const int channels = image->alpha ? 4 : 3;
    unsigned char head[18] = { [2] = COLOUR, [17] = 32 };   /* rows from the top */

    if (image->width > 65535 || image->height > 65535)
        return "a TGA has at most 65535 x 65535 pixels";
    common_put2(head + 12, (unsigned)image->width);
    common_put2(head + 14, (unsigned)image->height);
    head[16] = (unsigned char)(8 * channels);
    head[17] |= image->alpha ? 8 : 0;
    if (!output->put(output->user, head, sizeof head))
        return "could not write the header";
    for (int y = 0; y < image->height; y++)
        if (!common_put_bgr((const char *)image->pixels + (size_t)y * image->stride, image->width, channels, output->put,
                            output->user))
            return "could not write a row";
    return NULL;
}

static const pov_image_format tga = {
    .size = sizeof(pov_image_format), .depths = POV_IMAGE_8 | POV_IMAGE_ALPHA, .ending = "tga", .write = write_tga, .load = load_tga,
};
static const pov_image_format *const formats[] = { &tga, NULL };

POV_PLUGIN(tga) = {
    .abi = POV_PLUGIN_ABI, .size = sizeof(pov_plugin), .name = "tga", .version = "0.1.0", .images = formats,
};
