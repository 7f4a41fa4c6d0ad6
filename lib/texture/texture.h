/* texture.h - evaluates varying textures at points. */
#ifndef TEXTURE_TEXTURE_H
#define TEXTURE_TEXTURE_H

#include "base/lanes.h"
#include "model/model.h"

enum { TEXTURE_PARTS_MAX = 8 };  /* as many as a shape may give */

/* Textures of the part of a surface that a point is on: numbers of members of a BLEND_PARTS, and their shares. None, and
 * numbers behind the last: the last member. */
typedef struct texture_part { uint32_t count, which[TEXTURE_PARTS_MAX]; float share[TEXTURE_PARTS_MAX]; } texture_part;

/* Points by lane, and what patterns and normals ask of the surface there. */
typedef struct texture_points {
    vec_lanes at, at_lo;         /* in double-double, in the space of the object as it was when its texture was written */
    vec_lanes uv;                /* u, v, 0 of the surface */
    vec_lanes normal, view;      /* unit, of the world: the surface's normal, turned against the ray; the ray's direction */
    const linear_map *linear[LANES_MAX]; /* of the map from the world to the space of `at`; NULL: it is the world */
    bool in_world;               /* all of them are NULL, and are not set */
    const texture_part *parts;   /* by lane of the whole; for BLEND_PARTS only */
    bool has_surface;            /* normals and linear parts are there */
    bool has_uv, has_view;       /* of those with a surface: and these too */
    bool has_world;              /* of those with a surface: so are the points in the world */
    vec_lanes world;
} texture_points;

/* A part of what a lane's texture is. Its colour is a sum over stacks of layers: share times what the stack returns.
 * A stack's layers follow one another from the top; `first` begins a stack. */
typedef struct texture_term {
    uint8_t lane;
    bool first;
    bool bent;                   /* the normal is not the surface's */
    float share;                 /* of the stack; the shares of a lane's stacks add up to 1 */
    pigment pigment;
    const finish *finish;
    pov_vec3 normal;             /* where it is bent: unit, of the world */
} texture_term;

static inline void texture_point(texture_points *out, uint32_t lane, pov_vec3 point, pov_vec3 point_lo)
{
    lanes_put(&out->at, lane, point);
    lanes_put(&out->at_lo, lane, point_lo);
}
/* Take the points of the lanes from `first` to the one before `end`, at least one, from the world to a space of textures.
 * map NULL: it is the world. */
void texture_points_map(const inverse_map *map, uint32_t first, uint32_t end, texture_points *io);
/* Evaluate a texture at n points; returns the number of terms, at most n times texture_most_terms(). The terms of a lane
 * have the same order alone and beside others. */
uint32_t texture_eval(const model *m, const texture *of, const texture_points *points, uint32_t n, texture_term *out);
uint32_t texture_most_terms(const texture *of);
/* Does some pattern depend on where the surface is seen from? */
bool texture_is_of_view(const texture *of);
/* Does some pattern of it see normals that it perturbs? */
bool texture_sees_bent(const texture *of);
/* Does some pattern ask where in the world points are? */
bool texture_is_of_world(const texture *of);
/* Factors of light that crosses the surface. */
void texture_filters(const model *m, const texture *of, const texture_points *points, uint32_t n, colour *out);
/* Factors of light that the surface focuses (interior { caustics }): the products of those of all layers; of their normals and
 * the way of light, as a power of the cosine, by point. */
void texture_focus(const model *m, const texture *of, const texture_points *points, const double *power, uint32_t n, double *out);
void texture_focus_of(const vec_lanes *normal, const vec_lanes *view, const double *power, uint32_t n, double *out);
/* Evaluate a pigment alone. */
void pigment_eval(const model *m, const pigment_node *of, const texture_points *points, uint32_t n, pigment *out);

#endif
