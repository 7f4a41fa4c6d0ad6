/* shade.h - from a ray to a colour. */
#ifndef SHADE_SHADE_H
#define SHADE_SHADE_H

#include "world/world.h"

#include <povtrace/render.h>
#include <povtrace/trace.h>

/* One thread's tracer: the public opaque type. */
struct pov_tracer {
    const env *env;
    const model *model;
    const world *world;
    walker *walker;
    pov_counts counts;
    bool failed;                 /* memory ended; what was computed since is worth nothing */
    struct media *media;         /* what the ray is in: shade/refract.c */
};

pov_status tracer_create(pov_tracer **out, const model *m, const world *w, pov_error *err);
void tracer_destroy(pov_tracer *t);

/* What is seen along a camera ray. The tracer finds the media that hold its start. */
colour tracer_color(pov_tracer *t, const pov_ray *ray);
/* Counts since the tracer was made, those of its walker included. */
pov_counts tracer_counts(const pov_tracer *t);

#endif
