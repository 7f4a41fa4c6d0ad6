/* coloured.h - surfaces of one material that differ by the colour of an opaque pigment alone: all have one appearance, and the colours
 * stand by lane. */
#ifndef SHADE_COLOURED_H
#define SHADE_COLOURED_H

#include "shade/shading.h"
#include "shade/surface.h"

/* Give all surfaces the first one's appearance, whose pigments and emitted light are there by lane; of: the appearance of their finish,
 * if the scene has it and the other members are its, or that appearance. */
void coloured_set(surfaces *s, const appearance *of);
/* Give the surfaces their pigments; of: the appearance of their finish. False: nothing is done, as they differ by more, or as the
 * scene asks each for what it looks like. */
bool coloured_put(const shading *scene, const appearance *of, const pigment *value, surfaces *s);

#endif
