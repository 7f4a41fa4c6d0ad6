/* tiff.c - TIFF by libtiff, reading: grey, colour and palettes of 8 or 16 bits, with alpha; the first picture of a file. */
#include <povtrace/image.h>
#include <povtrace/plugin.h>

#include <string.h>

#include <tiffio.h>

/* ---- a file in memory ---- */

typedef struct source { const unsigned char *bytes; size_t count, at; } source;

static tmsize_t get_bytes(thandle_t user, void *to, tmsize_t count)
{
    source *from = user;
    size_t n = from->count - from->at;

    if (count < 0)
        return -1;
    n = (size_t)count < n ? (size_t)count : n;
    memcpy(to, from->bytes + from->at, n);
    from->at += n;
    return (tmsize_t)n;
}

static tmsize_t put_bytes(thandle_t user, void *from, tmsize_t count)
{
    (void)user;
    (void)from;
    (void)count;
    return -1;
}

static toff_t seek(thandle_t user, toff_t offset, int whence)
{
    source *from = user;
    const size_t base = whence == SEEK_SET ? 0 : whence == SEEK_CUR ? from->at : from->count;

    if (offset > from->count - base)
        return (toff_t)-1;
    return from->at = base + (size_t)offset;
}

static toff_t size(thandle_t user)
{
    return ((const source *)user)->count;
}

static int close_nothing(thandle_t user)
{
    (void)user;
    return 0;
}

/* What libtiff has to say would go to the program's own output. */
static int say_nothing(TIFF *file, void *user, const char *module, const char *format, va_list args)
{
    (void)file;
    (void)user;
    (void)module;
    (void)format;
    (void)args;
    return 1;
}

static TIFF *open_source(source *from)
{
    TIFFOpenOptions *options = TIFFOpenOptionsAlloc();
    TIFF *file;

    if (!options)
        return NULL;
    TIFFOpenOptionsSetErrorHandlerExtR(options, say_nothing, NULL);
    TIFFOpenOptionsSetWarningHandlerExtR(options, say_nothing, NULL);
    file = TIFFClientOpenExt("", "rm", from, get_bytes, put_bytes, seek, close_nothing, size, NULL, NULL, options);
    TIFFOpenOptionsFree(options);
    return file;
}

/* ---- the picture ---- */

typedef struct layout {
    pov_raster about;
    uint16_t samples, photometric, planar;
    unsigned char palette[256][4];
} layout;

static bool get_palette(TIFF *file, layout *l)
{
    uint16_t *red, *green, *blue;

    if (l->about.bits != 8 || !TIFFGetField(file, TIFFTAG_COLORMAP, &red, &green, &blue))
        return false;
    for (int i = 0; i < 256; i++) {
        l->palette[i][0] = (unsigned char)(red[i] >> 8);
        l->palette[i][1] = (unsigned char)(green[i] >> 8);
        l->palette[i][2] = (unsigned char)(blue[i] >> 8);
        l->palette[i][3] = 255;
    }
    l->about.palette = l->palette[0];
    l->about.colours = 256;
    return true;
}

static bool is_known(const layout *l)
{
    const pov_raster *a = &l->about;

    if (l->planar != PLANARCONFIG_CONTIG || (a->bits != 8 && a->bits != 16))
        return false;
    if (l->photometric == PHOTOMETRIC_PALETTE)
        return l->samples == 1;
    if (l->photometric == PHOTOMETRIC_MINISBLACK)
        return l->samples == 1 || l->samples == 2;
    return l->photometric == PHOTOMETRIC_RGB && (l->samples == 3 || l->samples == 4);
}

static const char *get_layout(TIFF *file, layout *l)
{
    uint32_t width = 0, height = 0;
    uint16_t bits = 1;

    TIFFGetField(file, TIFFTAG_IMAGEWIDTH, &width);
    TIFFGetField(file, TIFFTAG_IMAGELENGTH, &height);
    TIFFGetFieldDefaulted(file, TIFFTAG_BITSPERSAMPLE, &bits);
    TIFFGetFieldDefaulted(file, TIFFTAG_SAMPLESPERPIXEL, &l->samples);
    TIFFGetFieldDefaulted(file, TIFFTAG_PLANARCONFIG, &l->planar);
    TIFFGetField(file, TIFFTAG_PHOTOMETRIC, &l->photometric);
    if (width == 0 || height == 0 || width > INT32_MAX || height > INT32_MAX)
        return "its header is wrong";
    l->about.width = (int)width;
    l->about.height = (int)height;
    l->about.bits = bits;
    l->about.channels = l->samples;
    l->about.encoding = POV_ENCODING_STORED;
    l->about.stride = (size_t)TIFFScanlineSize(file);
    if (!is_known(l) || TIFFIsTiled(file) || l->about.stride != (size_t)width * l->samples * bits / 8)
        return "it is a kind of TIFF that is not read: grey, RGB and palettes are, of 8 or 16 bits, in strips";
    if (l->photometric == PHOTOMETRIC_PALETTE && !get_palette(file, l))
        return "its palette is wrong";
    return NULL;
}

static const char *get_picture(TIFF *file, const pov_raster_target *target)
{
    layout l = { .about = POV_INIT(l.about) };
    const char *wrong = get_layout(file, &l);
    unsigned char *pixels;

    if (wrong)
        return wrong;
    pixels = target->begin(target->user, &l.about);
    if (!pixels)
        return "there is no memory for it";
    for (int y = 0; y < l.about.height; y++)
        if (TIFFReadScanline(file, pixels + (size_t)y * l.about.stride, (uint32_t)y, 0) < 0)
            return "it is cut off or damaged";
    return NULL;
}

static const char *load_tiff(const void *bytes, size_t count, const pov_raster_target *target)
{
    source from = { bytes, count, 0 };
    const char *wrong;
    TIFF *file;

    if (count < 8 || (memcmp(bytes, "II", 2) != 0 && memcmp(bytes, "MM", 2) != 0))
        return "it does not begin like a TIFF";
    file = open_source(&from);
    if (!file)
        return "libtiff cannot read it";
    wrong = get_picture(file, target);
    TIFFClose(file);
    return wrong;
}

static const pov_image_format tiff = {
    .size = sizeof(pov_image_format), .depths = POV_IMAGE_8 | POV_IMAGE_16, .ending = "tiff", .load = load_tiff,
};
static const pov_image_format *const formats[] = { &tiff, NULL };

POV_PLUGIN(tiff) = {
    .abi = POV_PLUGIN_ABI, .size = sizeof(pov_plugin), .name = "tiff", .version = "0.1.0", .images = formats,
};
