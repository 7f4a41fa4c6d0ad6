/* transform_rough.h - what is known of transformations before they are composed, in plain doubles with a bound on what
 * these lose: enough for the boxes of a tree. */
#ifndef WORLD_TRANSFORM_ROUGH_H
#define WORLD_TRANSFORM_ROUGH_H

#include "model/transform.h"

/* Maps by lane: rows of the linear part, and the movement. */
enum { ROUGH_MANY = 8 };
typedef struct rough_maps {
    double m[3][3][ROUGH_MANY], moved[3][ROUGH_MANY];
    double size[ROUGH_MANY];     /* no row is longer; each is off by less than `lost` of it */
    double away[ROUGH_MANY];     /* the movement is no longer; it is off by less than `lost` of it */
    double least[ROUGH_MANY];    /* the inverse of the longest row that the inverse can have */
    double lost;
} rough_maps;

/* Of lists of the same kinds. Bit i of what is returned: the i-th's numbers are moderate, so that it has an inverse. */
unsigned transform_rough(const transform *const *lists, int n, rough_maps *out);
/* A box that holds what becomes of a box, or of the ellipsoid that touches its sides. False: it is not moderate. */
bool transform_rough_box(const rough_maps *maps, int lane, const pov_box *box, bool round, pov_box *out);

/* For certain: a ball becomes none; a box with sides along the axes becomes none. */
bool transform_is_uneven(const transform *list);
bool transform_is_turned(const transform *list);

#endif
