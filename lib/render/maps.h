/* maps.h - maps of what the ray through the centre of each pixel meets. */
#ifndef RENDER_MAPS_H
#define RENDER_MAPS_H

#include "render/settings.h"
#include "shade/tracer.h"

/* Is it such a map, and not one of what was rendered? */
static inline bool maps_has(pov_pixels format) { return format >= POV_PIXELS_DEPTH && format <= POV_PIXELS_CERTAINTY; }
size_t maps_bytes(pov_pixels format);
/* Trace the rays of a rectangle within the crop, and write what pov_pixels says. If memory ends, or scene is NULL, all is
 * unknown. */
void maps_read(const shading *scene, const settings *s, const pov_camera *camera, pov_rect rect, pov_pixels format, void *dst,
               size_t stride);

#endif
