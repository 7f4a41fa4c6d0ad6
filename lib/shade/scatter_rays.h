/* scatter_rays.h - rays that go on from surfaces, one by one: what those of one surface and those of layers share. */
#ifndef SHADE_SCATTER_RAYS_H
#define SHADE_SCATTER_RAYS_H

#include "shade/batch.h"
#include "shade/refract.h"
#include "shade/surface.h"

/* Limits that cut rays off, and the numbers of rays cut off. */
typedef struct limits {
    int level, straight_level;   /* rays that go straight on keep their level */
    float weight;
    uint64_t cut_depth, cut_weight;
} limits;

/* What few scenes have: interiors of these kinds, fog, alpha, rays, not photons, that do not see all surfaces. Loops are compiled for
 * none of these, too. single: no surface sends two reflected paths, or two transmitted ones. */
typedef struct rarities { bool fading, dispersion, dims, alpha, hidden, single; } rarities;

/* Rays that continue from a batch's surfaces: source, targets, and limits. */
typedef struct scattering {
    shade_context *context;
    const surfaces *on;
    batch_queue *queue;
    limits limits;
    rarities has;
    uint64_t reflected, transmitted;   /* numbers of them */
} scattering;

/* Interfaces that refracted rays cross, and their new directions. */
typedef struct interfaces {
    refraction_lanes to;
    const vec_lanes *normal;     /* facing the ray's start: the shading normals, unless a perturbed one does not */
    const double *cosine;
    vec_lanes facing;            /* memory for these */
    double sizes[BATCH_MAX];
} interfaces;

/* Begin with a batch's surfaces, and count its rays in the end. */
scattering scatter_begin(shade_context *c, const surfaces *on, batch_queue *q);
void scatter_count(const scattering *to);

/* ---- the ray of lane i, whose surface is s, by a coefficient ---- */

/* Reflected; where the colour that is seen in the mirror is raised to a power; and totally reflected. */
void scatter_reflect(scattering *to, const surface *s, uint32_t lane, const coefficient *by);
void scatter_reflect_power(scattering *to, const surface *s, uint32_t lane, const coefficient *by, float exponent);
void scatter_reflect_inside(scattering *to, const surface *s, uint32_t lane, const coefficient *by);
/* Straight on, and through an interface. */
void scatter_transmit(scattering *to, const surface *s, uint32_t lane, const coefficient *by);
void scatter_cross(scattering *to, const interfaces *p, const surface *s, uint32_t lane, const coefficient *by);

void scatter_find_interfaces(const shade_context *c, surfaces *on, interfaces *p);
/* Is light totally reflected, and what is left of it then? */
bool scatter_is_shut(const scattering *to, const interfaces *p, const surface *s, uint32_t lane);
coefficient scatter_shut_by(const scattering *to, const surface *s, uint32_t lane, const coefficient *filter);

#endif
