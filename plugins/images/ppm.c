/* ppm.c - portable pixel maps, 8 or 16 bits a channel, the high byte first. Written and read as pictures: P6; loaded for
 * textures: grey ones (P2, P5) and those of plain text (P2, P3) too. */
#include <povtrace/image.h>
#include <povtrace/plugin.h>

#include <stdio.h>
#include <string.h>

/* Write 16-bit samples byte by byte, whatever the machine's order. */
static bool put_samples16(const pov_output *output, const uint16_t *samples, size_t count)
{
    unsigned char bytes[4096];
    size_t used = 0;

    for (size_t i = 0; i < count; i++) {
        bytes[used++] = (unsigned char)(samples[i] >> 8);
        bytes[used++] = (unsigned char)(samples[i] & 0xff);
        if (used == sizeof bytes || i + 1 == count) {
            if (!output->put(output->user, bytes, used))
                return false;
            used = 0;
        }
    }
    return true;
}

static const char *write_ppm(const pov_image *image, const pov_output *output)
{
    char header[64];
    size_t samples = 3 * (size_t)image->width;
    int length = snprintf(header, sizeof header, "P6\n%d %d\n%d\n", image->width, image->height,
                          image->bits == 16 ? 65535 : 255);

    if (!output->put(output->user, header, (size_t)length))
        return "could not write the header";
    for (int y = 0; y < image->height; y++) {
        const void *row = (const char *)image->pixels + (size_t)y * image->stride;
        bool done = image->bits == 16 ? put_samples16(output, row, samples)
                                      : output->put(output->user, row, samples);

        if (!done)
            return "could not write a row";
    }
    return NULL;
}

/* ---- reading: the header as Netpbm's ppm(5) has it ---- */

typedef struct source { const unsigned char *at, *end; } source;

static bool is_space(int c)
{
    return c == ' ' || (c >= '\t' && c <= '\r');
}

/* Skip white space, and comments to the end of their line. */
static void skip(source *from)
{
    while (from->at < from->end && (is_space(*from->at) || *from->at == '#')) {
        if (*from->at == '#')
            while (from->at < from->end && *from->at != '\n')
                from->at++;
        else
            from->at++;
    }
}

/* A whole number; 0: none, or too large for any picture. */
static int read_number(source *from)
{
    const unsigned most = 1u << 28;
    unsigned value = 0;

    skip(from);
    for (; from->at < from->end && *from->at >= '0' && *from->at <= '9' && value <= most; from->at++)
        value = 10 * value + (unsigned)(*from->at - '0');
    return value <= most ? (int)value : 0;
}

/* Scale the file's largest value to the largest of 8 or 16 bits. False: a sample exceeds it. */
static bool read_row(const unsigned char *from, size_t samples, unsigned most, int bits, void *to)
{
    const unsigned full = bits == 8 ? 255u : 65535u;

    for (size_t i = 0; i < samples; i++) {
        unsigned value = bits == 8 ? from[i] : (unsigned)from[2 * i] << 8 | from[2 * i + 1];

        if (value > most)
            return false;
        value = (value * full + most / 2) / most;
        if (bits == 8)
            ((uint8_t *)to)[i] = (uint8_t)value;
        else
            ((uint16_t *)to)[i] = (uint16_t)value;
    }
    return true;
}

static const char *read_header(source *from, pov_image *about, int *most)
{
    if (from->end - from->at >= 2 && memcmp(from->at, "P3", 2) == 0)
        return "it is a PPM of plain text (P3), of which only the binary ones (P6) are read";
    if (from->end - from->at < 2 || memcmp(from->at, "P6", 2) != 0)
        return "it does not begin like a PPM (P6)";
    from->at += 2;
    about->width = read_number(from);
    about->height = read_number(from);
    *most = read_number(from);
    /* One white space ends the header: the data may begin with bytes that look like white space. */
    if (from->at == from->end)
        return "it is cut off in its header";
    if (about->width < 1 || about->height < 1 || *most < 1 || *most > 65535 || !is_space(*from->at++))
        return "its header is wrong";
    return NULL;
}

