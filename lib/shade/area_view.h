/* area_view.h - what may hide an area light from a surface: elsewhere on the area no shadow rays are needed. */
#ifndef SHADE_AREA_VIEW_H
#define SHADE_AREA_VIEW_H

#include "query/query.h"
#include "shade/area_cover.h"
#include "shade/shading.h"

/* Parts of the light's grid that something may hide, and what hides some of it for certain; dark: something hides all of it. */
enum { AREA_VIEW_MAX = 6 };
typedef struct area_view {
    bool dark;
    uint32_t count, cover_count;
    grid_part hidden[AREA_VIEW_MAX];
    area_cover covers[AREA_VIEW_MAX + 1];
} area_view;

/* h: a completed hit; normal: the geometric one there, unit, which faces the ray's start; to: the direction to the light's
 * position. */
void area_view_find(const shading *scene, const scene_light *from, const hit *h, pov_vec3 normal, pov_vec3 to, area_view *out);

/* Of parts of the grid, bit by bit, those that something may hide, and what nothing hides for certain of these. */
uint64_t area_view_open(const area_view *v, const area_parts *parts, uint64_t *lit);

#endif
