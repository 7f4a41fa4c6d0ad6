/* detail.h - what shapes say of a point of their surface beyond the normal: shading normals, surface coordinates, and
 * the textures of their parts. */
#ifndef WORLD_DETAIL_H
#define WORLD_DETAIL_H

#include "world/surface.h"

/* The normal that a shape blends for a completed hit, of unit length, in the world, on the side of the shape's own. False: it
 * blends none. */
bool world_blended_normal(const world *w, const hit *h, pov_vec3 *out);
/* The shading normal of a completed hit: unit, in the world, facing the ray's start. False: it is the geometric one.
 * Only objects with object_info.smooth have another. */
bool world_shading_normal(const world *w, const pov_ray *ray, const hit *h, pov_vec3 *out);
/* The same of up to WORLD_MANY: bit i: out[i] is set. */
uint64_t world_shading_normals(const world *w, const pov_ray *const *rays, hit *const *hits, uint32_t n, pov_vec3 *out);
/* Surface coordinates of a completed hit on a leaf with LEAF_UV: those of its class, else x and y in the world, as in
 * POV-Ray. */
void world_uv(const world *w, const hit *h, double out[2]);
/* Textures of the part of a completed hit: numbers of the leaf's own, and their shares. 0: it has none there. */
uint32_t world_part_textures(const world *w, const hit *h, uint32_t *which, double *share);

#endif
