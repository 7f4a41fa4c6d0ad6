/* area_view.h - what may hide an area light from a surface: elsewhere on the area no shadow rays are needed. */
#ifndef SHADE_AREA_VIEW_H
#define SHADE_AREA_VIEW_H

#include "query/query.h"
#include "shade/shading.h"

/* Parts of the light's grid that something may hide; dark: something hides all of it. */
enum { AREA_VIEW_MAX = 6 };
typedef struct area_view { bool dark; uint32_t count; grid_part hidden[AREA_VIEW_MAX]; } area_view;

/* h: a completed hit; normal: the geometric one there, unit, which faces the ray's start; to: the direction to the light's
 * position. */
void area_view_find(const shading *scene, const scene_light *from, const hit *h, pov_vec3 normal, pov_vec3 to, area_view *out);

static inline bool area_view_has(const area_view *v, const grid_part *place)
{
    for (uint32_t i = 0; i < v->count; i++)
        if (grid_parts_overlap(&v->hidden[i], place))
            return false;
    return true;
}

#endif
