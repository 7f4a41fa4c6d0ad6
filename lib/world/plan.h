/* plan.h - the needs of a scene: parts that are compiled for it, and parts left out. */
#ifndef WORLD_PLAN_H
#define WORLD_PLAN_H

#include "model/model.h"

typedef struct plan_counts {
    size_t emitting, attenuated; /* lights that are not black; that the atmosphere dims */
    size_t lit;                  /* objects with diffuse light or highlights */
    size_t casting, filtering;   /* objects that cast a shadow; transparent ones of them */
    size_t glossy, metallic, varying, reflective, transparent, refracting, dielectrics, smooth;
    size_t dispersive, fading, located, hidden;
    size_t diffuse;              /* objects that light from everywhere would change */
    size_t filled;               /* objects with media inside */
    size_t fresnel;              /* transparent objects whose mirror could be Fresnel's */
    size_t targets, photon_lights;   /* that photons are sent to, and from */
} plan_counts;

typedef struct plan {
    bool lighting;               /* some light emits, and some surface has diffuse light or highlights */
    bool shadows;                /* ... and some object casts one */
    bool coloured_shadows;       /* ... and some of those is transparent */
    bool highlights, metallic;
    bool smooth;                 /* some shape has shading normals */
    bool textures;               /* some texture varies from point to point */
    bool reflection;
    bool transmission;           /* some surface transmits rays */
    bool refraction;             /* ... into a dielectric of ior other than 1, or one in which light fades */
    bool dispersion;             /* ... whose ior depends on the colour */
    bool fading;                 /* light fades inside some solid */
    bool located;                /* transmittance of light depends on distances and angles */
    bool media;                  /* some media fill some object or the scene */
    bool scattering;             /* ... and scatter the light of some light */
    bool radiosity;              /* diffuse surfaces light each other */
    bool random;                 /* paths take random numbers: the samples of a picture are numbered */
    bool hidden;                 /* some rays do not see some object */
    bool subsurface;             /* light is scattered below some surface */
    bool photons;                /* some light sends photons to some target */
    bool dielectrics_at_start;   /* some dielectric could contain the camera: tested once a picture */
    bool clear_members;          /* nothing tells whether a ray is in a solid that shows nothing of itself: surfaces of members that are
                                  * clear, without an interior, are left out */
    bool opaque_at_start;        /* Fresnel's reflection asks for opaque solids around it too */
    plan_counts counts;
} plan;

/* Derive the needs from the model. */
pov_status plan_make(plan *p, const model *m, pov_error *err);
bool plan_is_solid(const leaf_node *o);
/* Is it a solid that is not hollow? */
bool plan_is_filled(const leaf_node *o);
/* Do the atmosphere or fog dim some light, by where it crosses surfaces? */
bool plan_attenuates(const model *m);
/* Can rays be inside it? Any transparent solid: one without an interior { } is a bubble of ior 1. */
bool plan_is_dielectric(const model *m, const leaf_node *o);

#endif
