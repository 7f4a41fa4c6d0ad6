/* ppm.c - portable pixel maps (P6), 8 or 16 bits a channel, the high byte first. */
#include <povtrace/plugin.h>

#include <stdio.h>

/* 16-bit samples turned byte by byte, whatever order the machine has. */
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

static const pov_image_format ppm = {
    .size = sizeof(pov_image_format),
    .depths = POV_IMAGE_8 | POV_IMAGE_16,
    .ending = "ppm",
    .write = write_ppm,
};
static const pov_image_format *const formats[] = { &ppm, NULL };

POV_PLUGIN(ppm) = {
    .abi = POV_PLUGIN_ABI, .size = sizeof(pov_plugin), .name = "ppm", .version = "0.1.0", .images = formats,
};
