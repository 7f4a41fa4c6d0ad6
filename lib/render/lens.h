/* lens.h - focal blur: rays through the points of a lens. */
#ifndef RENDER_LENS_H
#define RENDER_LENS_H

#include "render/raygen.h"

/* Let rays start from points of the lens, a disc across the view. Points in the plane of focus are met as before. */
void lens_spread(const pov_camera *camera, const raygen_screen *through, uint32_t n, pov_ray *rays);

#endif
