/* paint.h - appearances of surfaces with varying textures. */
#ifndef SHADE_PAINT_H
#define SHADE_PAINT_H

#include "shade/surface.h"

/* Evaluate the textures of surfaces with known points, all surfaces of one material together. */
void paint_surfaces(const shading *scene, surfaces *s);
/* Filter of light that crosses a surface with a varying texture. The hit's point is known. */
colour paint_filter(const shading *scene, const hit *h);

#endif
