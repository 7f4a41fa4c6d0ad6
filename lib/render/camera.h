/* camera.h - the kinds of cameras: from places on the screen to rays. One row of a table, and one file, each. */
#ifndef RENDER_CAMERA_H
#define RENDER_CAMERA_H

#include "render/raygen.h"

typedef struct camera_class {
    /* Start and direction of rays that raygen_begin() has made; n <= RAYGEN_MANY. Returns what is known of all of them:
     * TRACER_SOUND and the like. */
    unsigned (*aim)(const pov_camera *camera, const raygen_screen *through, uint32_t n, pov_ray *rays);
    /* Where the camera's normal is looked up for the place (u, v); NULL: there. */
    void (*look_up)(const pov_camera *camera, double u, double v, double *x, double *y);
} camera_class;

/* The row of camera->type. */
const camera_class *camera_class_of(const pov_camera *camera);

extern const camera_class camera_perspective, camera_orthographic, camera_fisheye, camera_ultra_wide, camera_omnimax,
    camera_panoramic, camera_spherical, camera_cylinder, camera_meshes;

/* Rays from the faces of the scene's meshes; those of pixels without a face stay as they are. */
void camera_mesh_cast(const struct camera_mesh *m, const pov_camera *camera, const raygen_screen *through, uint32_t n,
                      pov_ray *rays);

#endif
