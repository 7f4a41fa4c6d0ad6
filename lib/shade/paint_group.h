/* paint_group.h - surfaces of one texture, as the points that it is evaluated at. */
#ifndef SHADE_PAINT_GROUP_H
#define SHADE_PAINT_GROUP_H

#include "shade/surface.h"
#include "texture/texture.h"

/* By lane of the texture. Views and uv are there where the scene asks for them. */
typedef struct paint_group {
    const texture *texture;
    uint32_t count;
    uint8_t lane[BATCH_MAX];        /* those of the surfaces */
    texture_points points;
    texture_part parts[BATCH_MAX];
    linear_map linear[BATCH_MAX];   /* of what is in copies */
} paint_group;

/* The texture of the side that the ray meets. */
const texture *paint_texture_of(const shading *scene, const material *m, const pov_ray *ray, const hit *h);
void paint_group_begin(paint_group *g, const texture *of);
/* What the next lane has of a hit; the caller counts it. */
void paint_group_add_point(paint_group *g, const shading *scene, const hit *h);
void paint_group_add_uv(paint_group *g, const shading *scene, const hit *h);
/* Do textures of the scene lie in spaces of their own? */
static inline bool paint_has_spaces(const model *m) { return m->texture_maps.count > 0 || m->copies.count > 0; }
/* All have been added: take the points from the world to the spaces in which their objects' textures were written, neighbours with
 * one map side by side. object: by lane, where the scene has such spaces. */
void paint_group_enter(paint_group *g, const shading *scene, const uint32_t *object);

#endif
