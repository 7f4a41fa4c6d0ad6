/* image.h - the plugin of an image file. */
#ifndef API_IMAGE_H
#define API_IMAGE_H

#include "api/handles.h"

#include <povtrace/image.h>

pov_status image_find_format(pov_context *context, const char *path, const pov_image_options *o,
                             const pov_image_format **out, pov_error *err);

#endif
