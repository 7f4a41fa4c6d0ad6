/* surface.h - the surfaces that a batch's rays hit. */
#ifndef SHADE_SURFACE_H
#define SHADE_SURFACE_H

#include "shade/context.h"
#include "shade/geometry.h"
#include "shade/path.h"

/* A hit, seen from the ray's start. */
typedef struct surface {
    path *from;
    const pov_ray *ray;          /* the path's */
    hit *at;
    const appearance *appearance;
    uint32_t coincident, above, on;   /* it is coincident with others: as in a path; index within the set */
    colour faded;                /* factor of what it transmits or reflects totally; set if light fades in some solid */
} surface;

typedef struct SIMD_ALIGNED colour_lanes { float red[BATCH_MAX], green[BATCH_MAX], blue[BATCH_MAX]; } colour_lanes;

static inline colour colour_lane(const colour_lanes *l, uint32_t i) { return colour_of(l->red[i], l->green[i], l->blue[i]); }
static inline void colour_lane_put(colour_lanes *l, uint32_t i, colour c)
{
    l->red[i] = c.r;
    l->green[i] = c.g;
    l->blue[i] = c.b;
}
static inline void colour_lane_add(colour_lanes *l, uint32_t i, colour c) { colour_lane_put(l, i, colour_add(colour_lane(l, i), c)); }

/* Surfaces whose reflection depends on the angle, and how, by lane. */
typedef struct SIMD_ALIGNED reflectances {
    double cosine[BATCH_MAX], ratio[BATCH_MAX], falloff[BATCH_MAX];
    float min[3][BATCH_MAX], max[3][BATCH_MAX], color[3][BATCH_MAX], metallic[BATCH_MAX], most[BATCH_MAX];
    int64_t fresnel[BATCH_MAX];
    double course[BATCH_MAX];    /* from min to max */
    float share[BATCH_MAX];      /* of the pigment's colour */
    float by[3][BATCH_MAX];      /* what is reflected */
    float weight[BATCH_MAX];     /* of the ray: its largest component before metal dyes it, as in POV-Ray */
    const appearance *held;      /* what holds at any angle of this one stands in the first lanes; NULL: of none */
    uint32_t held_count, count;
    double last_ratio;           /* of the last interface */
    uint8_t of[BATCH_MAX];       /* the surface */
    bool has_fresnel, has_powers, has_metal;
} reflectances;

typedef struct surfaces {
    SIMD_ALIGNED hit hits[BATCH_MAX];   /* by ray of the batch */
    uint32_t count;
    bool ends;                   /* no path goes on from them: what would be reflected and transmitted is not known */
    bool alike;                  /* all are of one appearance */
    bool shared;                 /* neighbours may be at one hit: the rays from them to a light are one */
    const appearance *coloured;  /* the appearance of their finish, where all are of one but for the pigment and what is emitted, which
                                  * stand below by lane: see coloured.h; or NULL */
    const struct layer_lanes *layered;   /* from the top: of flat stacks that are all of one but for the pigments; see layered.h; or NULL */
    surface at[BATCH_MAX];
    const pov_ray *rays[BATCH_MAX];   /* their rays in the same order, and the hits */
    hit *found[BATCH_MAX];
    colour_lanes lit;            /* light of the sources that they reflect along the rays, in the same order */
    geometry geometry;           /* their appearances in the same order */
    appearance varying[BATCH_MAX];   /* of surfaces whose texture varies */
    colour_lanes pigment, emitted;   /* of coloured ones */
    coefficient reflection[BATCH_MAX], filter[BATCH_MAX];   /* what goes on from those of which it depends on the angle */
    bool dark[BATCH_MAX];
    uint64_t filmed;             /* bit i: the film of surface i is as thick as `film` says */
    double film[BATCH_MAX];
    uint32_t interfaces, last_interface;   /* how many are known, and the last surface that was asked for one */
    uint8_t interface[BATCH_MAX];   /* by surface; see interface.h */
    dielectric_crossing crossing[BATCH_MAX];
    reflectances reflectances;
} surfaces;

/* What goes on from surface i. */
static inline onward surfaces_onward(const surfaces *s, uint32_t i)
{
    const appearance *a = s->at[i].appearance;
    const onward own = { s->reflection[i], s->filter[i], s->dark[i] };

    return a->angular ? own : a->onward;
}

/* Find the surfaces that the batch's rays hit and that need more than their emission. Emission, and the background
 * where rays hit nothing, is added to out. Where there is fog, the paths become what they are behind it. */
void surfaces_find(shade_context *c, surfaces *s, batch *b, colour *out);
struct painted;

/* Complete the points and normals, and the directions and appearances; but where some texture is made of several terms,
 * directions and appearances are left to layers_take(). What their textures are made of: a paint_kind. */
int surfaces_complete(shade_context *c, surfaces *s, struct painted *p);

#endif
