/* grid.h - the points of area lights, which shadows are tested against. */
#ifndef LIGHT_GRID_H
#define LIGHT_GRID_H

#include "base/env.h"
#include "light/light.h"

/* A point of the grid: its place along both axes, -1/2 to 1/2 between the ends, and its weight; the weights add up to 1. */
typedef struct grid_point { double u, v; float weight; } grid_point;
typedef struct light_grid { uint32_t count; grid_point points[]; } light_grid;

/* NULL: no memory. */
light_grid *grid_create(const env *e, const light *l);
/* Directions to the k-th point by lane, where `to` are those to the light's position. Points that jitter lie anywhere in
 * their cell of the grid, as the bits of the lit point say; those that turn lie in a plane across the direction. */
void grid_aim(const light *l, const light_grid *g, uint32_t k, const light_points *at, const vec_lanes *to, vec_lanes *dir);
/* Where the k-th point of a grid that neither jitters nor turns is. */
light_origin grid_origin(const light *l, const light_grid *g, uint32_t k);

#endif
