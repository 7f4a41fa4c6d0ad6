/* transform_approx.h - what is known of transformations before they are composed, in plain doubles with a bound on what
 * these lose: enough for the boxes of a tree. */
#ifndef WORLD_TRANSFORM_APPROX_H
#define WORLD_TRANSFORM_APPROX_H

#include "model/transform.h"

/* Maps by lane: rows of the linear part, and the movement. */
enum { APPROX_MANY = 8 };
typedef struct approx_maps {
    double m[3][3][APPROX_MANY], moved[3][APPROX_MANY];
    double size[APPROX_MANY];    /* no row is longer; each is off by less than `lost` of it */
    double excluded[APPROX_MANY];   /* the movement is no longer; it is off by less than `lost` of it */
    double least[APPROX_MANY];   /* the inverse of the longest row that the inverse can have */
    double lost;
} approx_maps;

/* Of lists of the same kinds. Bit i of what is returned: the i-th's numbers are moderate, so that it has an inverse. */
unsigned transform_approx(const transform *const *lists, int n, approx_maps *out);
/* A box that holds what becomes of a box, or of the ellipsoid that touches its sides. False: it is not moderate. */
bool transform_approx_box(const approx_maps *maps, int lane, const pov_box *box, bool round, pov_box *out);

/* For certain: a sphere becomes none; a box with sides along the axes becomes none. */
bool transform_is_uneven(const transform *list);
bool transform_is_turned(const transform *list);

#endif
