/* exr.c - OpenEXR: written as floats without compression, read by OpenEXRCore; scan lines and tiles of one part. */
#include "common/bytes.h"

#include <povtrace/image.h>
#include <povtrace/plugin.h>

#include <stdio.h>
#include <string.h>

#include <openexr.h>

/* ---- writing: a header of attributes, the places of the rows, the rows ---- */

enum { CHANNELS_MAX = 63, NAME_MAX_BYTES = 32, HEADER = 512 + CHANNELS_MAX * (NAME_MAX_BYTES + 16) };

/* Where a channel's values are, in bytes. */
typedef struct plane { const char *name; const unsigned char *first; size_t step, stride; } plane;

/* In the order of their names, which files keep. */
typedef struct planes { int count; plane of[CHANNELS_MAX]; } planes;

static void add_plane(planes *c, plane add)
{
    int at = c->count++;

    for (; at > 0 && strcmp(c->of[at - 1].name, add.name) > 0; at--)
        c->of[at] = c->of[at - 1];
    c->of[at] = add;
}

static bool list_planes(const pov_image *image, planes *c)
{
    static const char *const colours[] = { "R", "G", "B" };

    c->count = 0;
    for (int i = 0; i < 3; i++)
        add_plane(c, (plane){ colours[i], (const unsigned char *)image->pixels + sizeof(float) * (size_t)i, 3 * sizeof(float),
                                  image->stride });
    for (int i = 0; i < image->layer_count && c->count < CHANNELS_MAX; i++) {
        const pov_layer *l = &image->layers[i];
        const size_t step = (size_t)l->step * sizeof(float);

        if (strlen(l->name) >= NAME_MAX_BYTES)
            return false;
        add_plane(c, (plane){ l->name, (const unsigned char *)l->values, step, step * (size_t)image->width });
    }
    return c->count == 3 + image->layer_count;
}

typedef struct header { unsigned char bytes[HEADER]; size_t count; } header;

static void put_bytes(header *h, const void *bytes, size_t count)
{
    memcpy(h->bytes + h->count, bytes, count);
    h->count += count;
}

static void put_number(unsigned char *to, uint64_t value, int bytes)
{
    for (int i = 0; i < bytes; i++)
        to[i] = (unsigned char)(value >> (8 * i));
}

static void put_int(header *h, uint32_t value)
{
    put_number(h->bytes + h->count, value, 4);
    h->count += 4;
}

static void put_float(header *h, float value)
{
    uint32_t bits;

    memcpy(&bits, &value, sizeof bits);
    put_int(h, bits);
}

static void put_attribute(header *h, const char *name, const char *type, uint32_t bytes)
{
    put_bytes(h, name, strlen(name) + 1);
    put_bytes(h, type, strlen(type) + 1);
    put_int(h, bytes);
}

static void put_channel(header *h, const char *name)
{
    const uint32_t is_float = 2;

    put_bytes(h, name, strlen(name) + 1);
    put_int(h, is_float);
    put_int(h, 0);
    put_int(h, 1);
    put_int(h, 1);
}

static void put_window(header *h, const char *name, const pov_image *image)
{
    put_attribute(h, name, "box2i", 16);
    put_int(h, 0);
    put_int(h, 0);
    put_int(h, (uint32_t)image->width - 1);
    put_int(h, (uint32_t)image->height - 1);
}

static void put_channels(header *h, const planes *c)
{
    static const unsigned char end = 0;
    uint32_t bytes = 1;

    for (int i = 0; i < c->count; i++)
        bytes += (uint32_t)strlen(c->of[i].name) + 17;
    put_attribute(h, "channels", "chlist", bytes);
    for (int i = 0; i < c->count; i++)
        put_channel(h, c->of[i].name);
    put_bytes(h, &end, 1);
}

static void fill_header(header *h, const pov_image *image, const planes *c)
{
    static const unsigned char magic[] = { 0x76, 0x2f, 0x31, 0x01, 2, 0, 0, 0 }, end = 0;

    h->count = 0;
    put_bytes(h, magic, sizeof magic);
    put_channels(h, c);
    put_attribute(h, "compression", "compression", 1);
    put_bytes(h, &end, 1);
    put_window(h, "dataWindow", image);
    put_window(h, "displayWindow", image);
    put_attribute(h, "lineOrder", "lineOrder", 1);
    put_bytes(h, &end, 1);
    put_attribute(h, "pixelAspectRatio", "float", 4);
    put_float(h, 1.0f);
    put_attribute(h, "screenWindowCenter", "v2f", 8);
    put_float(h, 0.0f);
    put_float(h, 0.0f);
    put_attribute(h, "screenWindowWidth", "float", 4);
    put_float(h, 1.0f);
    put_bytes(h, &end, 1);
}

