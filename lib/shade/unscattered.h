/* unscattered.h - rays that go through a solid with light below its surface without being scattered. */
#ifndef SHADE_UNSCATTERED_H
#define SHADE_UNSCATTERED_H

#include "shade/scatter_rays.h"
#include "shade/stack.h"

/* Add the rays behind the solids, of the surfaces that the rays enter. of: NULL, or the layers that they are. */
void unscattered_rays(scattering *to, const surfaces *on, const layer *of);

#endif
