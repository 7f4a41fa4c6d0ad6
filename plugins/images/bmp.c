/* bmp.c - Windows bitmaps, not packed. Written: 24 bits, or 32 with alpha. Read: 1, 4 and 8 bits with a palette, too. */
#include "common/bgr.h"
#include "common/bytes.h"

#include <povtrace/image.h>
#include <povtrace/plugin.h>

#include <string.h>

enum { PLAIN = 0, FIELDS = 3 };

typedef struct header {
    uint32_t offset, packing, colours;
    unsigned bits;
    size_t colour_bytes, row;   /* of a palette's entry; of a row as stored */
    bool from_top;
    pov_raster about;
    unsigned char palette[256][4];
} header;

/* The first form of the format has sizes of 16 bits, and no packing. */
static void read_sizes(common_bytes *in, header *h, bool is_short)
{
    int32_t height;

    h->about.width = is_short ? (int)common_byte2(in) : (int32_t)common_byte4(in);
    height = is_short ? (int)common_byte2(in) : (int32_t)common_byte4(in);
    h->from_top = height < 0;
    h->about.height = height == INT32_MIN ? 0 : height < 0 ? -height : height;
    common_byte2(in);
    h->bits = common_byte2(in);
    h->colour_bytes = is_short ? 3 : 4;
    if (is_short)
        return;
    h->packing = common_byte4(in);
    common_bytes_take(in, 12);
    h->colours = common_byte4(in);
    common_byte4(in);
}

static const char *read_palette(common_bytes *in, header *h)
{
    if (h->colours == 0)
        h->colours = 1u << h->bits;
    if (h->colours > 1u << h->bits)
        return "its palette is wrong";
    for (uint32_t i = 0; i < h->colours; i++) {
        const unsigned char *from = common_bytes_take(in, h->colour_bytes);

        if (!from)
            return "it is cut off in its palette";
        h->palette[i][0] = from[2];
        h->palette[i][1] = from[1];
        h->palette[i][2] = from[0];
        h->palette[i][3] = 255;
    }
    h->about.palette = h->palette[0];
    h->about.colours = (int)h->colours;
    return NULL;
}

static const char *read_header(common_bytes *in, header *h)
{
    const unsigned magic = common_byte2(in);
    uint32_t length;

    common_bytes_take(in, 8);
    h->offset = common_byte4(in);
    length = common_byte4(in);
    if (in->is_cut || magic != ('B' | 'M' << 8) || length < 12)
        return "it does not begin like a BMP";
    read_sizes(in, h, length < 40);
    if (length > 40)
        common_bytes_take(in, length - 40);
    if (in->is_cut || h->about.width < 1 || h->about.height < 1 || h->about.width > 1 << 28)
        return "its header is wrong";
    if (h->packing != PLAIN && !(h->packing == FIELDS && h->bits == 32))
        return "it is a packed BMP, which is not read";
    if (h->bits != 1 && h->bits != 4 && h->bits != 8 && h->bits != 24 && h->bits != 32)
        return "it has another number of bits a pixel than 1, 4, 8, 24 or 32";
    h->row = ((size_t)h->about.width * h->bits + 31) / 32 * 4;
    h->about.bits = 8;
    h->about.channels = h->bits == 32 ? 4 : h->bits == 24 ? 3 : 1;
    h->about.stride = (size_t)h->about.width * (size_t)h->about.channels;
    return h->bits <= 8 ? read_palette(in, h) : NULL;
}

static void unpack_row(const header *h, const unsigned char *from, unsigned char *to)
{
    const unsigned per_byte = h->bits < 8 ? 8 / h->bits : 1, mask = (1u << (h->bits & 15)) - 1;
    const int channels = h->about.channels;

    for (int x = 0; x < h->about.width; x++, to += channels) {
        if (channels == 1) {
            const unsigned shift = 8 - h->bits * ((unsigned)x % per_byte + 1);

            to[0] = (unsigned char)(from[(unsigned)x / per_byte] >> shift & mask);
            continue;
        }
        to[0] = from[x * channels + 2];
        to[1] = from[x * channels + 1];
        to[2] = from[x * channels];
        if (channels == 4)
            to[3] = from[x * channels + 3];
    }
}

/* In most files the fourth byte is not used, and is 0 throughout. */
static void make_opaque(const header *h, unsigned char *pixels)
{
    const size_t n = 4 * (size_t)h->about.width * (size_t)h->about.height;

    for (size_t i = 3; i < n; i += 4)
        if (pixels[i] != 0)
            return;
    for (size_t i = 3; i < n; i += 4)
        pixels[i] = 255;
}

static const char *load_bmp(const void *bytes, size_t count, const pov_raster_target *target)
{
    common_bytes in = common_bytes_of(bytes, count);
    header h = { .about = POV_INIT(h.about) };
    const char *wrong = read_header(&in, &h);
    unsigned char *pixels;

    if (wrong)
        return wrong;
    if (h.offset > count || (count - h.offset) / h.row < (size_t)h.about.height)
        return "it is cut off";
    pixels = target->begin(target->user, &h.about);
    if (!pixels)
        return "there is no memory for it";
    for (int y = 0; y < h.about.height; y++)
        unpack_row(&h, (const unsigned char *)bytes + h.offset + (size_t)y * h.row,
                   pixels + (size_t)(h.from_top ? y : h.about.height - 1 - y) * h.about.stride);
    if (h.bits == 32)
        make_opaque(&h, pixels);
    return NULL;
}

/* ---- writing ---- */

enum { FILE_HEADER = 14, INFO_HEADER = 40 };

static const char *write_bmp(const pov_image *image, const pov_output *output)
{
    static const unsigned char zeros[4];
    const int channels = image->alpha ? 4 : 3;
    const size_t bytes = (size_t)image->width * (size_t)channels, padding = (4 - bytes % 4) % 4;
    const uint64_t size = (uint64_t)(bytes + padding) * (uint64_t)image->height;
    unsigned char head[FILE_HEADER + INFO_HEADER] = { 'B', 'M' };

    if (size > UINT32_MAX - sizeof head)
        return "a BMP has less than 4 GiB";
    common_put4(head + 2, (uint32_t)(size + sizeof head));
    common_put4(head + 10, sizeof head);
    common_put4(head + 14, INFO_HEADER);
    common_put4(head + 18, (uint32_t)image->width);
    common_put4(head + 22, (uint32_t)image->height);
    common_put2(head + 26, 1);
    common_put2(head + 28, 8u * (unsigned)channels);
    common_put4(head + 34, (uint32_t)size);
    if (!output->put(output->user, head, sizeof head))
        return "could not write the header";
    for (int y = image->height - 1; y >= 0; y--)
        if (!common_put_bgr((const char *)image->pixels + (size_t)y * image->stride, image->width, channels, output->put,
                            output->user) ||
            !output->put(output->user, zeros, padding))
            return "could not write a row";
    return NULL;
}

static const pov_image_format bmp = {
    .size = sizeof(pov_image_format), .depths = POV_IMAGE_8 | POV_IMAGE_ALPHA, .ending = "bmp", .write = write_bmp, .load = load_bmp,
};
static const pov_image_format *const formats[] = { &bmp, NULL };

POV_PLUGIN(bmp) = {
    .abi = POV_PLUGIN_ABI, .size = sizeof(pov_plugin), .name = "bmp", .version = "0.1.0", .images = formats,
};
