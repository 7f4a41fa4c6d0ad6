/* texture.h - evaluates varying textures at points. */
#ifndef TEXTURE_TEXTURE_H
#define TEXTURE_TEXTURE_H

#include "base/lanes.h"
#include "model/model.h"

/* Points by lane, in double-double, in the space of the object as it was when its texture was written. */
typedef struct texture_points { vec_lanes at, at_lo; } texture_points;

/* The value of a texture at a point. */
typedef struct texture_sample { pigment pigment; } texture_sample;

/* Transform a world point to that space. map NULL: it is the world. */
void texture_point(const inverse_map *map, pov_vec3 point, pov_vec3 point_lo, uint32_t lane, texture_points *out);
/* Evaluate a material's varying texture at n points. */
void texture_eval(const model *m, const material *of, const texture_points *points, uint32_t n, texture_sample *out);

#endif
