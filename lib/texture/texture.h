/* texture.h - what varying textures are at points. */
#ifndef TEXTURE_TEXTURE_H
#define TEXTURE_TEXTURE_H

#include "base/lanes.h"
#include "model/model.h"

/* Points by lane, each the sum of two parts, in the space of the object as it stood when its texture was written. */
typedef struct texture_points { vec_lanes at, at_lo; } texture_points;

/* What a texture is at a point. */
typedef struct texture_sample { pigment pigment; } texture_sample;

/* A point of the world in that space. map NULL: it is the world. */
void texture_point(const inverse_map *map, pov_vec3 point, pov_vec3 point_lo, uint32_t lane, texture_points *out);
/* The texture of a material that varies, at n points. */
void texture_eval(const model *m, const material *of, const texture_points *points, uint32_t n, texture_sample *out);

#endif
