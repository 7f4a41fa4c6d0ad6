/* camera_wide.h - cameras whose rays are found one by one, from angles. */
#ifndef RENDER_CAMERA_WIDE_H
#define RENDER_CAMERA_WIDE_H

#include "render/camera.h"

/* Unit vectors along right, up and direction, and their lengths. */
typedef struct camera_basis { pov_vec3 right, up, view; double width, height, depth; const pov_camera *camera; } camera_basis;

/* A ray through (u, v): its direction, of any length above 0, and its start relative to the camera's place, which is 0
 * before. False: the picture is black there. */
typedef bool camera_ray(const camera_basis *b, double u, double v, pov_vec3 *dir, pov_vec3 *start);

camera_basis camera_basis_of(const pov_camera *camera);
unsigned camera_aim_each(camera_ray *find, const pov_camera *camera, const raygen_screen *through, uint32_t n, pov_ray *rays);

static inline double camera_length(pov_vec3 v) { return pov_dot(v, pov_unit(v)); }

/* x right + y up + z view. */
static inline pov_vec3 camera_combine(const camera_basis *b, double x, double y, double z)
{
    return pov_add(pov_add(pov_scale(b->right, x), pov_scale(b->up, y)), pov_scale(b->view, z));
}

#endif
