/* compile_maps.h - composes the transformations of objects, in the order of the scene: those of several consecutive
 * objects at once. */
#ifndef WORLD_COMPILE_MAPS_H
#define WORLD_COMPILE_MAPS_H

#include "model/node.h"
#include "world/transform_approx.h"

/* Objects are processed in windows, with one bit each. */
enum { COMPILE_WINDOW = 32 };

typedef struct compile_maps {
    const leaf_node *window, *end;
    uint32_t rigid;              /* bit i: the window's i-th cannot absorb its transformations */
    const transform *lists[TRANSFORM_MANY];   /* the last composed lists */
    int list_count, now;         /* index of the present one; many consecutive objects may share it */
    unsigned good;               /* bit i: the i-th has an inverse */
    const transform *approx[APPROX_MANY];     /* the same of rigid objects, approximately */
    int approx_count, approx_now;
    unsigned moderate;           /* bit i: the approximation suffices for the i-th's box */
    approx_maps approx_maps;
    pov_affine maps[TRANSFORM_MANY];
} compile_maps;

void compile_maps_init(compile_maps *k);
/* Begin the next window, with the first COMPILE_WINDOW of n objects. */
void compile_maps_open(compile_maps *k, const leaf_node *first, uint32_t n);
/* An object's composed transformations. NULL: they have no inverse. */
const pov_affine *compile_maps_compose(compile_maps *k, const leaf_node *o);
/* Is it known without composing that an object cannot absorb its transformations, and approximately where it is? */
bool compile_maps_is_approx(compile_maps *k, const leaf_node *o);
/* If so, a box around its transformed box. False: its numbers are not moderate. */
bool compile_maps_box(const compile_maps *k, const leaf_node *o, const pov_box *own, pov_box *out);

#endif
