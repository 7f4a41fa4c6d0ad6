#include "api/adapt.h"
#include "api/handles.h"
#include "api/image.h"
#include "base/file.h"
#include "base/pages.h"
#include "render/encode.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

/* ---- the format ---- */

/* The ending of the path's last component, in lower case; empty when it has none. */
static void ending_of(const char *path, char *out, size_t size)
{
    const char *name = strrchr(path, '/'), *dot = strrchr(name ? name + 1 : path, '.');
    size_t i;

    /* A name that only starts with a dot has no ending. */
    for (i = 0; dot && dot != (name ? name + 1 : path) && dot[1 + i] && i + 1 < size; i++)
        out[i] = (char)tolower((unsigned char)dot[1 + i]);
    out[i] = '\0';
}

/* Names of formats that are written, in alphabetical order. */
typedef struct names { pov_context *context; char text[256]; char of[16][16]; int count; } names;

static void note_name(void *user, const char *keyword)
{
    const pov_image_format *format;
    names *n = user;
    pov_error ignored;
    int at = 0;

    if (strlen(keyword) >= sizeof n->of[0] || n->count == 16 ||
        registry_image(n->context->plugins, keyword, &format, &ignored) < 0 || !format || !format->write)
        return;
    while (at < n->count && strcmp(n->of[at], keyword) < 0)
        at++;
    if (at < n->count && strcmp(n->of[at], keyword) == 0)
        return;
    memmove(n->of + at + 1, n->of + at, sizeof n->of[0] * (size_t)(n->count++ - at));
    strcpy(n->of[at], keyword);
}

/* An ending that nothing writes: what there is, or where it was looked for. */
static pov_status refuse_ending(pov_context *context, const char *path, const char *ending, pov_error *err)
{
    names all = { .context = context };

    registry_each_keyword(context->plugins, "images", note_name, &all);
    if (all.count == 0)
        return err_file(err, POV_E_PLUGIN, path, "no plugin writes images of the ending \".%s\"; searched images/ in %s", ending,
                        registry_path(context->plugins));
    for (int i = 0; i < all.count; i++)
        snprintf(all.text + strlen(all.text), sizeof all.text - strlen(all.text), "%s%s", i > 0 ? ", " : "", all.of[i]);
    return err_file(err, POV_E_ARGUMENT, path, "no plugin writes images of the ending \".%s\"; there are %s", ending, all.text);
}

pov_status image_find_format(pov_context *context, const char *path, const pov_image_options *o,
                             const pov_image_format **out, pov_error *err)
{
    char ending[32];
    pov_status status;

    if (o->format)
        snprintf(ending, sizeof ending, "%s", o->format);
    else
        ending_of(path, ending, sizeof ending);
    if (!ending[0])
        return err_file(err, POV_E_ARGUMENT, path, "the name has no ending such as .png to tell the image format");
    status = registry_image(context->plugins, ending, out, err);
    if (status == POV_OK && !*out)
        return refuse_ending(context, path, ending, err);
    return status;
}

/* Bits a channel: as asked, or the lowest of the format. 0: not supported. */
static int depth_for(const pov_image_format *f, int asked)
{
    if (asked == 0)
        return f->depths & POV_IMAGE_8 ? 8 : f->depths & POV_IMAGE_16 ? 16 : 32;
    if (asked == 8 && f->depths & POV_IMAGE_8)
        return 8;
    if (asked == 16 && f->depths & POV_IMAGE_16)
        return 16;
    /* A format of floats holds more than any requested depth. */
    return (asked == 8 || asked == 16) && !(f->depths & (POV_IMAGE_8 | POV_IMAGE_16)) ? 32 : 0;
}

enum { LAYERS_MAX = 60, LAYER_NAME_MAX = 31 };

