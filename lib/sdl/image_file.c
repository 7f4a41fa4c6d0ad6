#include "sdl/image_file.h"

#include "base/file.h"
#include "base/hash.h"
#include "sdl/image_function.h"
#include "sdl/include.h"
#include "sdl/limit.h"
#include "sdl/report.h"
#include "sdl/text_file.h"
#include "sdl/value.h"

#include <ctype.h>
#include <string.h>

/* Of a file, in the scene's memory. */
typedef struct image_file {
    const char *path, *format;
    uint32_t written;            /* text_file_kept() */
    image image;
    struct image_file *next;
} image_file;

static const struct { keyword_id keyword; const char *ending, *other; } formats[] = {
    { KEYWORD_PNG, "png", ".PNG" }, { KEYWORD_JPEG, "jpeg", ".jpg" }, { KEYWORD_GIF, "gif", ".GIF" },
    { KEYWORD_TGA, "tga", ".TGA" }, { KEYWORD_PPM, "ppm", ".PPM" },   { KEYWORD_PGM, "pgm", ".PGM" },
    { KEYWORD_BMP, "bmp", ".BMP" }, { KEYWORD_TIFF, "tiff", ".tif" }, { KEYWORD_HDR, "hdr", ".HDR" },
    { KEYWORD_EXR, "exr", ".EXR" }, { KEYWORD_IFF, "iff", ".IFF" },   { KEYWORD_POT, "pot", ".POT" },
    { KEYWORD_SYS, "sys", ".SYS" }, { KEYWORD_DF3, "df3", ".DF3" },
};
enum { FORMATS = sizeof formats / sizeof formats[0], ENDING_MAX = 16 };

static const char *format_of(keyword_id keyword)
{
    for (int i = 0; i < FORMATS; i++)
        if (formats[i].keyword == keyword)
            return formats[i].ending;
    return NULL;
}

/* ---- the bytes ---- */

static bool find(pov_reader *in, const string *name, const char *format, char path[INCLUDE_PATH_MAX])
{
    char own[ENDING_MAX + 2] = ".";
    const char *endings[] = { "", own, NULL, NULL };

    if (text_file_kept(in, name) > 0 && name->length < INCLUDE_PATH_MAX) {
        memcpy(path, name->text, name->length + 1);
        return true;
    }
    strncat(own, format, ENDING_MAX);
    for (int i = 0; i < FORMATS; i++)
        if (strcmp(formats[i].ending, format) == 0)
            endings[2] = formats[i].other;
    if (include_find_with(in, name, endings, path))
        return true;
    include_not_found(in, name, endings);
    return false;
}

/* What the scene wrote itself comes first. */
static char *read_bytes(pov_reader *in, const string *name, const char *path, size_t *count)
{
    pov_error err;
    char *bytes = text_file_copy(in, name, count);

    if (bytes || in->failed)
        return bytes;
    if (limit_read_file(in, path, &bytes, count, &err) < 0) {
        report_fail(in, &in->value, err.status, "%.200s: %.200s", path, err.message);
        return NULL;
    }
    in->sources.hash = hash_bytes(in->sources.hash, bytes, *count);
    return bytes;
}

/* ---- images ---- */

/* The largest image, and how many times as large as its file one can be. */
static const size_t most_bytes = (size_t)1 << 31, most_growth = 16384;

typedef struct decoding {
    pov_reader *in;
    image *out;
    size_t count;                /* of the file's bytes */
    bool is_cut;
    size_t wanted;               /* bytes of pixels that the limit forbids, or 0 */
} decoding;

static bool is_possible(const pov_raster *about, size_t file_bytes)
{
    size_t row, all;

    if (about->width < 1 || about->height < 1 || about->channels < 1 || about->channels > 4 || about->colours < 0 ||
        about->colours > 256 || (about->bits != 8 && about->bits != 16 && about->bits != 32))
        return false;
    row = (size_t)about->width * (size_t)(about->channels * about->bits / 8);
    if (about->stride < row || about->stride > most_bytes || (size_t)about->height > most_bytes / about->stride)
        return false;
    all = about->stride * (size_t)about->height;
    return all <= most_bytes && all / most_growth <= file_bytes + 1;
}

