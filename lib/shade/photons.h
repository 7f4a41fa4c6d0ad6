/* photons.h - the photons of a scene: what they are sent to, which light they take the place of, and their maps. */
#ifndef SHADE_PHOTONS_H
#define SHADE_PHOTONS_H

#include "photon/store.h"
#include "shade/context.h"

/* Never changes once it is made, but that maps are made when they are asked for. */
typedef struct photon_scene {
    const env *env;
    uint32_t *target_of;         /* by leaf: the number of its target, from 1 on; 0: it is none */
    photon_target *targets;
    uint32_t *target_flags;      /* of their leaves */
    size_t target_count;
    photon_aims aims;
    bool *blocks;                /* by light, then target: straight light does not go through, because photons do */
    int max_level;
    float bailout;
    photon_store *store;
} photon_scene;

/* Set s->photons if the plan has photons. */
pov_status photons_create(shading *s, pov_error *err);
void photons_destroy(photon_scene *p);

/* The last level of the paths that are traced: of photons, or of rays. */
static inline int photons_max_level(const shade_context *c)
{
    return c->photons_fly ? c->scene->photons->max_level : c->scene->model->max_trace_level;
}
/* Set what blocks shadow rays to this light, until the next call. */
void photons_aim(shade_context *c, size_t which);
/* Is straight light blocked on a shadow ray that crosses these surfaces? Where no photons are collected it is not. */
bool photons_block(const shade_context *c, const pov_ray *ray, const pov_crossing *at, uint32_t count);

#endif
