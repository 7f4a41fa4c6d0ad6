#include "render/camera.h"

static const camera_class *const classes[POV_CAMERA_TYPES] = {
    [POV_CAMERA_PERSPECTIVE] = &camera_perspective,
    [POV_CAMERA_ORTHOGRAPHIC] = &camera_orthographic,
    [POV_CAMERA_FISHEYE] = &camera_fisheye,
    [POV_CAMERA_ULTRA_WIDE] = &camera_ultra_wide,
    [POV_CAMERA_OMNIMAX] = &camera_omnimax,
    [POV_CAMERA_PANORAMIC] = &camera_panoramic,
    [POV_CAMERA_SPHERICAL] = &camera_spherical,
    [POV_CAMERA_CYLINDER_1] = &camera_cylinder,
    [POV_CAMERA_CYLINDER_2] = &camera_cylinder,
    [POV_CAMERA_CYLINDER_3] = &camera_cylinder,
    [POV_CAMERA_CYLINDER_4] = &camera_cylinder,
    [POV_CAMERA_MESH] = &camera_meshes,
};

const camera_class *camera_class_of(const pov_camera *camera)
{
    return classes[camera->type];
}
