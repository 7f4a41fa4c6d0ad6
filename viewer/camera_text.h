/* camera_text.h - a camera as scene language, so that what was found in the window can go into the file. */
#ifndef VIEWER_CAMERA_TEXT_H
#define VIEWER_CAMERA_TEXT_H

#include <povtrace/scene.h>

/* `camera { ... }` that reads back as this camera in a file of this dialect. In the course dialect that is by
 * location, look_at, up, right and angle, to the last digits but one; a camera that these cannot say, a mirrored or
 * skewed one, and any in the povray dialect is given by its vectors, exactly, which make a file of the povray dialect.
 * `reach` tells how far ahead look_at goes, in lengths of the direction. */
void camera_text(const pov_camera *camera, pov_dialect dialect, double reach, char *out, size_t size);

#endif
