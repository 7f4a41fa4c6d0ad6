/* normal.h - surface normals that patterns perturb. */
#ifndef TEXTURE_NORMAL_H
#define TEXTURE_NORMAL_H

#include "texture/texture.h"

/* A blend of textures, and those around it: their transformations take the normals of members along. */
typedef struct normal_blend { const pattern *pattern; const struct normal_blend *around; } normal_blend;

/* Unit normals of n points, of the world; they are the surface's turned against the rays, and are replaced by those
 * that are bent. The points know their surface. around: the blends that the texture is a member of, or NULL. */
void normal_eval(const model *m, const normal_node *of, const normal_blend *around, const texture_points *points,
                 uint32_t n, vec_lanes *normal);

/* normal += amount * bump. */
void normal_add(const vec_lanes *bump, double amount, uint32_t n, vec_lanes *normal);

#endif
