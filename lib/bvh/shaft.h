/* shaft.h - the space that segments from a point to an area pass through, against the boxes of a tree.
 *
 * A shaft is a pyramid. It misses a box if a plane through one of its flanks, or its own box, tells so with more than
 * the errors of all roundings: to say that it may overlap a box is never wrong. */
#ifndef BVH_SHAFT_H
#define BVH_SHAFT_H

#include "bvh/bvh.h"

/* Flanks are planes through `from`, their normals point outward. */
typedef struct shaft {
    pov_vec3 from, corner[4], lo, hi;
    pov_vec3 normal[4];
    double error[4];             /* of the flanks, for a point at a distance of one */
    double size;                 /* of the coordinates that were rounded */
} shaft;

/* corner: the corners of a parallelogram, from `from`, in order around it. False: nothing can be told. */
bool shaft_make(shaft *s, pov_vec3 from, const pov_vec3 corner[4]);
/* The same in another space, where a point of this one is column (p - anchor) + to. */
bool shaft_move(const shaft *s, const pov_vec3 column[3], pov_vec3 anchor, pov_vec3 to, shaft *out);
/* Ask `leaf` of each leaf whose box the shaft may overlap, until it says false: the result then. */
typedef bool shaft_leaf_fn(void *user, const void *leaf, const pov_box *box);
bool shaft_search(const bvh *tree, const shaft *s, shaft_leaf_fn *leaf, void *user);
/* May it overlap the box, whose coordinates are off by a few units in their last places? */
bool shaft_may_overlap(const shaft *s, const pov_box *box);
/* May it overlap a triangle with these corners and this unit normal? touches: it may if it ends or begins on the triangle's plane, too. */
bool shaft_may_overlap_triangle(const shaft *s, const pov_vec3 corner[3], pov_vec3 normal, bool touches);
/* May it overlap the plane normal . p = distance? The normal is a unit vector. */
bool shaft_may_cross(const shaft *s, pov_vec3 normal, double distance);

#endif
