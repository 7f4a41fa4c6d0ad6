/* raygen.h - from a pixel to a ray. */
#ifndef RENDER_RAYGEN_H
#define RENDER_RAYGEN_H

#include "world/world.h"

/* The ray of a camera through pixel (x, y) of a picture, row 0 at the top; (dx, dy) is the place within the
 * pixel, from its top left corner: (1/2, 1/2) is the centre. The direction is as long as it comes, for
 * rounding it to a unit vector would only add an error. */
pov_ray raygen_ray(const pov_camera *camera, int width, int height, int x, int y, double dx, double dy);

#endif
