/* jpeg.c - JPEG by libjpeg: written with full chroma and high quality, read with its most accurate methods. */
#include <povtrace/image.h>
#include <povtrace/plugin.h>

#include <setjmp.h>
#include <stdio.h>
#include <string.h>

#include <jpeglib.h>

enum { QUALITY = 95 };

/* libjpeg's own handler ends the program; this one goes back. */
typedef struct failure {
    struct jpeg_error_mgr base;        /* first, for libjpeg knows this one only */
    jmp_buf back;
} failure;

static void on_error(j_common_ptr codec)
{
    longjmp(((failure *)(void *)codec->err)->back, 1);
}

static void on_message(j_common_ptr codec, int level)
{
    (void)codec;
    (void)level;
}

static void on_text(j_common_ptr codec)
{
    (void)codec;
}

static void prepare_failure(failure *f)
{
    jpeg_std_error(&f->base);
    f->base.error_exit = on_error;
    f->base.emit_message = on_message;
    f->base.output_message = on_text;
}

/* ---- writing ---- */

typedef struct sink {
    struct jpeg_destination_mgr base;
    const pov_output *output;
    bool has_failed;
    JOCTET buffer[1 << 14];
} sink;

static void begin_writing(j_compress_ptr codec)
{
    sink *to = (sink *)(void *)codec->dest;

    to->base.next_output_byte = to->buffer;
    to->base.free_in_buffer = sizeof to->buffer;
}

static void put(j_compress_ptr codec, size_t count)
{
    sink *to = (sink *)(void *)codec->dest;

    if (!to->output->put(to->output->user, to->buffer, count)) {
        to->has_failed = true;
        on_error((j_common_ptr)codec);
    }
}

static boolean put_full(j_compress_ptr codec)
{
    put(codec, sizeof ((sink *)(void *)codec->dest)->buffer);
    begin_writing(codec);
    return TRUE;
}

static void put_rest(j_compress_ptr codec)
{
    put(codec, sizeof ((sink *)(void *)codec->dest)->buffer - codec->dest->free_in_buffer);
}

/* Contains all calls that may longjmp. */
static void put_picture(struct jpeg_compress_struct *codec, const pov_image *image)
{
    codec->image_width = (JDIMENSION)image->width;
    codec->image_height = (JDIMENSION)image->height;
    codec->input_components = 3;
    codec->in_color_space = JCS_RGB;
    jpeg_set_defaults(codec);
    jpeg_set_quality(codec, QUALITY, TRUE);
    codec->comp_info[0].h_samp_factor = codec->comp_info[0].v_samp_factor = 1;
    codec->dct_method = JDCT_ISLOW;
    codec->optimize_coding = TRUE;
    jpeg_start_compress(codec, TRUE);
    for (int y = 0; y < image->height; y++) {
        JSAMPROW row = (JSAMPROW)image->pixels + (size_t)y * image->stride;

        jpeg_write_scanlines(codec, &row, 1);
    }
    jpeg_finish_compress(codec);
}

static const char *write_jpeg(const pov_image *image, const pov_output *output)
{
    struct jpeg_compress_struct codec;
    failure fail;
    sink to = { .output = output };
    const char *volatile wrong = NULL;

    if (image->width > JPEG_MAX_DIMENSION || image->height > JPEG_MAX_DIMENSION)
        return "a JPEG has at most 65500 pixels across";
    memset(&codec, 0, sizeof codec);
    prepare_failure(&fail);
    codec.err = &fail.base;
    if (setjmp(fail.back) == 0) {
        jpeg_create_compress(&codec);
        to.base.init_destination = begin_writing;
        to.base.empty_output_buffer = put_full;
        to.base.term_destination = put_rest;
        codec.dest = &to.base;
        put_picture(&codec, image);
    } else {
        wrong = to.has_failed ? "could not write" : "libjpeg refused the picture";
    }
    jpeg_destroy_compress(&codec);
    return wrong;
}

