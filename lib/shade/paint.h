/* paint.h - what surfaces look like where their textures vary. */
#ifndef SHADE_PAINT_H
#define SHADE_PAINT_H

#include "shade/surface.h"

/* Evaluate the textures of surfaces whose points are known, all surfaces of one material together. */
void paint_surfaces(const shading *scene, surfaces *s);
/* What light that crosses a surface is multiplied by, where its texture varies. The hit's point is known. */
colour paint_filter(const shading *scene, const hit *h);

#endif
