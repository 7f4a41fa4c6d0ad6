#include "api/adapt.h"
#include "api/image.h"
#include "base/file.h"
#include "base/srgb.h"

#include <string.h>

/* The pixels that a plugin read, before they are unpacked. */
typedef struct received { const env *env; int width, height; pov_image about; void *pixels; } received;

static bool is_possible(const pov_image *about)
{
    size_t row = (size_t)about->width * 3 * (size_t)(about->bits / 8);

    return about->width > 0 && about->height > 0 && (about->bits == 8 || about->bits == 16 || about->bits == 32) &&
           about->stride >= row;
}

/* Has it another size than what is asked for? */
static bool is_unwanted(const received *r)
{
    return r->width > 0 && r->height > 0 && r->about.width > 0 && (r->about.width != r->width || r->about.height != r->height);
}

static void *begin(void *user, const pov_image *about)
{
    received *r = user;

    if (r->pixels || !is_possible(about))
        return NULL;
    r->about = *about;
    if (is_unwanted(r))
        return NULL;
    r->pixels = env_alloc(r->env, (size_t)about->height, about->stride);
    return r->pixels;
}

static float linear_of(const pov_image *about, unsigned stored, double most)
{
    double value = stored / most;

    return (float)(about->transfer == POV_TRANSFER_SRGB ? srgb_decode(value) : value);
}

static void unpack_row(const pov_image *about, const unsigned char *row, float *rgba)
{
    uint16_t wide;

    for (int i = 0; i < 3 * about->width; i++) {
        float *to = &rgba[i / 3 * 4 + i % 3];

        if (about->bits == 8) {
            *to = linear_of(about, row[i], 255.0);
        } else if (about->bits == 16) {
            memcpy(&wide, row + 2 * i, sizeof wide);
            *to = linear_of(about, wide, 65535.0);
        } else {
            memcpy(to, row + 4 * i, sizeof *to);
        }
    }
    for (int x = 0; x < about->width; x++)
        rgba[4 * x + 3] = 1.0f;
}

static pov_status unpack(const received *r, pov_bitmap *out, pov_error *err)
{
    size_t width = (size_t)r->about.width, height = (size_t)r->about.height;

    if (height <= SIZE_MAX / 16 / width)
        out->rgba = env_resize(r->env, NULL, width * height, 4 * sizeof *out->rgba);
    if (!out->rgba)
        return err_memory(err);
    out->width = r->about.width;
    out->height = r->about.height;
    out->bits = r->about.bits;
    for (size_t y = 0; y < height; y++)
        unpack_row(&r->about, (const unsigned char *)r->pixels + y * r->about.stride, out->rgba + 4 * y * width);
    return POV_OK;
}

static pov_status decode(pov_context *context, const pov_image_format *format, const char *path, const char *bytes,
                         size_t count, pov_bitmap *out, pov_error *err)
{
    received r = { .env = &context->env, .width = out->width, .height = out->height };
    pov_image_target target = { &r, begin };
    const char *wrong = format->read(bytes, count, &target);
    pov_status status;

    if (is_unwanted(&r))
        status = err_file(err, POV_E_ARGUMENT, path, "this image has %d x %d pixels, where %d x %d are wanted", r.about.width,
                          r.about.height, r.width, r.height);
    else if (wrong || !r.pixels)
        status = err_file(err, POV_E_IO, path, "cannot read this image: %s", wrong ? wrong : "it holds no picture");
    else
        status = unpack(&r, out, err);
    env_free(&context->env, r.pixels);
    return status;
}

pov_status pov_image_read(pov_context *context, const char *path, pov_bitmap *out, pov_error *err)
{
    pov_image_options none = POV_INIT(none);
    pov_bitmap bitmap = POV_INIT(bitmap);
    const pov_image_format *format;
    size_t count;
    char *bytes;
    pov_status status;

    if (!context || !path || !out)
        return err_set(err, POV_E_ARGUMENT, "to read an image takes a context, a path and a place for it");
    if (!POV_HAS(out, pov_bitmap, rgba))
        return err_set(err, POV_E_ARGUMENT, "the bitmap has no size: initialise it with POV_INIT");
    bitmap.width = out->width;
    bitmap.height = out->height;
    status = image_find_format(context, path, &none, &format, err);
    if (status < 0)
        return status;
    if (!POV_HAS(format, pov_image_format, read) || !format->read)
        return err_file(err, POV_E_UNSUPPORTED, path, "images of the ending \".%s\" can be written, not read",
                        format->ending);
    status = file_read(&context->env, path, &bytes, &count, err);
    if (status < 0)
        return status;
    status = decode(context, format, path, bytes, count, &bitmap, err);
    env_free(&context->env, bytes);
    if (status == POV_OK)
        adapt_out(out, &bitmap, sizeof bitmap);
    return status;
}

void pov_image_free(pov_context *context, pov_bitmap *bitmap)
{
    if (!context || !bitmap)
        return;
    env_free(&context->env, bitmap->rgba);
    bitmap->rgba = NULL;
}
