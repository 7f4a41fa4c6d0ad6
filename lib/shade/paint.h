/* paint.h - what surfaces look like where their textures vary. */
#ifndef SHADE_PAINT_H
#define SHADE_PAINT_H

#include "shade/surface.h"

/* Evaluate the textures of surfaces whose points are known, all surfaces of one material together. */
void paint_surfaces(const shading *scene, surfaces *s);

#endif
