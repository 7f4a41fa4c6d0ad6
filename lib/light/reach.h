/* reach.h - where on a line a light can shine. */
#ifndef LIGHT_REACH_H
#define LIGHT_REACH_H

#include "model/light.h"

/* Shorten lo..hi, parameters of from + t dir with a unit direction, to where light of a spotlight or a cylinder can be.
 * False: it is nowhere there. */
bool light_reach(const light *l, pov_vec3 from, pov_vec3 dir, double *lo, double *hi);

#endif
