/* gif.c - GIF, reading: the first picture of a file; and POT, the heights that programs for fractals store in a GIF. */
#include "common/bytes.h"

#include <povtrace/image.h>
#include <povtrace/plugin.h>

#include <string.h>

enum { MOST_CODES = 4096, EXTENSION = 0x21, PICTURE = 0x2c, GRAPHICS = 0xf9 };

typedef struct palette { unsigned char colour[256][4]; unsigned count; } palette;

typedef struct picture {
    unsigned left, top, width, height;   /* within the screen */
    bool is_interlaced;
    palette colours;
    int clear;                           /* index of the transparent colour; -1: there is none */
    pov_raster about;
} picture;

static void read_palette(common_bytes *in, unsigned flags, palette *p)
{
    if (!(flags & 128))
        return;
    p->count = 2u << (flags & 7);
    for (unsigned i = 0; i < p->count; i++) {
        p->colour[i][0] = (unsigned char)common_byte(in);
        p->colour[i][1] = (unsigned char)common_byte(in);
        p->colour[i][2] = (unsigned char)common_byte(in);
        p->colour[i][3] = 255;
    }
}

/* ---- blocks ---- */

static void skip_blocks(common_bytes *in)
{
    unsigned length;

    while ((length = common_byte(in)) != 0)
        common_bytes_take(in, length);
}

static void read_extension(common_bytes *in, picture *p)
{
    const unsigned char *block;

    if (common_byte(in) == GRAPHICS && common_bytes_left(in) > 5 && in->at[0] == 4) {
        common_byte(in);
        block = common_bytes_take(in, 4);
        p->clear = block[0] & 1 ? block[3] : -1;
    }
    skip_blocks(in);
}

/* Go to the first picture's own description. */
static bool find_picture(common_bytes *in, picture *p)
{
    while (!in->is_cut) {
        const unsigned kind = common_byte(in);

        if (kind == PICTURE)
            return true;
        if (kind != EXTENSION)
            return false;
        read_extension(in, p);
    }
    return false;
}

static const char *read_header(common_bytes *in, picture *p)
{
    const unsigned char *magic = common_bytes_take(in, 6);
    unsigned flags;

    if (!magic || (memcmp(magic, "GIF87a", 6) != 0 && memcmp(magic, "GIF89a", 6) != 0))
        return "it does not begin like a GIF";
    p->clear = -1;
    common_byte4(in);
    flags = common_byte(in);
    common_byte2(in);
    read_palette(in, flags, &p->colours);
    if (!find_picture(in, p))
        return "it holds no picture";
    common_byte4(in);
    p->width = common_byte2(in);
    p->height = common_byte2(in);
    flags = common_byte(in);
    p->is_interlaced = (flags & 64) != 0;
    read_palette(in, flags, &p->colours);
    if (in->is_cut || p->width == 0 || p->height == 0 || p->colours.count == 0)
        return "its header is wrong";
    return NULL;
}

/* ---- codes ---- */

typedef struct bit_reader {
    common_bytes *in;
    unsigned left, held;                 /* bytes of the block; bits that were read and not used */
    uint32_t bits;
} bit_reader;

/* -1: the data end. */
static int next_code(bit_reader *b, unsigned width)
{
    int code;

    while (b->held < width) {
        if (b->left == 0 && (b->left = common_byte(b->in)) == 0)
            return -1;
        b->bits |= (uint32_t)common_byte(b->in) << b->held;
        b->held += 8;
        b->left--;
    }
    code = (int)(b->bits & ((1u << width) - 1));
    b->bits >>= width;
    b->held -= width;
    return code;
}

/* Each code stands for the bytes of an earlier one and a byte more. */
typedef struct dictionary {
    uint16_t before[MOST_CODES], length[MOST_CODES];
    unsigned char last[MOST_CODES], first[MOST_CODES];
    unsigned count, width, start;        /* start: the code that clears it */
} dictionary;

static void clear(dictionary *d)
{
    d->count = d->start + 2;
    d->width = 1;
    while (1u << d->width < d->count)
        d->width++;
}

static void begin(dictionary *d, unsigned bits)
{
    d->start = 1u << bits;
    for (unsigned i = 0; i < d->start; i++) {
        d->last[i] = d->first[i] = (unsigned char)i;
        d->length[i] = 1;
    }
    clear(d);
}

static void add(dictionary *d, unsigned before, unsigned char last)
{
    if (d->count == MOST_CODES)
        return;
    d->before[d->count] = (uint16_t)before;
    d->length[d->count] = (uint16_t)(d->length[before] + 1);
    d->first[d->count] = d->first[before];
    d->last[d->count++] = last;
    if (d->count == 1u << d->width && d->width < 12)
        d->width++;
}

static void put_string(const dictionary *d, unsigned code, unsigned char *to, size_t most)
{
    for (size_t i = d->length[code]; i-- > 0; code = d->before[code])
        if (i < most)
            to[i] = d->last[code];
}