/* ---- reading ---- */

/* What is described before the pixels, to one kind of target or the other. */
typedef struct reading {
    const pov_image_target *target;
    const pov_raster_target *raster_target;
    bool is_out_of_memory;
} reading;

static unsigned char *begin_image(const struct jpeg_decompress_struct *codec, const pov_image_target *target, size_t stride)
{
    pov_image about = POV_INIT(about);

    about.width = (int)codec->output_width;
    about.height = (int)codec->output_height;
    about.bits = 8;
    about.transfer = POV_TRANSFER_SRGB;
    about.stride = stride;
    return target->begin(target->user, &about);
}

static unsigned char *begin_raster(const struct jpeg_decompress_struct *codec, const pov_raster_target *target, size_t stride)
{
    pov_raster about = POV_INIT(about);

    about.width = (int)codec->output_width;
    about.height = (int)codec->output_height;
    about.bits = 8;
    about.channels = codec->output_components;
    about.encoding = POV_ENCODING_SRGB;
    about.stride = stride;
    return target->begin(target->user, &about);
}

/* Contains all calls that may longjmp. */
static void get_picture(struct jpeg_decompress_struct *codec, reading *r)
{
    const bool keeps_grey = r->raster_target != NULL;
    unsigned char *pixels;
    size_t stride;

    jpeg_read_header(codec, TRUE);
    codec->out_color_space = keeps_grey && codec->jpeg_color_space == JCS_GRAYSCALE ? JCS_GRAYSCALE : JCS_RGB;
    codec->dct_method = JDCT_ISLOW;
    jpeg_calc_output_dimensions(codec);
    stride = (size_t)codec->output_width * (size_t)codec->output_components;
    pixels = r->target ? begin_image(codec, r->target, stride) : begin_raster(codec, r->raster_target, stride);
    if (!pixels) {
        r->is_out_of_memory = true;
        on_error((j_common_ptr)codec);
    }
    jpeg_start_decompress(codec);
    while (codec->output_scanline < codec->output_height) {
        JSAMPROW row = pixels + (size_t)codec->output_scanline * stride;

        jpeg_read_scanlines(codec, &row, 1);
    }
    jpeg_finish_decompress(codec);
}

static const char *get(const void *bytes, size_t count, reading *r)
{
    struct jpeg_decompress_struct codec;
    failure fail;
    const char *volatile wrong = NULL;

    if (count < 3 || memcmp(bytes, "\xff\xd8\xff", 3) != 0)
        return "it does not begin like a JPEG";
    memset(&codec, 0, sizeof codec);
    prepare_failure(&fail);
    codec.err = &fail.base;
    if (setjmp(fail.back) == 0) {
        jpeg_create_decompress(&codec);
        jpeg_mem_src(&codec, bytes, (unsigned long)count);
        get_picture(&codec, r);
        if (fail.base.num_warnings > 0)
            wrong = "it is cut off or damaged";
    } else {
        wrong = r->is_out_of_memory ? "there is no memory for it" : "libjpeg cannot read it";
    }
    jpeg_destroy_decompress(&codec);
    return wrong;
}

static const char *read_jpeg(const void *bytes, size_t count, const pov_image_target *target)
{
    reading r = { .target = target };

    return get(bytes, count, &r);
}

static const char *load_jpeg(const void *bytes, size_t count, const pov_raster_target *target)
{
    reading r = { .raster_target = target };

    return get(bytes, count, &r);
}

static const pov_image_format jpeg = {
    .size = sizeof(pov_image_format),
    .depths = POV_IMAGE_8,
    .ending = "jpeg",
    .write = write_jpeg,
    .read = read_jpeg,
    .load = load_jpeg,
};
static const pov_image_format *const formats[] = { &jpeg, NULL };

POV_PLUGIN(jpeg) = {
    .abi = POV_PLUGIN_ABI, .size = sizeof(pov_plugin), .name = "jpeg", .version = "0.1.0", .images = formats,
};
