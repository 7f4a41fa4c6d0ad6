/* guide.h - directions in which much light is likely: those of lamps, which are surfaces that emit much of it. */
#ifndef SHADE_GUIDE_H
#define SHADE_GUIDE_H

#include "base/sequence.h"
#include "world/world.h"

/* How a direction is drawn: by chance as one of the others, by the cosine, or towards a lamp. */
typedef enum guide_kind { GUIDE_EITHER, GUIDE_EVEN, GUIDE_LAMPS } guide_kind;

/* A lamp as seen from a point: the sides of its box that look there, and its share of the directions. */
typedef struct guide_view {
    const pov_box *box;
    double area[3], side[3], whole, share;
    uint32_t lamp;
} guide_view;

/* The lamps above a surface. */
typedef struct guide_views { uint32_t count; guide_view of[WORLD_LAMPS_MAX]; } guide_views;
void guide_find(const world_lamps *lamps, pov_vec3 point, pov_vec3 normal, guide_views *out);

/* Draw a unit direction about the normal at a point: by the cosine, or towards the boxes of lamps that are above the surface,
 * as far as there are some. by: what the ray counts, so that all together are spread by the cosine; of one of each kind,
 * half of that. False: the direction is below the surface, or there is no lamp for it: nothing counts. */
bool guide_draw(const guide_views *all, pov_vec3 point, pov_vec3 normal, sequence_point p, guide_kind kind, pov_vec3 *dir,
                float *by);

#endif
