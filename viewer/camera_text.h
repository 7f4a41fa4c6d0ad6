/* camera_text.h - a camera as scene language, to copy a view from the window into a file. */
#ifndef VIEWER_CAMERA_TEXT_H
#define VIEWER_CAMERA_TEXT_H

#include <povtrace/scene.h>

/* `camera { ... }` for a person to read and edit: location, right, up, angle and look_at, each to a hundred-thousandth,
 * that of `reach`, the distance to look_at in lengths of the direction. A skewed camera has no such form, nor has one
 * that the dialect cannot say: it is written exactly. */
void camera_text(const pov_camera *camera, pov_dialect dialect, double reach, char *out, size_t size);
/* By its vectors, which read back bit-identical in the povray dialect, and make a file one of it. */
void camera_text_exact(const pov_camera *camera, char *out, size_t size);

#endif
