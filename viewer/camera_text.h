/* camera_text.h - a camera as scene language, to copy a view from the window into a file. */
#ifndef VIEWER_CAMERA_TEXT_H
#define VIEWER_CAMERA_TEXT_H

#include <povtrace/scene.h>

/* `camera { ... }` that reads back as this camera in a file of this dialect. In the course dialect it uses location,
 * look_at, up, right and angle, exact to the last digits but one. Mirrored or skewed cameras, and all in the povray
 * dialect, are written by their vectors, exactly, which make the file one of the povray dialect. `reach` is the
 * distance to look_at, in lengths of the direction. */
void camera_text(const pov_camera *camera, pov_dialect dialect, double reach, char *out, size_t size);

#endif