static void describe(const pov_raster *about, bool is_cut, image *out)
{
    out->width = (uint32_t)about->width;
    out->height = (uint32_t)about->height;
    out->channels = (uint32_t)about->channels;
    out->bits = (uint32_t)about->bits;
    out->encoding = about->encoding;
    out->power = about->power;
    out->colours = (uint32_t)about->colours;
    out->has_alpha = out->colours > 0 ? about->has_alpha : about->channels % 2 == 0;
    out->stride = about->stride;
    out->is_cut = is_cut && out->channels == 1 && out->bits == 8 && out->colours == 0;
    for (int i = 0; i < 4; i++)
        for (uint32_t k = 0; k < 256; k++)
            out->palette[k][i] = k < out->colours ? about->palette[4 * k + (uint32_t)i] : i == 3 ? 255 : 0;
}

static void *begin(void *user, const pov_raster *about)
{
    decoding *d = user;
    unsigned char *samples;

    if (d->out->samples || !is_possible(about, d->count))
        return NULL;
    if (!limit_images(d->in, about->stride * (size_t)about->height)) {
        d->wanted = about->stride * (size_t)about->height;
        return NULL;
    }
    describe(about, d->is_cut, d->out);
    samples = state_alloc(d->in, about->stride * (size_t)about->height, 16);
    d->out->samples = samples;
    return samples;
}

static const pov_image_format *find_format(pov_reader *in, const char *ending)
{
    const pov_image_format *format;
    pov_error err;

    if (registry_image(in->plugins, ending, &format, &err) < 0) {
        report_pass_on(in, &in->value, &err);
        return NULL;
    }
    if (format && POV_HAS(format, pov_image_format, load) && format->load)
        return format;
    report_fail(in, &in->value, POV_E_PLUGIN, "no plugin reads images of the format \"%s\"; searched images/ in %.300s", ending,
                registry_path(in->plugins));
    return NULL;
}

static void decode(pov_reader *in, const string *name, const char *path, const pov_image_format *format, image *out)
{
    decoding d = { in, out, 0, strcmp(format->ending, "png") == 0, 0 };
    pov_raster_target target = { &d, begin };
    char *bytes = read_bytes(in, name, path, &d.count);
    const char *wrong;

    if (!bytes)
        return;
    wrong = format->load(bytes, d.count, &target);
    if (d.wanted > 0)
        report_fail(in, &in->value, POV_E_MEMORY, "%.200s: this image takes %zu bytes, of %zu that images may still take", path,
                    d.wanted, in->limits.images - in->image_bytes);
    else if (wrong || !out->samples)
        report_fail(in, &in->value, POV_E_IO, "%.200s: cannot read this image: %s", path, wrong ? wrong : "it holds no picture");
    env_free(in->model->env, bytes);
}

static const char *keep_text(pov_reader *in, const char *text)
{
    const size_t length = strlen(text) + 1;
    char *copy = state_alloc(in, length, 1);

    return copy ? memcpy(copy, text, length) : NULL;
}

/* The name's ending in lower case; empty: it has none. */
static void ending_of(const string *name, char out[ENDING_MAX])
{
    const char *slash = strrchr(name->text, '/'), *dot = strrchr(slash ? slash : name->text, '.');
    size_t i = 0;

    for (; dot && dot[i + 1] && i + 1 < ENDING_MAX; i++)
        out[i] = (char)tolower((unsigned char)dot[i + 1]);
    out[i] = '\0';
}

static image_file *add(pov_reader *in, const string *name, const char *path, const char *ending)
{
    image_file *file = state_alloc(in, sizeof *file, 16);
    const pov_image_format *format;

    if (!file)
        return NULL;
    file->path = keep_text(in, path);
    file->format = keep_text(in, ending);
    format = in->failed ? NULL : find_format(in, ending);
    if (format)
        decode(in, name, path, format, &file->image);
    if (in->failed)
        return NULL;
    file->written = text_file_kept(in, name);
    file->next = in->images;
    in->images = file;
    return file;
}

