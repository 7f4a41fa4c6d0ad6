/* surface.h - a ray that meets a surface: what it gives of itself, and the rays that go on from there. */
#ifndef SHADE_SURFACE_H
#define SHADE_SURFACE_H

#include "shade/shade.h"

/* A hit, seen from the ray's start. */
typedef struct surface {
    const hit *at;
    const material *material;
    pov_vec3 view;               /* unit direction of the ray */
    pov_vec3 normal;             /* unit, turned towards the ray's start */
    pov_vec3 mirrored;           /* view, mirrored; unit */
    double cosine;               /* between normal and the way back, >= 0 */
    float opacity;
} surface;

/* The rays that go on from a hit. */
typedef struct branches { bool reflects, transmits; path reflected, transmitted; } branches;

/* What the surface sends along the ray by itself, without the rays that go on. */
colour surface_meet(pov_tracer *t, const path *p, hit *h, branches *next);

#endif
