/* png.c - PNG by libpng, 8 or 16 bits a channel, with alpha or without, row by row.
 *
 * A picture encoded with the sRGB curve says so in an sRGB chunk. A picture of unencoded values has no statement about
 * gamma: by the course's rule the stored number is shown as it is, and a gAMA chunk of 1.0 would make viewers brighten
 * it. */
#include <povtrace/image.h>
#include <povtrace/plugin.h>

#include <png.h>
#include <setjmp.h>
#include <string.h>

/* One filter for all rows and the quickest level take a quarter of the time of libpng's own choice; docs/cli.md has figures. */
enum { COMPRESSION_LEVEL = 1 };

typedef struct sink {
    const pov_output *output;
    const char *problem;      /* static text */
} sink;

static void put_bytes(png_structp png, png_bytep bytes, png_size_t count)
{
    sink *to = png_get_io_ptr(png);

    if (!to->output->put(to->output->user, bytes, count)) {
        to->problem = "could not write";
        png_error(png, to->problem);
    }
}

/* Buffering and flushing are the host's. */
static void flush_nothing(png_structp png)
{
    (void)png;
}

/* libpng's text may be on its stack, so it is not passed on. */
static void on_error(png_structp png, png_const_charp text)
{
    sink *to = png_get_error_ptr(png);

    (void)text;
    if (!to->problem)
        to->problem = "libpng refused the picture";
    png_longjmp(png, 1);
}

static void on_warning(png_structp png, png_const_charp text)
{
    (void)png;
    (void)text;
}

static bool is_little_endian(void)
{
    const uint16_t one = 1;

    return *(const unsigned char *)&one == 1;
}

/* Contains all calls that may longjmp: no local here owns memory. */
static void put_picture(png_structp png, png_infop info, const pov_image *image)
{
    png_set_compression_level(png, COMPRESSION_LEVEL);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_UP);
    png_set_IHDR(png, info, (png_uint_32)image->width, (png_uint_32)image->height, image->bits,
                 image->alpha ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    if (image->gamma > 0.0)
        png_set_gAMA(png, info, 1.0 / image->gamma);
    else if (image->transfer == POV_TRANSFER_SRGB)
        png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_write_info(png, info);
    if (image->bits == 16 && is_little_endian())
        png_set_swap(png);
    for (int y = 0; y < image->height; y++)
        png_write_row(png, (png_const_bytep)image->pixels + (size_t)y * image->stride);
    png_write_end(png, info);
}

static const char *write_png(const pov_image *image, const pov_output *output)
{
    sink to = { output, NULL };
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &to, on_error, on_warning);
    png_infop info;

    if (!png)
        return "out of memory, or another version of libpng";
    info = png_create_info_struct(png);
    if (!info) {
        png_destroy_write_struct(&png, NULL);
        return "out of memory";
    }
    /* png and info do not change between here and a jump, so they need not be volatile; `to` is reached
     * through pointers. */
    if (setjmp(png_jmpbuf(png)) == 0) {
        png_set_write_fn(png, &to, put_bytes, flush_nothing);
        put_picture(png, info, image);
    }
    png_destroy_write_struct(&png, &info);
    return to.problem;
}

/* ---- reading ---- */

typedef struct source {
    const unsigned char *at, *end;
    const char *problem;      /* static text */
    const pov_image_target *target;
    const pov_raster_target *raster_target;   /* one of the two */
    double count;             /* of bytes, of the whole file */
    unsigned char *pixels;    /* the host's */
    pov_image about;
    pov_raster raster;
    unsigned char palette[256][4];
} source;

static void get_bytes(png_structp png, png_bytep bytes, png_size_t count)
{
    source *from = png_get_io_ptr(png);

    if ((size_t)(from->end - from->at) < count) {
        from->problem = "it is cut off";
        png_error(png, from->problem);
    }
    memcpy(bytes, from->at, count);
    from->at += count;
}

static void on_read_error(png_structp png, png_const_charp text)
{
    source *from = png_get_error_ptr(png);

    (void)text;
    if (!from->problem)
        from->problem = "libpng cannot read it";
    png_longjmp(png, 1);
}

/* Convert any format to red, green and blue of 8 or 16 bits. */
static void ask_for_rgb(png_structp png, png_infop info)
{
    png_set_expand(png);
    png_set_strip_alpha(png);
    png_set_gray_to_rgb(png);
    png_set_interlace_handling(png);
    if (png_get_bit_depth(png, info) == 16 && is_little_endian())
        png_set_swap(png);
    png_read_update_info(png, info);
}

/* A file without a statement stores unencoded values, as write_png() writes them. */
static pov_transfer transfer_of(png_structp png, png_infop info)
{
    const double srgb_about = 0.45455, near = 0.005;
    double gamma = 1.0;
    int intent;

    if (png_get_sRGB(png, info, &intent))
        return POV_TRANSFER_SRGB;
    if (png_get_gAMA(png, info, &gamma) && gamma > srgb_about - near && gamma < srgb_about + near)
        return POV_TRANSFER_SRGB;
    return POV_TRANSFER_LINEAR;
}

/* Nothing is packed tighter than 1032 to 1 there: a larger picture is a claim. */
static void expect_bytes(png_structp png, source *from, int height, size_t stride)
{
    if ((double)height * (double)stride > 1100.0 * from->count + 65536.0) {
        from->problem = "it is too short for its size";
        png_error(png, from->problem);
    }
}

static void get_rows(png_structp png, source *from, int passes, int height, size_t stride)
{
    if (!from->pixels) {
        from->problem = "there is no memory for it";
        png_error(png, from->problem);
    }
    for (; passes > 0; passes--)
        for (int y = 0; y < height; y++)
            png_read_row(png, from->pixels + (size_t)y * stride, NULL);
}

