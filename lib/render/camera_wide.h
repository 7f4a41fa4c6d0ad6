/* camera_wide.h - cameras whose rays are found from angles, side by side. */
#ifndef RENDER_CAMERA_WIDE_H
#define RENDER_CAMERA_WIDE_H

#include "base/lanes.h"
#include "render/camera.h"

/* Unit vectors along right, up and direction, and their lengths. */
typedef struct camera_basis { pov_vec3 right, up, view; double width, height, depth; const pov_camera *camera; } camera_basis;

/* Directions of rays, of any length above 0; black: a number other than 0 where the picture is black, and 0 before. */
typedef struct camera_lanes { vec_lanes dir; double black[RAYGEN_MANY]; } camera_lanes;
typedef void camera_directions(const camera_basis *b, const raygen_screen *through, uint32_t n, camera_lanes *out);

camera_basis camera_basis_of(const pov_camera *camera);
/* Rays from the camera's place, in the directions that `find` finds; n is up to RAYGEN_MANY. */
unsigned camera_aim_along(camera_directions *find, const pov_camera *camera, const raygen_screen *through, uint32_t n, pov_ray *rays);

static inline double camera_length(pov_vec3 v) { return pov_dot(v, pov_unit(v)); }

/* x right + y up + z view. */
SIMD_INLINE pov_vec3 camera_combine(const camera_basis *b, double x, double y, double z)
{
    return pov_add(pov_add(pov_scale(b->right, x), pov_scale(b->up, y)), pov_scale(b->view, z));
}

#endif
