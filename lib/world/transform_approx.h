/* transform_approx.h - transformations before they are composed, in plain doubles with an error bound: accurate enough
 * for the boxes of a tree. */
#ifndef WORLD_TRANSFORM_APPROX_H
#define WORLD_TRANSFORM_APPROX_H

#include "model/transform.h"

/* Maps by lane: rows of the linear part, and the translation. */
enum { APPROX_MANY = 8 };
typedef struct approx_maps {
    double m[3][3][APPROX_MANY], moved[3][APPROX_MANY];
    double size[APPROX_MANY];    /* bound of the rows' lengths; each is off by less than `lost` of it */
    double excluded[APPROX_MANY];   /* bound of the translation's length; it is off by less than `lost` of it */
    double least[APPROX_MANY];   /* inverse of the longest possible row of the inverse */
    double lost;
} approx_maps;

/* Approximate lists of the same kinds. Bit i of the result: the i-th's numbers are moderate, so that it has an
 * inverse. */
unsigned transform_approx(const transform *const *lists, int n, approx_maps *out);
/* A box that holds a transformed box, or the transformed ellipsoid inscribed in it. False: the map is not moderate. */
bool transform_approx_box(const approx_maps *maps, int lane, const pov_box *box, bool round, pov_box *out);

/* Definitely: a sphere does not stay a sphere; an axis-aligned box does not stay one. */
bool transform_is_uneven(const transform *list);
bool transform_is_turned(const transform *list);

#endif