/* A picture that ends early keeps its first colour below, as viewers show it. */
static const char *unpack(common_bytes *in, unsigned char *to, size_t count)
{
    const unsigned bits = common_byte(in);
    bit_reader b = { .in = in };
    dictionary d;
    int code, before = -1;

    if (bits < 1 || bits > 8)
        return "the size of its codes is wrong";
    begin(&d, bits);
    while (count > 0 && (code = next_code(&b, d.width)) >= 0 && code != (int)d.start + 1) {
        size_t n;

        if (code == (int)d.start) {
            clear(&d);
            before = -1;
            continue;
        }
        if ((unsigned)code > d.count || (before < 0 && code >= (int)d.start) || ((unsigned)code == d.count && d.count == MOST_CODES))
            return "its pixels are damaged";
        if (before >= 0)
            add(&d, (unsigned)before, (unsigned)code == d.count ? d.first[before] : d.first[code]);
        n = d.length[code] < count ? d.length[code] : count;
        put_string(&d, (unsigned)code, to, n);
        to += n;
        count -= n;
        before = code;
    }
    return count > 0 && in->is_cut ? "it is cut off" : NULL;
}

/* ---- the picture ---- */

/* The row of the file that holds row y of the picture, where every eighth row comes first. */
static unsigned stored_row(unsigned y, unsigned height)
{
    const unsigned eighths = (height + 7) / 8, odd_eighths = (height + 3) / 8, fourths = (height + 1) / 4;

    if (y % 8 == 0)
        return y / 8;
    if (y % 8 == 4)
        return eighths + y / 8;
    if (y % 4 == 2)
        return eighths + odd_eighths + y / 4;
    return eighths + odd_eighths + fourths + y / 2;
}

/* Rows change their places within the memory of the host: each cycle of them by itself. */
static void deinterlace(unsigned char *pixels, unsigned width, unsigned height)
{
    for (unsigned x = 0; x < width; x++)
        for (unsigned y = 0; y < height; y++) {
            unsigned from = stored_row(y, height);
            unsigned char held;

            while (from < y)
                from = stored_row(from, height);
            held = pixels[(size_t)from * width + x];
            pixels[(size_t)from * width + x] = pixels[(size_t)y * width + x];
            pixels[(size_t)y * width + x] = held;
        }
}

/* A row's left half holds the high bytes of its heights, the right half the low ones. */
static void pair_bytes(unsigned char *rows, unsigned width, unsigned height)
{
    unsigned char row[1 << 16];

    for (unsigned y = 0; y < height; y++, rows += width) {
        uint16_t *to = (uint16_t *)(void *)rows;

        memcpy(row, rows, width);
        for (unsigned x = 0; x < width / 2; x++)
            to[x] = (uint16_t)(row[x] << 8 | row[width / 2 + x]);
    }
}

static const char *begin_picture(common_bytes *in, picture *p)
{
    const char *wrong = read_header(in, p);

    /* A code, of three bits at least, stands for so many pixels at most. */
    if (!wrong && (size_t)p->width * p->height / MOST_CODES / 3 > common_bytes_left(in))
        return "it is cut off";
    return wrong;
}

static const char *put_picture(common_bytes *in, const picture *p, unsigned char *pixels)
{
    const char *wrong = pixels ? unpack(in, pixels, (size_t)p->width * p->height) : "there is no memory for it";

    if (!wrong && p->is_interlaced)
        deinterlace(pixels, p->width, p->height);
    return wrong;
}

static const char *load_pot(const void *bytes, size_t count, const pov_raster_target *target)
{
    common_bytes in = common_bytes_of(bytes, count);
    picture p = { .about = POV_INIT(p.about) };
    const char *wrong = begin_picture(&in, &p);
    unsigned char *pixels;

    if (wrong)
        return wrong;
    if (p.width % 2 != 0)
        return "its rows are no pairs of bytes";
    p.about.width = (int)p.width / 2;
    p.about.height = (int)p.height;
    p.about.bits = 16;
    p.about.channels = 1;
    p.about.stride = p.width;
    pixels = target->begin(target->user, &p.about);
    wrong = put_picture(&in, &p, pixels);
    if (!wrong)
        pair_bytes(pixels, p.width, p.height);
    return wrong;
}

static const char *load_gif(const void *bytes, size_t count, const pov_raster_target *target)
{
    common_bytes in = common_bytes_of(bytes, count);
    picture p = { .about = POV_INIT(p.about) };
    const char *wrong = begin_picture(&in, &p);

    if (wrong)
        return wrong;
    if (p.clear >= 0)
        p.colours.colour[p.clear][3] = 0;
    p.about.width = (int)p.width;
    p.about.height = (int)p.height;
    p.about.bits = 8;
    p.about.channels = 1;
    p.about.palette = p.colours.colour[0];
    p.about.colours = (int)p.colours.count;
    p.about.has_alpha = p.clear >= 0;
    p.about.stride = p.width;
    return put_picture(&in, &p, target->begin(target->user, &p.about));
}

static const pov_image_format gif = {
    .size = sizeof(pov_image_format), .depths = POV_IMAGE_8, .ending = "gif", .load = load_gif,
};
static const pov_image_format pot = {
    .size = sizeof(pov_image_format), .depths = POV_IMAGE_16, .ending = "pot", .load = load_pot,
};
static const pov_image_format *const formats[] = { &gif, &pot, NULL };

POV_PLUGIN(gif) = {
    .abi = POV_PLUGIN_ABI, .size = sizeof(pov_plugin), .name = "gif", .version = "0.1.0", .images = formats,
};
