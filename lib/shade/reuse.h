/* reuse.h - radiosity: what a ray finds counts for the neighbours of its pixel too.
 *
 * The rays of a set (see random.h) start on surfaces x, one each, and end on surfaces y. Where what is seen of y does not
 * depend on the direction, each x that sees y could have found it. So each takes its share of it, weighted by the sum of the
 * densities of all of the set that see y (the balance heuristic): the mean stays the same, and each pixel has the samples
 * of the whole set. After P. Bekaert, M. Sbert and J. Halton, Accelerating path tracing by re-using paths, EGWR 2002. */
#ifndef SHADE_REUSE_H
#define SHADE_REUSE_H

#include "shade/batch.h"
#include "shade/guide.h"
#include "shade/surface.h"

/* What the ray found is its own, or a place that others may see, or the sky. */
enum { REUSE_NOTHING, REUSE_PLACE, REUSE_SKY };

typedef struct reuse {
    /* By index in the sum: where the rays start. */
    vec_lanes start, normal, face;
    pov_ray rays[WORLD_MANY];        /* their origins */
    bool outside[WORLD_MANY];        /* see world_origin_leave() */
    uint64_t sets[WORLD_MANY];       /* 0: it is alone */
    float by[WORLD_MANY];            /* what its own ray counts for it alone */
    bool guided[WORLD_MANY];         /* half of its rays go to lamps */
    double lamps[WORLD_LAMPS_MAX][WORLD_MANY];   /* density of these on their faces */
    uint64_t lamps_seen;             /* by lamp: some have it */
    uint32_t from_object[WORLD_MANY];
    /* By lane of the camera ray: what the ray found. Of what is infinitely far `end` is the direction, a unit vector. */
    uint8_t found[WORLD_MANY];       /* REUSE_... */
    uint32_t object[WORLD_MANY];
    bool out[WORLD_MANY];            /* it came from outside of the object */
    vec_lanes end, end_normal;       /* the normal faces the start */
    struct reuse *next;              /* next of the spare ones */
} reuse;

/* Is there a path whose set may use what others find? */
bool reuse_is_possible(const shade_context *c);
/* Note where the rays of a batch of gathered samples end, whose sum this is. */
void reuse_note(const shade_context *c, const surfaces *on, reuse *r);
/* Add what the samples of a complete sum have seen to all that may see it. */
void reuse_spread(shade_context *c, power_sum *sum);

#endif