static bool are_layers(const pov_image_options *o)
{
    bool valid = o->layer_count >= 0 && o->layer_count <= LAYERS_MAX && (o->layers || o->layer_count == 0);

    for (int i = 0; valid && i < o->layer_count; i++) {
        const pov_layer *l = &o->layers[i];

        valid = l->name && l->name[0] && strlen(l->name) <= LAYER_NAME_MAX && l->values && l->step > 0;
        for (int j = 0; valid && j < i; j++)
            valid = strcmp(l->name, o->layers[j].name) != 0;
    }
    return valid;
}

static pov_status check_layers(const char *path, const pov_image_format *format, const pov_image_options *o, pov_error *err)
{
    if (!are_layers(o))
        return err_set(err, POV_E_ARGUMENT, "at most 60 layers have values, and names of their own of 1 to 31 characters");
    if (o->layer_count > 0 && !(format->depths & POV_IMAGE_LAYERS))
        return err_file(err, POV_E_ARGUMENT, path, "layers cannot be stored in a .%s file", format->ending);
    return POV_OK;
}

static pov_status prepare(pov_context *context, const char *path, const pov_image_options *options,
                          pov_image_options *o, const pov_image_format **format, pov_error *err)
{
    pov_status status;

    if (!context || !path)
        return err_set(err, POV_E_ARGUMENT, "an image needs a context and a path");
    status = adapt_in(o, sizeof *o, options, "the image options", err);
    if (status == POV_OK)
        status = image_find_format(context, path, o, format, err);
    if (status < 0)
        return status;
    if (o->transfer != POV_TRANSFER_LINEAR && o->transfer != POV_TRANSFER_SRGB)
        return err_set(err, POV_E_ARGUMENT, "unknown transfer curve");
    if (!(o->gamma >= 0.0) || o->gamma > 100.0)
        return err_set(err, POV_E_ARGUMENT, "the gamma of a picture is a number of 0 to 100");
    if (!(*format)->write)
        return err_file(err, POV_E_UNSUPPORTED, path, "images of the ending \".%s\" can be read, not written", (*format)->ending);
    if (depth_for(*format, o->bits) == 0)
        return err_file(err, POV_E_ARGUMENT, path, "%d bits a channel cannot be stored in a .%s file", o->bits,
                        (*format)->ending);
    if (o->alpha && !((*format)->depths & POV_IMAGE_ALPHA))
        return err_file(err, POV_E_ARGUMENT, path, "alpha cannot be stored in a .%s file", (*format)->ending);
    return check_layers(path, *format, o, err);
}

pov_status pov_image_check(pov_context *context, const char *path, const pov_image_options *options, pov_error *err)
{
    const pov_image_format *format;
    pov_image_options o;

    pov_status status = prepare(context, path, options, &o, &format, err);

    return status < 0 ? status : file_writer_try(&context->env, path, err);
}

/* ---- the pixels ---- */

static bool put(void *user, const void *bytes, size_t count)
{
    return file_writer_put(user, bytes, count);
}

/* Write to a file, or to the program's own output. */
typedef struct place { const char *path; const pov_output *output; } place;

static pov_status write_file(pov_context *context, const char *path, const pov_image_format *format,
                             const pov_image *image, pov_error *err)
{
    file_writer *writer = env_alloc(&context->env, 1, sizeof *writer);
    pov_output output = { writer, put };
    const char *wrong;
    pov_status status;

    if (!writer)
        return err_memory(err);
    status = file_writer_open(writer, &context->env, path, err);
    if (status == POV_OK) {
        wrong = format->write(image, &output);
        if (wrong && writer->error == 0) {
            file_writer_discard(writer);
            status = err_file(err, POV_E_IO, path, "cannot write this image: %s", wrong);
        } else {
            status = file_writer_commit(writer, err);
        }
    }
    env_free(&context->env, writer);
    return status;
}

/* Colours divided by their alpha; without any they are black. As in POV-Ray, what is brighter than it is opaque is made as
 * opaque as it is bright: a highlight on glass would be lost else, for a file holds nothing above 1. */
