/* area_view.h - what may hide an area light from a surface: elsewhere on the area no shadow rays are needed. */
#ifndef SHADE_AREA_VIEW_H
#define SHADE_AREA_VIEW_H

#include "query/query.h"
#include "shade/area_cover.h"
#include "shade/shading.h"

/* A part of the light's grid that something may hide, and the solid that does, where that is known; hides: it certainly does, or if it is
 * of a tree, where no other shadow of that may lie. */
typedef struct area_shadow { grid_part part; bool outlined, hides; uint32_t tree; area_cover cover; } area_shadow;

/* dark: something hides all of the light. */
enum { AREA_VIEW_MAX = 6 };
typedef struct area_view { bool dark; uint32_t count; area_shadow shadows[AREA_VIEW_MAX]; } area_view;

/* h: a completed hit; normal: the geometric one there, unit, which faces the ray's start; to: the direction to the light's
 * position. */
void area_view_find(const shading *scene, const scene_light *from, const hit *h, pov_vec3 normal, pov_vec3 to, area_view *out);

/* Of parts of the grid, bit by bit, those that something may hide, and what nothing hides for certain of these. */
uint64_t area_view_open(const area_view *v, const area_parts *parts, uint64_t *lit);

#endif
