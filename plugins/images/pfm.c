/* pfm.c - portable float maps: linear floats as they are, three to a pixel, the bottom row first. */
#include <povtrace/image.h>
#include <povtrace/plugin.h>

#include <stdio.h>
#include <string.h>

static bool is_little_endian(void)
{
    const uint16_t one = 1;
    unsigned char first;

    memcpy(&first, &one, 1);
    return first == 1;
}

/* The sign of the third number names the byte order of the floats; negative is little-endian. The machine's order is
 * written, so that a row is written without a copy. */
static const char *write_pfm(const pov_image *image, const pov_output *output)
{
    char header[64];
    int length = snprintf(header, sizeof header, "PF\n%d %d\n%s\n", image->width, image->height,
                          is_little_endian() ? "-1.0" : "1.0");
    size_t row_bytes = 3 * sizeof(float) * (size_t)image->width;

    if (!output->put(output->user, header, (size_t)length))
        return "could not write the header";
    for (int y = image->height - 1; y >= 0; y--) {
        if (!output->put(output->user, (const char *)image->pixels + (size_t)y * image->stride, row_bytes))
            return "could not write a row";
    }
    return NULL;
}

/* A positive whole number after white space; 0: none. `at` moves behind it. */
static int read_number(const char **at, const char *end)
{
    int value = 0;

    while (*at < end && (**at == ' ' || **at == '\n' || **at == '\r' || **at == '\t'))
        (*at)++;
    for (; *at < end && **at >= '0' && **at <= '9' && value < 100000000; (*at)++)
        value = 10 * value + (**at - '0');
    return value;
}

/* Only the sign of the scale matters: the byte order. One white space ends the line. */
static bool read_order(const char **at, const char *end, bool *little)
{
    while (*at < end && **at == '\n')
        (*at)++;
    *little = *at < end && **at == '-';
    while (*at < end && **at != '\n')
        (*at)++;
    return (*at)++ < end;
}

static void read_row(const unsigned char *from, size_t count, bool swap, bool grey, float *to)
{
    for (size_t i = 0; i < count; i++) {
        const unsigned char *f = from + 4 * (grey ? i / 3 : i);
        unsigned char turned[4] = { f[3], f[2], f[1], f[0] };

        memcpy(&to[i], swap ? turned : f, 4);
    }
}

typedef struct content { const unsigned char *at; int width, height; bool little, grey; size_t row; } content;

static const char *read_header(const void *bytes, size_t count, content *c)
{
    const char *at = (const char *)bytes + 2, *end = (const char *)bytes + count;

    if (count < 8 || (memcmp(bytes, "PF", 2) != 0 && memcmp(bytes, "Pf", 2) != 0))
        return "it does not begin like a PFM";
    c->grey = ((const char *)bytes)[1] == 'f';
    c->width = read_number(&at, end);
    c->height = read_number(&at, end);
    if (c->width < 1 || c->height < 1 || !read_order(&at, end, &c->little))
        return "its header is wrong";
    c->row = (c->grey ? 4 : 12) * (size_t)c->width;
    c->at = (const unsigned char *)at;
    return (size_t)(end - at) / c->row < (size_t)c->height ? "it is cut off" : NULL;
}

static const char *read_rows(const content *c, char *pixels)
{
    const unsigned char *at = c->at;

    if (!pixels)
        return "there is no memory for it";
    for (int y = c->height - 1; y >= 0; y--, at += c->row)
        read_row(at, 3 * (size_t)c->width, c->little != is_little_endian(), c->grey,
                 (float *)(void *)(pixels + (size_t)y * 12 * (size_t)c->width));
    return NULL;
}

static const char *read_pfm(const void *bytes, size_t count, const pov_image_target *target)
{
    pov_image about = POV_INIT(about);
    content c;
    const char *wrong = read_header(bytes, count, &c);

    if (wrong)
        return wrong;
    about.width = c.width;
    about.height = c.height;
    about.bits = 32;
    about.stride = 12 * (size_t)c.width;
    return read_rows(&c, target->begin(target->user, &about));
}

static const char *load_pfm(const void *bytes, size_t count, const pov_raster_target *target)
{
    pov_raster about = POV_INIT(about);
    content c;
    const char *wrong = read_header(bytes, count, &c);

    if (wrong)
        return wrong;
    about.width = c.width;
    about.height = c.height;
    about.bits = 32;
    about.channels = 3;
    about.encoding = POV_ENCODING_LINEAR;
    about.stride = 12 * (size_t)c.width;
    return read_rows(&c, target->begin(target->user, &about));
}

static const pov_image_format pfm = {
    .size = sizeof(pov_image_format),
    .depths = POV_IMAGE_FLOAT,
    .ending = "pfm",
    .write = write_pfm,
    .read = read_pfm,
    .load = load_pfm,
};
static const pov_image_format *const formats[] = { &pfm, NULL };

POV_PLUGIN(pfm) = {
    .abi = POV_PLUGIN_ABI, .size = sizeof(pov_plugin), .name = "pfm", .version = "0.1.0", .images = formats,
};
