/* object_box.h - the boxes of single objects, for rays that are aimed at them. */
#ifndef WORLD_OBJECT_BOX_H
#define WORLD_OBJECT_BOX_H

#include "world/instance.h"
#include "world/world.h"

/* A box around the object that a leaf belongs to, but for roundings. False: it is infinite. */
bool world_object_box(const world *w, uint32_t leaf, pov_box *out);
/* Around a box in the space of an instance, but for roundings. */
void world_box_of_own(const instance_xform *x, const pov_box *own, pov_box *out);

#endif
