/* camera_normal.h - cameras whose rays a normal bends, as it would bend a surface's. */
#ifndef SHADE_CAMERA_NORMAL_H
#define SHADE_CAMERA_NORMAL_H

#include "world/surface.h"

/* Bend the directions of n <= LANES_MAX rays by the scene's camera, which has a normal: at the points (x, y, 0). */
void camera_normal_apply(const model *m, const double *x, const double *y, uint32_t n, pov_ray *rays);

#endif
