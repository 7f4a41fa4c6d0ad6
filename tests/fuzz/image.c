#include "fuzz/fuzz.h"

#include "support/scenes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

static const char *const endings[] = { "png", "ppm", "pfm", "jpg", "tif", "exr" };

static void put(const char *path, const uint8_t *data, size_t size)
{
    FILE *to = fopen(path, "wb");

    if (!to || fwrite(data, 1, size, to) != size || fclose(to) != 0) {
        perror(path);
        abort();
    }
}

void fuzz_image(const uint8_t *data, size_t size)
{
    pov_bitmap bitmap = POV_INIT(bitmap);
    pov_context_desc d = POV_INIT(d);
    pov_context *context;
    char path[64];
    pov_error err;

    if (size == 0)
        return;
    snprintf(path, sizeof path, "/tmp/povtrace-fuzz-%ld.%s", (long)getpid(), endings[data[0] % 6]);
    put(path, data + 1, size - 1);
    d.plugin_path = TEST_PLUGINS;
    if (pov_context_create(&context, &d, &err) == POV_OK) {
        if (pov_image_read(context, path, &bitmap, &err) == POV_OK) {
            volatile float last = 0.0f;

            for (size_t i = 0; i < 4 * (size_t)bitmap.width * (size_t)bitmap.height; i++)
                last = bitmap.rgba[i];   /* every sample is there */
            (void)last;
        } else if (!err.message[0]) {
            abort();
        }
        pov_image_free(context, &bitmap);
        pov_context_destroy(context);
    }
    unlink(path);
}
