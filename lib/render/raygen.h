/* raygen.h - from a pixel to a ray. */
#ifndef RENDER_RAYGEN_H
#define RENDER_RAYGEN_H

#include "world/world.h"

/* The ray of a camera through pixel (x, y) of a picture, row 0 at the top; (dx, dy) is the place within the
 * pixel, from its top left corner: (1/2, 1/2) is the centre. The direction is as long as it comes, for
 * rounding it to a unit vector would only add an error. */
pov_ray raygen_ray(const pov_camera *camera, int width, int height, int x, int y, double dx, double dy);

/* The same of many rays at once: the places they go through, by lane. */
enum { RAYGEN_MANY = 64 };
typedef struct raygen_places {
    int x[RAYGEN_MANY], y[RAYGEN_MANY];
    double dx[RAYGEN_MANY], dy[RAYGEN_MANY];
} raygen_places;

/* Rays that start at the camera and do not yet know where to. */
void raygen_begin(const pov_camera *camera, pov_ray *rays, uint32_t n);
/* Only the directions of rays that raygen_begin() made; n <= RAYGEN_MANY. True: all are directions for certain, neither
 * zero nor without end. */
bool raygen_aim(const pov_camera *camera, int width, int height, const raygen_places *through, uint32_t n,
                pov_ray *rays);

#endif
