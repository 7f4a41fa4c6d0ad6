/* lighting.h - direct lighting of surfaces. */
#ifndef SHADE_LIGHTING_H
#define SHADE_LIGHTING_H

#include "shade/brdf.h"
#include "shade/stack.h"

/* The lighting of a batch's surfaces, and its rays to one light. */
typedef struct lighting {
    shade_context *context;
    surfaces *on;
    bool glossy;                 /* with highlights */
    uint32_t count;
    const pov_ray *rays[BATCH_MAX];   /* those to the light, once they are put */
    const vec_lanes *dir;        /* their directions, by lane */
    uint64_t begun;              /* surfaces whose rays have their starts in `own` */
    bool named;                  /* `origin`, `away` and, unless they are sided, `excluded` are those of the surfaces: see lane_rays */
    bool sided;                  /* which sides rays go to is in `side` */
    bool apart;                  /* what is known of the sides that rays go to is in `own` alone */
    uint32_t origin[BATCH_MAX], excluded[BATCH_MAX];
    uint32_t away[BATCH_MAX];    /* bits of the sides to which rays leave the surface's object */
    uint32_t closed[BATCH_MAX];  /* other than 0: the surface is of a closed shape */
    SIMD_ALIGNED int64_t side[BATCH_MAX];
    uint64_t which;              /* lanes of their origin surfaces */
    uint8_t of[BATCH_MAX];       /* the same, in order */
    uint8_t seen[BATCH_MAX];     /* the same of all rays, while some of them are traced */
    finishes finishes;
    struct photon_work *photons; /* memory for the light of photons; NULL: there is none */
    pov_ray *own;                /* one ray for each surface, with the direction to the current light: memory of
                                  * BATCH_MAX rays that is unused until all lights are done */
} lighting;

/* Stacks of layers that are lit at one hit, and what each of their layers reflects, by lane. */
typedef struct lit_stacks {
    finishes finishes[STACK_LEVELS];
    colour_lanes lit[STACK_LEVELS];
    uint32_t levels;
} lit_stacks;

/* The points of its surfaces. */
static inline light_points lighting_points(const lighting *l)
{
    const geometry *g = &l->on->geometry;
    const light_points at = { &g->to.point, &g->to.point_lo, l->on->count };

    return at;
}

/* Put the rays to one light. */
void lighting_put_rays(lighting *l);
/* Find diffuse light and highlights of all visible lights: `lit` of the surfaces. */
void light_gather(lighting *l, shade_context *c, surfaces *on);
/* The same, where some are flat stacks, to each of their layers. */
void light_gather_stacks(lighting *l, shade_context *c, surfaces *on, lit_stacks *out);

#endif
