/* swept.h - an outline swept along an axis: straight, or from the origin as a cone. What lies between two heights.
 *
 * A line is inside the sweep between pairs of its crossings with the outline, and between the two planes in one interval.
 * The solid is the intersection of these, so there is no rim for a ray to slip through. */
#ifndef COMMON_SWEPT_H
#define COMMON_SWEPT_H

#include "common/narrow.h"
#include "common/outline.h"

typedef struct common_swept {
    common_outline outline;
    pov_two lo, hi;              /* heights, in the space of the ray */
    uint32_t axis;               /* 1: the outline is in x and z, swept along y; 2: in x and y, along z */
    uint32_t first;              /* the number of its first feature: two caps, then a feature a piece */
    bool conic, open;
    bool upward;                 /* the front of both caps is above */
    bool turned;                 /* the front of a piece is to the left of its way, else to the right */
    pov_vec3 least, most;        /* its box */
} common_swept;

/* To be called last. */
void common_swept_close(common_swept *s);
/* The box of it all, in the space of the ray. */
void common_swept_bounds(const common_swept *s, pov_vec3 *lo, pov_vec3 *hi);
/* `room` holds three crossings a piece. False: no more crossings are wanted. */
bool common_swept_intersect(const common_swept *s, const pov_ray *ray, const common_ray *k, common_cross *room,
                            pov_hits *hits);
/* The same of a ray that comes near its box. */
bool common_swept_cross(const common_swept *s, const pov_ray *ray, const common_entry *e, common_cross *room, pov_hits *hits);
/* Of rays at the box of one that is no cone, or well away from its apex. */
common_look common_swept_look;
bool common_swept_may_look(const common_swept *s);
/* First crossings of rays at its box, as common_swept_cross() reports them; of none that is open. */
void common_swept_first(const common_swept *s, const common_entries *restrict l, common_first_crossings *restrict out);
bool common_swept_inside(const common_swept *s, pov_two3 point);
/* Of a crossing of this sweep. */
void common_swept_normal(const common_swept *s, pov_vec3 dir, const pov_mark *mark, pov_vec3 *out);
/* Is the front the inner side? */
bool common_swept_reversed(const common_swept *s, pov_vec3 dir, const pov_mark *mark);

#endif