/* Each channel by itself. */
static bool put_row(const pov_image *image, const planes *of, int y, const pov_output *output)
{
    unsigned char bytes[4096];
    size_t used = 8;

    put_number(bytes, (uint64_t)y, 4);
    put_number(bytes + 4, (uint64_t)image->width * (uint64_t)of->count * sizeof(float), 4);
    for (int c = 0; c < of->count; c++) {
        const unsigned char *at = of->of[c].first + (size_t)y * of->of[c].stride;

        for (int x = 0; x < image->width; x++, at += of->of[c].step) {
            uint32_t bits;

            memcpy(&bits, at, sizeof bits);
            put_number(bytes + used, bits, 4);
            used += 4;
            if (used == sizeof bytes && !output->put(output->user, bytes, used))
                return false;
            used %= sizeof bytes;
        }
    }
    return used == 0 || output->put(output->user, bytes, used);
}

static const char *write_exr(const pov_image *image, const pov_output *output)
{
    unsigned char place[8];
    planes c;
    uint64_t row;
    header h;

    if (!list_planes(image, &c))
        return "it has more channels, or longer names, than are written";
    row = 8 + (uint64_t)image->width * (uint64_t)c.count * sizeof(float);
    if (image->width < 1 || image->height < 1 || row > INT32_MAX)
        return "it has no size that an OpenEXR file can have";
    fill_header(&h, image, &c);
    if (!output->put(output->user, h.bytes, h.count))
        return "could not write the header";
    for (int y = 0; y < image->height; y++) {
        put_number(place, h.count + 8 * (uint64_t)image->height + (uint64_t)y * row, 8);
        if (!output->put(output->user, place, sizeof place))
            return "could not write the header";
    }
    for (int y = 0; y < image->height; y++)
        if (!put_row(image, &c, y, output))
            return "could not write a row";
    return NULL;
}

/* ---- reading ---- */

typedef struct source { const unsigned char *bytes; size_t count; } source;

static int64_t get_bytes(exr_const_context_t context, void *user, void *to, uint64_t count, uint64_t offset,
                         exr_stream_error_func_ptr_t on_error)
{
    const source *from = user;
    const size_t left = offset < from->count ? from->count - (size_t)offset : 0;
    const size_t n = count < left ? (size_t)count : left;

    (void)context;
    (void)on_error;
    memcpy(to, from->bytes + (left > 0 ? offset : 0), n);
    return (int64_t)n;
}

static int64_t get_size(exr_const_context_t context, void *user)
{
    (void)context;
    return (int64_t)((const source *)user)->count;
}

static void say_nothing(exr_const_context_t context, exr_result_t code, const char *text)
{
    (void)context;
    (void)code;
    (void)text;
}

typedef struct picture {
    exr_context_t file;
    pov_raster about;
    exr_attr_box2i_t window;
    exr_storage_t storage;
    unsigned char *pixels;
} picture;

/* The place of a channel in a pixel; -1: it is not wanted. A file of brightness has Y alone. */
static int place_of(const char *name)
{
    static const char *const names[] = { "R", "G", "B", "A" };

    for (int i = 0; i < 4; i++)
        if (strcmp(name, names[i]) == 0)
            return i;
    return strcmp(name, "Y") == 0 ? 0 : -1;
}

static const char *find_channels(picture *p)
{
    const exr_attr_chlist_t *list;
    int has[4] = { 0, 0, 0, 0 };

    if (exr_get_channels(p->file, 0, &list) != EXR_ERR_SUCCESS)
        return "it has no channels";
    for (int i = 0; i < list->num_channels; i++) {
        const int place = place_of(list->entries[i].name.str);

        if (place >= 0)
            has[place] = 1;
        if (place >= 0 && (list->entries[i].x_sampling != 1 || list->entries[i].y_sampling != 1))
            return "its channels are of different sizes, which is not read";
    }
    if (!has[0])
        return "it has neither the channel R nor Y";
    p->about.channels = has[1] && has[2] ? (has[3] ? 4 : 3) : 1;
    return NULL;
}

static const char *get_header(picture *p)
{
    const char *wrong;
    int64_t width, height;

    if (exr_get_data_window(p->file, 0, &p->window) != EXR_ERR_SUCCESS || exr_get_storage(p->file, 0, &p->storage) != EXR_ERR_SUCCESS)
        return "its header is wrong";
    if (p->storage != EXR_STORAGE_SCANLINE && p->storage != EXR_STORAGE_TILED)
        return "it is a deep picture, which is not read";
    width = (int64_t)p->window.max.x - p->window.min.x + 1;
    height = (int64_t)p->window.max.y - p->window.min.y + 1;
    if (width < 1 || height < 1 || width > 1 << 26 || height > 1 << 26)
        return "its header is wrong";
    wrong = find_channels(p);
    p->about.width = (int)width;
    p->about.height = (int)height;
    p->about.bits = 32;
    p->about.encoding = POV_ENCODING_LINEAR;
    p->about.stride = (size_t)width * ((size_t)p->about.channels + 1) * sizeof(float);
    return wrong;
}

/* Where the library puts the channels of a chunk whose first pixel is at x, y. What is not wanted goes behind the row, for
 * version 3.1 cannot leave out channels. */