/* The format does not state its encoding: values are taken as linear, as write_ppm() stores them. */
static const char *read_ppm(const void *bytes, size_t count, const pov_image_target *target)
{
    source from = { bytes, (const unsigned char *)bytes + count };
    pov_image about = POV_INIT(about);
    const char *wrong;
    unsigned char *pixels;
    size_t samples;
    int most;

    wrong = read_header(&from, &about, &most);
    if (wrong)
        return wrong;
    about.bits = most < 256 ? 8 : 16;
    samples = 3 * (size_t)about.width;
    about.stride = samples * (size_t)(about.bits / 8);
    if ((size_t)(from.end - from.at) / about.stride < (size_t)about.height)
        return "it is cut off: its header promises more pixels than there are";
    pixels = target->begin(target->user, &about);
    if (!pixels)
        return "there is no memory for it";
    for (int y = 0; y < about.height; y++, from.at += about.stride)
        if (!read_row(from.at, samples, (unsigned)most, about.bits, pixels + (size_t)y * about.stride))
            return "a value is larger than its header's largest";
    return NULL;
}

/* ---- for textures ---- */

/* As floats where the largest value is not that of whole bytes. */
static void put_sample(const pov_raster *about, unsigned value, unsigned most, unsigned char *to)
{
    const uint8_t narrow = (uint8_t)value;
    const uint16_t wide = (uint16_t)value;
    const float real = (float)((double)value / most);

    memcpy(to, about->bits == 8 ? (const void *)&narrow : about->bits == 16 ? (const void *)&wide : &real,
           (size_t)about->bits / 8);
}

/* -1: the file ends. */
static int next_sample(source *from, bool is_text, unsigned most)
{
    int high;

    if (is_text) {
        skip(from);
        return from->at < from->end ? read_number(from) : -1;
    }
    if (from->end - from->at < (most > 255 ? 2 : 1))
        return -1;
    high = most > 255 ? *from->at++ : 0;
    return high << 8 | *from->at++;
}

static const char *load_samples(source *from, const pov_raster *about, bool is_text, unsigned most, unsigned char *pixels)
{
    const size_t samples = (size_t)about->channels * (size_t)about->width * (size_t)about->height;

    if (!pixels)
        return "there is no memory for it";
    for (size_t i = 0; i < samples; i++, pixels += about->bits / 8) {
        const int value = next_sample(from, is_text, most);

        if (value < 0)
            return "it is cut off";
        if ((unsigned)value > most)
            return "a value is larger than its header's largest";
        put_sample(about, (unsigned)value, most, pixels);
    }
    return NULL;
}

static const char *load_header(source *from, pov_raster *about, unsigned *most)
{
    const char kind = from->end - from->at >= 2 && from->at[0] == 'P' ? (char)from->at[1] : '\0';

    if (kind != '2' && kind != '3' && kind != '5' && kind != '6')
        return "it does not begin like a PPM or PGM (P2, P3, P5, P6)";
    from->at += 2;
    about->width = read_number(from);
    about->height = read_number(from);
    *most = (unsigned)read_number(from);
    if (about->width < 1 || about->height < 1 || *most < 1 || *most > 65535 || from->at == from->end ||
        !is_space(*from->at++))
        return "its header is wrong";
    about->channels = kind == '2' || kind == '5' ? 1 : 3;
    about->bits = *most == 255 ? 8 : *most == 65535 ? 16 : 32;
    about->encoding = POV_ENCODING_STORED;
    about->stride = (size_t)about->width * (size_t)(about->channels * about->bits / 8);
    return NULL;
}

static const char *load_ppm(const void *bytes, size_t count, const pov_raster_target *target)
{
    source from = { bytes, (const unsigned char *)bytes + count };
    pov_raster about = POV_INIT(about);
    unsigned most;
    const char *wrong = load_header(&from, &about, &most);

    if (wrong)
        return wrong;
    /* Each sample takes a byte at least. */
    if ((size_t)(from.end - from.at) / (size_t)about.width / (size_t)about.channels < (size_t)about.height)
        return "it is cut off: its header promises more pixels than there are";
    return load_samples(&from, &about, ((const char *)bytes)[1] < '4', most, target->begin(target->user, &about));
}

static const pov_image_format ppm = {
    .size = sizeof(pov_image_format),
    .depths = POV_IMAGE_8 | POV_IMAGE_16,
    .ending = "ppm",
    .write = write_ppm,
    .read = read_ppm,
    .load = load_ppm,
};
static const pov_image_format *const formats[] = { &ppm, NULL };

POV_PLUGIN(ppm) = {
    .abi = POV_PLUGIN_ABI, .size = sizeof(pov_plugin), .name = "ppm", .version = "0.1.0", .images = formats,
};
