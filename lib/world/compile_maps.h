/* compile_maps.h - what the transformations of objects come to, in the order of the scene: those of several that follow are
 * composed at once. */
#ifndef WORLD_COMPILE_MAPS_H
#define WORLD_COMPILE_MAPS_H

#include "model/node.h"
#include "world/transform_rough.h"

/* Objects are looked at in windows, a bit each. */
enum { FLAT_WINDOW = 32 };

typedef struct flat_maps {
    const leaf_node *window, *end;
    uint32_t rigid;              /* bit i: the window's i-th cannot absorb its transformations */
    const transform *lists[TRANSFORM_MANY];   /* what was composed last */
    int list_count, now;         /* which of them is meant; many objects in a row may share it */
    unsigned good;               /* bit i: the i-th has an inverse */
    const transform *rough[ROUGH_MANY];       /* the same of rigid objects, roughly */
    int rough_count, rough_now;
    unsigned moderate;           /* bit i: no more need be known for the i-th's box */
    rough_maps rough_maps;
    pov_affine maps[TRANSFORM_MANY];
} flat_maps;

void flat_maps_init(flat_maps *k);
/* The next window, of the first FLAT_WINDOW of n objects. */
void flat_maps_open(flat_maps *k, const leaf_node *first, uint32_t n);
/* An object's composed transformations. NULL: they have no inverse. */
const pov_affine *flat_maps_compose(flat_maps *k, const leaf_node *o);
/* Is it known without, of an object with transformations, that it cannot absorb them, and roughly where it comes to? */
bool flat_maps_look(flat_maps *k, const leaf_node *o);
/* If so, a box around what comes of its own. False: it is far from moderate. */
bool flat_maps_box(const flat_maps *k, const leaf_node *o, const pov_box *own, pov_box *out);

#endif