static void divide_by_alpha(const float *rgba, int count, float *out)
{
    for (int i = 0; i < count; i++, rgba += 4, out += 4) {
        const float grey = 0.297f * rgba[0] + 0.589f * rgba[1] + 0.114f * rgba[2], bright = grey < 1.0f ? grey : 1.0f;
        const float alpha = rgba[3] > bright ? rgba[3] : bright;

        for (int c = 0; c < 3; c++)
            out[c] = alpha > 0.0f ? rgba[c] / alpha : 0.0f;
        out[3] = alpha;
    }
}

/* straight: a row's buffer, for images with alpha. */
static void pack_rows(const pov_image *image, const float *rgba, size_t stride, float *straight, unsigned char *to)
{
    const unsigned char *from = (const unsigned char *)rgba;
    encoder encode;

    encoder_init(&encode, image->bits, image->transfer, image->gamma);
    for (int y = 0; y < image->height; y++, from += stride, to += image->stride) {
        const float *row = (const float *)(const void *)from;

        if (straight)
            divide_by_alpha(row, image->width, straight);
        encoder_row(&encode, straight ? straight : row, image->width, straight ? 4 : 3, to);
    }
}

/* Pack the channels of each pixel, rows without gaps; NULL: no memory. */
static void *pack(const env *e, const pov_image *image, const float *rgba, size_t stride)
{
    unsigned char *packed = image->stride <= SIZE_MAX / (size_t)image->height ? pages_reserve(e, (size_t)image->height * image->stride) : NULL;
    float *straight = image->alpha ? env_resize(e, NULL, (size_t)image->width, 4 * sizeof *straight) : NULL;

    if (packed && (straight || !image->alpha)) {
        pack_rows(image, rgba, stride, straight, packed);
    } else {
        pages_free(e, packed);
        packed = NULL;
    }
    env_free(e, straight);
    return packed;
}

static pov_status put_out(const pov_output *output, const pov_image_format *format, const pov_image *image,
                          pov_error *err)
{
    const char *wrong = format->write(image, output);

    return wrong ? err_set(err, POV_E_IO, "cannot write this image: %s", wrong) : POV_OK;
}

static pov_status write_image(pov_context *context, place to, int width, int height, const float *rgba, size_t stride,
                              const pov_image_options *options, pov_error *err)
{
    const pov_image_format *format;
    pov_image image = POV_INIT(image);
    pov_image_options o;
    pov_status status = prepare(context, to.path, options, &o, &format, err);
    void *packed;

    if (status < 0)
        return status;
    if (!rgba || width <= 0 || height <= 0 || stride / (4 * sizeof *rgba) < (size_t)width || stride % sizeof *rgba != 0)
        return err_set(err, POV_E_ARGUMENT, "an image needs pixels, a size and a stride of whole rows of floats");
    image.width = width;
    image.height = height;
    image.bits = depth_for(format, o.bits);
    image.transfer = o.transfer;
    image.gamma = o.gamma;
    image.alpha = o.alpha != 0;
    image.layers = o.layers;
    image.layer_count = o.layer_count;
    image.stride = (size_t)width * (image.alpha ? 4 : 3) * (size_t)(image.bits / 8);
    packed = pack(&context->env, &image, rgba, stride);
    if (!packed)
        return err_memory(err);
    image.pixels = packed;
    status = to.output ? put_out(to.output, format, &image, err) : write_file(context, to.path, format, &image, err);
    pages_free(&context->env, packed);
    return status;
}

pov_status pov_image_write(pov_context *context, const char *path, int width, int height, const float *rgba,
                           size_t stride, const pov_image_options *options, pov_error *err)
{
    place to = { path, NULL };

    return write_image(context, to, width, height, rgba, stride, options, err);
}

pov_status pov_image_put(pov_context *context, const pov_output *output, int width, int height, const float *rgba,
                         size_t stride, const pov_image_options *options, pov_error *err)
{
    place to = { "", output };

    if (!output || !output->put)
        return err_set(err, POV_E_ARGUMENT, "no output was given");
    return write_image(context, to, width, height, rgba, stride, options, err);
}
