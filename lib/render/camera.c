#include "render/camera.h"

static const camera_class *const classes[POV_CAMERA_TYPES] = {
    [POV_CAMERA_PERSPECTIVE] = &camera_perspective,
    [POV_CAMERA_ORTHOGRAPHIC] = &camera_orthographic,
};

const camera_class *camera_class_of(const pov_camera *camera)
{
    return classes[camera->type];
}
