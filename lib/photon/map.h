/* map.h - photons where they arrived, and the light that they make on surfaces and in media.
 *
 * A photon's light is spread over a disc around it, by one of two kernels. Discs are small where photons
 * are dense: those of one leaf of the tree reach as far as the n-th nearest photon from its middle. What each disc holds is
 * the photon's light, so no light is lost but at the edges of surfaces. In media discs lie across the ray that looks. */
#ifndef PHOTON_MAP_H
#define PHOTON_MAP_H

#include "base/env.h"
#include "base/simd.h"
#include "model/colour.h"
#include "photon/view.h"

static const uint32_t photon_free = UINT32_MAX;

typedef struct photon {
    pov_vec3 at;
    colour flux;
    float dir[3];                /* it flew in this direction, unit */
    float normal[3];             /* of the surface, towards where it came from */
    uint32_t within;             /* the solid that it met from within, and lights alone; or photon_free */
} photon;

/* With u = (d/r)^2: Silverman's (1 - u)^2, which blurs what curves; and (1 - u)^2 (20/3 (1 - u) - 4), whose second moment is
 * zero: it is below zero from u = 0.4 on, and blurs no light but what differs from a polynomial of the third degree. See
 * docs/light.md. */
typedef enum photon_kernel { PHOTON_SMOOTH, PHOTON_SHARP } photon_kernel;

/* A node of the tree, in the order of a traversal: `skip` is the next one that is not below it. */
typedef struct photon_node {
    pov_box box;                 /* of all discs below it */
    uint32_t skip, first, count; /* photons of a leaf, first a multiple of PHOTON_LANES; count 0: it is none */
} photon_node;

/* What lookups ask first of the photons of a leaf, in lanes; those behind the last one are nowhere. */
enum { PHOTON_LANES = 8 };
typedef struct photon_block {
    SIMD_ALIGNED double at[3][PHOTON_LANES];
    float normal[3][PHOTON_LANES];
    double radius;               /* of all its discs */
} photon_block;

typedef struct photon_map {
    photon *photons;             /* by leaf: all but the last one are full */
    uint32_t count, node_count;
    photon_kernel kernel;
    photon_node *nodes;
    photon_block *blocks;        /* by leaf */
} photon_map;

/* Make a map of these photons, which becomes the map's: from env_alloc(). nearest: how many photons a disc reaches. False:
 * no memory, and the photons are freed. */
bool photon_map_make(photon_map *out, const env *e, photon *photons, uint32_t count, uint32_t nearest,
                     photon_kernel kernel);
void photon_map_free(photon_map *m, const env *e);
/* Call visit for each photon whose disc holds a point of a surface with this normal on either side, with the light that
 * it brings there per area: its flux times `density`. Smaller discs count as of the radius `least`. The order is that of
 * the map. */
typedef void photon_visit(void *user, const photon *p, float density);
void photon_map_find(const photon_map *m, pov_vec3 at, pov_vec3 normal, double least, photon_visit *visit, void *user);
/* The same for the mean over a cell of the screen: photons whose discs are smaller than a pixel count if they are seen in
 * the cell, and no others of the kind. */
void photon_map_count(const photon_map *m, pov_vec3 at, pov_vec3 normal, const photon_cell *cell, photon_visit *visit, void *user);
/* The same of photons in media for those that a ray passes within their radius, on its first `length`: direction unit.
 * Theirs is light times the length of way that they stand for, and comes per area across the ray. `at`: how far along the
 * ray the photon is. The least radius is `least` at the start, and grows by `slope` along the ray; or if there is a cell, photons with
 * narrow discs count that are seen in it, and no others of the kind. */
typedef struct photon_ray { pov_vec3 from, dir; double length, least, slope; const photon_cell *cell; } photon_ray;
typedef void photon_pass(void *user, const photon *p, double at, float density);
void photon_map_follow(const photon_map *m, const photon_ray *ray, photon_pass *pass, void *user);

#endif
