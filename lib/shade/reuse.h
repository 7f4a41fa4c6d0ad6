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
    bool below[WORLD_MANY];          /* the ray left below the face: it is its own */
    uint32_t object[WORLD_MANY];
    bool out[WORLD_MANY];            /* it came from outside of the object */
    vec_lanes end, end_normal;       /* the normal faces the start */
    struct reuse *next;              /* next of the spare ones */
} reuse;

/* The starts x of a set, from .. to - 1, and a place y. By start: what y counts there, by area of y, which is the product of the
 * cosines at x and y over pi and the square of the distance; and how densely rays from x would meet y. */
typedef struct weights {
    uint32_t from, to;
    pov_vec3 at, normal;
    uint8_t found;               /* REUSE_PLACE or REUSE_SKY */
    uint32_t object;
    bool out;                    /* rays come to it from outside of the object */
    double kernel[WORLD_MANY], density[WORLD_MANY];
    double x[WORLD_MANY], y[WORLD_MANY], z[WORLD_MANY];   /* from start to place */
    double facing[WORLD_MANY];   /* the cosine at the place, times the distance */
} weights;

/* Starts of a set that lie on one plane side of an object: the corners of a rectangle around them. */
typedef struct flat { pov_vec3 normal, corner[4]; uint32_t object; bool outside; uint64_t lanes; } flat;
enum { FLATS_MAX = 4 };
typedef struct flats { uint32_t count; flat of[FLATS_MAX]; } flats;

/* Rays to a place, each for some lanes of its weights. */
typedef struct asking { uint32_t count; const pov_ray *rays[WORLD_MANY]; weights *of[WORLD_MANY]; uint64_t lanes[WORLD_MANY]; } asking;

/* By start, those that lie so near that one of them, drawn by chance, asks for all; NULL: each asks. */
typedef struct sharing { const uint64_t *alike; uint64_t bits; } sharing;

/* Note the n-th start, which is origin i of a batch, and the lamps above it. */
void reuse_put(reuse *r, uint32_t n, const batch *from, uint32_t i, const guide_views *above, uint32_t lamps);
void reuse_find_flats(const reuse *r, uint32_t from, uint32_t to, flats *out);
/* Add parts of other sets, without their lanes; those that lie on one plane side are one. */
void reuse_join_flats(const flats *some, flats *out);
/* Begin with the place that the ray of a lane has found. */
void reuse_begin(const reuse *r, uint32_t lane, weights *w);
/* Kernels of the starts from .. to - 1 as if nothing lay before the place. */
void reuse_find_kernels(const reuse *r, weights *w);
/* Of joined parts keep those of which one look tells that nothing lies before the place. start: where the ray that found it is from. */
void reuse_find_clear(const shade_context *c, const reuse *from, uint32_t start, const flats *joined, const weights *w, flats *out);
/* And the densities. */
void reuse_find_densities(const shade_context *c, const reuse *r, weights *w);
/* The lanes of parts that lie in clear ones. */
uint64_t reuse_lanes_within(const flats *some, const flats *clear);
/* Ask for starts that see the place if nothing is before it, but for `own`, whose ray found it, and for what is known. They are asked by
 * reuse_send(), if not before. False: given up. */
bool reuse_ask(shade_context *c, reuse *r, uint32_t own, uint64_t known, const sharing *s, weights *w, asking *out);
/* Leave no kernels and densities of starts that the place, one for all of them, is hidden from. False: given up. */
bool reuse_send(shade_context *c, asking *a);

/* Is there a path whose set may use what others find? */
bool reuse_is_possible(const shade_context *c);
/* Note where the rays of a batch of gathered samples end, whose sum this is. */
void reuse_note(const shade_context *c, const surfaces *on, reuse *r);
/* Add what the samples of a complete sum have seen to all that may see it. */
void reuse_spread(shade_context *c, power_sum *sum);

#endif
