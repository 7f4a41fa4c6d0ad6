/* paint.h - the textures of surfaces at their points. */
#ifndef SHADE_PAINT_H
#define SHADE_PAINT_H

#include "shade/surface.h"
#include "texture/texture.h"

/* What the varying textures of a batch's surfaces are made of. */
typedef struct painted {
    texture_term *terms;         /* room for shading->most_terms of each surface */
    uint32_t *order;             /* their numbers, by surface */
    uint32_t first[BATCH_MAX + 1];   /* of a surface in `order`; those with constant textures have none */
    uint64_t merged;             /* by surface: its terms are as one, which is its appearance; or a flat stack */
    struct stack *stacks;        /* of these, by surface: room for each */
    struct layer_lanes *layered; /* their layers, where they differ by pigments alone; from the top */
} painted;

static inline bool paint_is_merged(const painted *p, uint32_t of) { return p->merged >> of & 1; }

/* False: no memory. */
bool paint_create(painted *p, const shading *scene);
void paint_destroy(painted *p, const env *e);
/* What textures are made of: each of one term at most, which is all of the surface, or as one; some of these of flat stacks; or
 * of several terms. */
typedef enum paint_kind { PAINT_SINGLE, PAINT_STACKS, PAINT_TERMS } paint_kind;
/* Evaluate the varying textures of surfaces with known points and normals. */
paint_kind paint_evaluate(const shading *scene, surfaces *s, painted *p);
/* Is the surface's texture constant, or one term that is all of it? */
bool paint_is_single(const painted *p, uint32_t of);
/* The appearance of a term. */
void paint_appearance(const shading *scene, const surface *s, const texture_term *t, appearance *out);
/* A term's normal, or that of the surface, which faces the ray's start. A perturbed one need not, as in POV-Ray. */
pov_vec3 paint_normal(const surfaces *s, uint32_t lane, const texture_term *t);
/* Set appearances and normals of surfaces that are one term each. */
void paint_surfaces(const shading *scene, surfaces *s, const painted *p);
/* The terms at a completed hit on a varying texture; room for scene->most_terms. Returns their number. */
uint32_t paint_hit(const shading *scene, const pov_ray *ray, const hit *h, texture_term *out);
/* Where light crosses surfaces: completed hits of these rays, up to BATCH_MAX. */
typedef struct light_crossings { const pov_ray *const *rays; const hit *const *hits; uint32_t count; } light_crossings;

/* Filters of surfaces with varying textures, by crossing. */
void paint_filters(const shading *scene, const light_crossings *at, colour *out);
/* Factors of light that surfaces focus, as texture_focus() says, by crossing. */
void paint_focus(const shading *scene, const light_crossings *at, const double *power, double *out);

#endif
