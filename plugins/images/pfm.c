/* pfm.c - portable float maps: linear floats as they are, three to a pixel, the bottom row first. */
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

/* The sign of the third number names the byte order of the floats; below zero is little-endian. What the
 * machine has is written, so that a row is put without a copy. */
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

static const pov_image_format pfm = {
    .size = sizeof(pov_image_format),
    .depths = POV_IMAGE_FLOAT,
    .ending = "pfm",
    .write = write_pfm,
};
static const pov_image_format *const formats[] = { &pfm, NULL };

POV_PLUGIN(pfm) = {
    .abi = POV_PLUGIN_ABI, .size = sizeof(pov_plugin), .name = "pfm", .version = "0.1.0", .images = formats,
};
