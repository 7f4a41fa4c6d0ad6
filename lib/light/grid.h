/* grid.h - the points of area lights, which shadows are tested against. */
#ifndef LIGHT_GRID_H
#define LIGHT_GRID_H

#include "base/env.h"
#include "light/light.h"

/* A point of the grid: its place along both axes, -1/2 to 1/2 between the ends, and its weight; the weights add up to 1. */
typedef struct grid_point { double u, v; float weight; } grid_point;

/* A rectangle of places along both axes. */
typedef struct grid_part { double lo[2], hi[2]; } grid_part;

static inline bool grid_parts_overlap(const grid_part *a, const grid_part *b)
{
    return a->lo[0] <= b->hi[0] && b->lo[0] <= a->hi[0] && a->lo[1] <= b->hi[1] && b->lo[1] <= a->hi[1];
}

/* Where points move by the lit point, each lies anywhere in its cell, and is rounded off to a disc then. */
typedef struct light_grid {
    bool moves;                  /* places depend on the lit point: grid_origin() is not for these */
    bool rounded;
    double cell[2];              /* widths of the cells along the axes; 0: points stay where they are */
    float sum;                   /* of the weights, added one after the other */
    grid_part all;               /* the places of all points */
    uint32_t count;
    grid_point points[];
} light_grid;

/* Where the k-th point is, or may move to. */
grid_part grid_place(const light_grid *g, uint32_t k);
/* The axes that places are measured along, for the direction from a point to the light's position. */
void grid_axes(const light *l, pov_vec3 to, pov_vec3 axes[2]);

/* soft: the area is lit all over, and the points are a few of it, by chance, instead of those that the scene says. NULL:
 * no memory. */
light_grid *grid_create(const env *e, const light *l, bool soft);
/* Draws of points that move: those for shadows, or those whose light is reflected, or scattered. */
enum { DRAW_SHADOWS, DRAW_REFLECTED, DRAW_SCATTERED };
/* Directions to points of the grid by lane, one for each, where `to` are those to the light's position; and if `ends` is not NULL the
 * places that they are rounded to. Points that jitter lie where the bits of the lit point say, otherwise for each draw; those that turn
 * lie in a plane across the direction. */
void grid_aim(const light *l, const light_grid *g, const uint32_t *k, uint32_t draw, const light_points *at, const vec_lanes *to, vec_lanes *dir,
              light_origin *ends);
/* A point that is drawn by the weights, neighbours by neighbouring numbers; 0 <= u < 1. */
uint32_t grid_draw(const light_grid *g, double u);
/* Where the k-th point of a grid that does not move is. */
light_origin grid_origin(const light *l, const light_grid *g, uint32_t k);

#endif