static int passes_of(png_structp png, png_infop info)
{
    return png_get_interlace_type(png, info) == PNG_INTERLACE_ADAM7 ? 7 : 1;
}

/* Contains all calls that may longjmp. */
static void get_picture(png_structp png, png_infop info, source *from)
{
    int passes;

    png_read_info(png, info);
    from->about.transfer = transfer_of(png, info);
    passes = passes_of(png, info);
    ask_for_rgb(png, info);
    from->about.width = (int)png_get_image_width(png, info);
    from->about.height = (int)png_get_image_height(png, info);
    from->about.bits = png_get_bit_depth(png, info);
    from->about.stride = png_get_rowbytes(png, info);
    expect_bytes(png, from, from->about.height, from->about.stride);
    from->pixels = from->target->begin(from->target->user, &from->about);
    get_rows(png, from, passes, from->about.height, from->about.stride);
}

/* ---- as stored ---- */

static void get_encoding(png_structp png, png_infop info, pov_raster *about)
{
    double gamma = 0.0;
    int intent;

    about->encoding = POV_ENCODING_SRGB;
    if (!png_get_sRGB(png, info, &intent) && png_get_gAMA(png, info, &gamma) && gamma > 0.0) {
        about->encoding = POV_ENCODING_POWER;
        about->power = 1.0 / gamma;
    }
}

static void get_palette(png_structp png, png_infop info, source *from)
{
    png_colorp colours = NULL;
    png_bytep alpha = NULL;
    int count = 0, alphas = 0;

    png_get_PLTE(png, info, &colours, &count);
    png_get_tRNS(png, info, &alpha, &alphas, NULL);
    for (int i = 0; i < count && i < 256; i++) {
        from->palette[i][0] = colours[i].red;
        from->palette[i][1] = colours[i].green;
        from->palette[i][2] = colours[i].blue;
        from->palette[i][3] = i < alphas ? alpha[i] : 255;
    }
    from->raster.palette = from->palette[0];
    from->raster.colours = count;
    from->raster.has_alpha = alphas > 0;
}

/* Samples of whole bytes, indices as they are; a transparent grey becomes alpha, a transparent colour does not. */
static void ask_for_samples(png_structp png, png_infop info)
{
    const int type = png_get_color_type(png, info);

    if (type == PNG_COLOR_TYPE_PALETTE)
        png_set_packing(png);
    else if (type == PNG_COLOR_TYPE_GRAY && png_get_valid(png, info, PNG_INFO_tRNS))
        png_set_tRNS_to_alpha(png);
    else if (type == PNG_COLOR_TYPE_GRAY)
        png_set_expand_gray_1_2_4_to_8(png);
    png_set_interlace_handling(png);
    if (png_get_bit_depth(png, info) == 16 && is_little_endian())
        png_set_swap(png);
    png_read_update_info(png, info);
}

/* Contains all calls that may longjmp. */
static void get_raster(png_structp png, png_infop info, source *from)
{
    pov_raster *about = &from->raster;
    int passes;

    about->size = sizeof *about;
    png_read_info(png, info);
    get_encoding(png, info, about);
    if (png_get_color_type(png, info) == PNG_COLOR_TYPE_PALETTE)
        get_palette(png, info, from);
    passes = passes_of(png, info);
    ask_for_samples(png, info);
    about->width = (int)png_get_image_width(png, info);
    about->height = (int)png_get_image_height(png, info);
    about->bits = png_get_bit_depth(png, info);
    about->channels = png_get_channels(png, info);
    about->stride = png_get_rowbytes(png, info);
    expect_bytes(png, from, about->height, about->stride);
    from->pixels = from->raster_target->begin(from->raster_target->user, about);
    get_rows(png, from, passes, about->height, about->stride);
}

static const char *get(source *from, size_t count, void (*what)(png_structp png, png_infop info, source *from))
{
    png_structp png;
    png_infop info;

    if (count < 8 || png_sig_cmp(from->at, 0, 8) != 0)
        return "it does not begin like a PNG";
    png = png_create_read_struct(PNG_LIBPNG_VER_STRING, from, on_read_error, on_warning);
    if (!png)
        return "out of memory, or another version of libpng";
    info = png_create_info_struct(png);
    if (!info) {
        png_destroy_read_struct(&png, NULL, NULL);
        return "out of memory";
    }
    from->count = (double)count;
    if (setjmp(png_jmpbuf(png)) == 0) {
        png_set_read_fn(png, from, get_bytes);
        what(png, info, from);
    }
    png_destroy_read_struct(&png, &info, NULL);
    return from->problem;
}

static const char *read_png(const void *bytes, size_t count, const pov_image_target *target)
{
    source from = { .at = bytes, .end = (const unsigned char *)bytes + count, .target = target };

    from.about.size = sizeof from.about;
    return get(&from, count, get_picture);
}

static const char *load_png(const void *bytes, size_t count, const pov_raster_target *target)
{
    source from = { .at = bytes, .end = (const unsigned char *)bytes + count, .raster_target = target };

    return get(&from, count, get_raster);
}

static const pov_image_format png_format = {
    .size = sizeof(pov_image_format),
    .depths = POV_IMAGE_8 | POV_IMAGE_16 | POV_IMAGE_ALPHA,
    .ending = "png",
    .write = write_png,
    .read = read_png,
    .load = load_png,
};
static const pov_image_format *const formats[] = { &png_format, NULL };

POV_PLUGIN(png) = {
    .abi = POV_PLUGIN_ABI, .size = sizeof(pov_plugin), .name = "png", .version = "0.1.0", .images = formats,
};
