/* copy.h - copies of a part that is stored once: objects of a class of the host's own, behind leaves and trees.
 *
 * A part has a world of its own. A copy is one object, with an instance transform; the ray that comes to it is in the
 * part's space, and goes through the part's tree. What it crosses has a name for each copy: see model_copy. */
#ifndef WORLD_COPY_H
#define WORLD_COPY_H

#include "plug/shape_class.h"
#include "world/world.h"

typedef struct copy_root {
    const world *of;
    uint32_t name;               /* of what is first in it */
} copy_root;

extern const shape_class copy_class;

#endif