static void aim(const picture *p, exr_decode_pipeline_t *pipeline, int64_t x, int64_t y)
{
    const size_t pixel = (size_t)p->about.channels * sizeof(float);

    for (int i = 0; i < pipeline->channel_count; i++) {
        exr_coding_channel_info_t *channel = &pipeline->channels[i];
        const int place = place_of(channel->channel_name);
        const bool is_wanted = place >= 0 && place < p->about.channels;
        const size_t first = is_wanted ? (size_t)x * pixel + (size_t)place * sizeof(float)
                                       : (size_t)p->about.width * pixel + (size_t)x * sizeof(float);

        channel->decode_to_ptr = p->pixels + (size_t)y * p->about.stride + first;
        channel->user_pixel_stride = is_wanted ? (int32_t)pixel : (int32_t)sizeof(float);
        channel->user_line_stride = (int32_t)p->about.stride;
        channel->user_bytes_per_element = sizeof(float);
        channel->user_data_type = EXR_PIXEL_FLOAT;
    }
}

static bool decode(const picture *p, const exr_chunk_info_t *chunk, int64_t x, int64_t y)
{
    exr_decode_pipeline_t pipeline = EXR_DECODE_PIPELINE_INITIALIZER;
    bool done = exr_decoding_initialize(p->file, 0, chunk, &pipeline) == EXR_ERR_SUCCESS;

    if (done) {
        aim(p, &pipeline, x, y);
        /* It may choose nothing for what it does not know. */
        done = exr_decoding_choose_default_routines(p->file, 0, &pipeline) == EXR_ERR_SUCCESS && pipeline.read_fn &&
               (pipeline.decompress_fn || chunk->compression == EXR_COMPRESSION_NONE) && pipeline.unpack_and_convert_fn &&
               exr_decoding_run(p->file, 0, &pipeline) == EXR_ERR_SUCCESS;
    }
    exr_decoding_destroy(p->file, &pipeline);
    return done;
}

static bool get_lines(const picture *p)
{
    exr_chunk_info_t chunk;
    int32_t lines = 1;

    if (exr_get_scanlines_per_chunk(p->file, 0, &lines) != EXR_ERR_SUCCESS || lines < 1)
        return false;
    for (int64_t y = p->window.min.y; y <= p->window.max.y; y += lines)
        if (exr_read_scanline_chunk_info(p->file, 0, (int)y, &chunk) != EXR_ERR_SUCCESS ||
            !decode(p, &chunk, 0, y - p->window.min.y))
            return false;
    return true;
}

static bool get_tiles(const picture *p)
{
    exr_tile_level_mode_t level;
    exr_tile_round_mode_t round;
    exr_chunk_info_t chunk;
    uint32_t width, height;

    if (exr_get_tile_descriptor(p->file, 0, &width, &height, &level, &round) != EXR_ERR_SUCCESS || width == 0 || height == 0)
        return false;
    for (int64_t y = 0; y < p->about.height; y += height)
        for (int64_t x = 0; x < p->about.width; x += width)
            if (exr_read_tile_chunk_info(p->file, 0, (int)(x / width), (int)(y / height), 0, 0, &chunk) != EXR_ERR_SUCCESS ||
                !decode(p, &chunk, x, y))
                return false;
    return true;
}

static const char *get_picture(picture *p, const pov_raster_target *target)
{
    const char *wrong = get_header(p);

    if (wrong)
        return wrong;
    p->pixels = target->begin(target->user, &p->about);
    if (!p->pixels)
        return "there is no memory for it";
    return (p->storage == EXR_STORAGE_TILED ? get_tiles(p) : get_lines(p)) ? NULL : "it is cut off or damaged";
}

static const char *load_exr(const void *bytes, size_t count, const pov_raster_target *target)
{
    exr_context_initializer_t how = EXR_DEFAULT_CONTEXT_INITIALIZER;
    source from = { bytes, count };
    picture p = { .about = POV_INIT(p.about) };
    const char *wrong;

    if (count < 8 || memcmp(bytes, "\x76\x2f\x31\x01", 4) != 0)
        return "it does not begin like an OpenEXR file";
    how.user_data = &from;
    how.read_fn = get_bytes;
    how.size_fn = get_size;
    how.error_handler_fn = say_nothing;
    if (exr_start_read(&p.file, "exr", &how) != EXR_ERR_SUCCESS)
        return "its header is wrong";
    wrong = get_picture(&p, target);
    exr_finish(&p.file);
    return wrong;
}

static const pov_image_format exr = {
    .size = sizeof(pov_image_format), .depths = POV_IMAGE_FLOAT | POV_IMAGE_LAYERS, .ending = "exr", .write = write_exr, .load = load_exr,
};
static const pov_image_format *const formats[] = { &exr, NULL };

POV_PLUGIN(exr) = {
    .abi = POV_PLUGIN_ABI, .size = sizeof(pov_plugin), .name = "exr", .version = "0.1.0", .images = formats,
};
