/* area_light.h - light from many points: the shadows of an area, and what it gives. */
#ifndef SHADE_AREA_LIGHT_H
#define SHADE_AREA_LIGHT_H

#include "shade/lighting.h"

/* As shadow_trace() for all points of an area light, weighted; where radiosity gathers light for one of them. */
uint64_t area_trace(lighting *l, const scene_light *from, const light_lanes *in, colour *through);
/* What an area light would give if it were not occluded: the mean over its points. */
void area_reflect(lighting *l, const scene_light *from, light_sample *s, const light_lanes *middle, uint32_t n);

#endif