const image *image_file_read(pov_reader *in, const string *name, const char *format)
{
    char path[INCLUDE_PATH_MAX], ending[ENDING_MAX];
    image_file *file;
    uint32_t written;

    if (in->failed)
        return NULL;
    ending_of(name, ending);
    if (!format && ending[0] == '\0')
        format = "png";          /* as POV-Ray has it on Unix */
    if (in->failed || !find(in, name, format ? format : ending, path))
        return NULL;
    written = text_file_kept(in, name);
    for (file = in->images; file; file = file->next)
        if (file->written == written && strcmp(file->path, path) == 0 && strcmp(file->format, format ? format : ending) == 0)
            return &file->image;
    file = add(in, name, path, format ? format : ending);
    return file ? &file->image : NULL;
}

/* ---- the text ---- */

static const char *parse_format(pov_reader *in)
{
    const keyword_id keyword = state_keyword(in);
    const char *format = in->token.kind == TOKEN_WORD ? format_of(keyword) : NULL;

    if (!format)
        return NULL;
    state_advance(in);
    if (keyword == KEYWORD_SYS)
        report_fail(in, &in->last, POV_E_UNSUPPORTED, "this system has no image format of its own: write the format's name");
    return format;
}

static void parse_gamma(pov_reader *in, image_gamma *out)
{
    memset(out, 0, sizeof *out);
    if (!state_accept_keyword(in, KEYWORD_GAMMA))
        return;
    out->is_given = true;
    out->is_srgb = state_accept_keyword(in, KEYWORD_SRGB);
    out->number = out->is_srgb ? 1.0 : value_number(in);
    if (!in->failed && !(out->number > 0.0))
        report_fail(in, &in->value, POV_E_SYNTAX, "\"gamma\" must be above 0");
}

/* Before version 3 the plane of the image came first. */
const image *image_file_parse(pov_reader *in, image_gamma *given, bool colours)
{
    const image *found = NULL;
    const char *format;
    const string *name;

    if (in->token.kind == '<') {
        value_vector(in);
        state_accept(in, ',');
    }
    memset(given, 0, sizeof *given);
    if (state_accept_keyword(in, KEYWORD_FUNCTION))
        return image_function_parse(in, colours);
    format = parse_format(in);
    name = value_text(in);
    if (name)
        found = image_file_read(in, name, format);
    parse_gamma(in, given);
    return in->failed ? NULL : found;
}

/* ---- volumes ---- */

static uint32_t size_at(const unsigned char *bytes) { return (uint32_t)(bytes[0] << 8 | bytes[1]); }

static bool take_volume(pov_reader *in, const char *path, const unsigned char *bytes, size_t count, density_file *out)
{
    uint64_t voxels = 1;
    unsigned char *samples;

    for (int i = 0; i < 3; i++)
        voxels *= out->size[i] = count < 6 ? 0 : size_at(bytes + 2 * i);
    for (out->bytes = 4; out->bytes > 1 && (count - 6) / out->bytes < voxels; out->bytes /= 2)
        ;
    if (voxels == 0 || (count - 6) / out->bytes < voxels) {
        report_fail(in, &in->value, POV_E_IO, "%.200s: this is no df3 file, or it is cut off", path);
        return false;
    }
    samples = state_alloc(in, (size_t)voxels * out->bytes, 1);
    if (samples)
        memcpy(samples, bytes + 6, (size_t)voxels * out->bytes);
    out->samples = samples;
    return samples != NULL;
}

bool image_file_read_volume(pov_reader *in, const string *name, density_file *out)
{
    char path[INCLUDE_PATH_MAX], *bytes;
    size_t count;
    bool done;

    if (in->failed || !find(in, name, "df3", path))
        return false;
    bytes = read_bytes(in, name, path, &count);
    if (!bytes)
        return false;
    done = take_volume(in, path, (const unsigned char *)bytes, count, out);
    env_free(in->model->env, bytes);
    return done;
}
