/* area_view.h - what may hide an area light from a surface: elsewhere on the area no shadow rays are needed. */
#ifndef SHADE_AREA_VIEW_H
#define SHADE_AREA_VIEW_H

#include "query/query.h"
#include "shade/area_ring.h"
#include "shade/shading.h"

/* A part of the light's grid that something may hide, and the solid that does, where that is known; hides: it certainly does, or if it is
 * of a tree, where no other shadow of that may lie. */
typedef struct area_shadow {
    grid_part part;
    bool outlined, hides;
    bool dims, leaves;           /* what crosses it is dimmed alike; and all rays start on it and cross it as often */
    uint32_t tree;
    bool unaided;                  /* what hides does so whatever else is of the tree */
    uint32_t ring;               /* not 0: which of the view's, from one on */
    area_cover cover;            /* if it is outlined */
} area_shadow;

/* dark: something hides all of the light. Of more rings nothing is told but their boxes. */
enum { AREA_VIEW_MAX = 6, AREA_RINGS_MAX = 2 };
typedef struct area_view { bool dark; uint32_t count, rings; area_shadow shadows[AREA_VIEW_MAX]; area_ring ring[AREA_RINGS_MAX]; } area_view;

/* Where it is seen from: at a completed hit, with the geometric normal there, unit, which faces the ray's start, on coincident surfaces or
 * NULL. */
typedef struct area_start { const hit *at; pov_vec3 normal; const coincident_set *on; } area_start;
/* to: the direction to the light's position. */
void area_view_find(const shading *scene, const scene_light *from, const area_start *start, pov_vec3 to, area_view *out);

/* Parts of the grid, bit by bit: those that something may hide, those that nothing hides for certain, and of the first some whose light is
 * dimmed alike. */
typedef struct area_states { uint64_t open, lit, alike; } area_states;
area_states area_view_open(const area_view *v, const area_parts *parts);

#endif
