/* tracer.h - from a ray to a colour. */
#ifndef SHADE_TRACER_H
#define SHADE_TRACER_H

#include "shade/batch.h"
#include "shade/lighting.h"

/* One thread's tracer: the public opaque type. */
struct pov_tracer {
    shade_context context;
    dielectric_start start;      /* the dielectrics around the camera */
    batch camera;                /* paths of camera rays; what is the same for all of them was set once */
    bool camera_odd, camera_inside;   /* its paths are not those of all lanes in turn; some are in dielectrics */
    batch_queue queue;
    surfaces surfaces;           /* of the batch that is being followed */
    lighting lighting;
};

pov_status tracer_create(pov_tracer **out, const shading *scene, pov_error *err);
void tracer_destroy(pov_tracer *t);

/* What is seen along a camera ray. The tracer finds the dielectrics that hold its start. */
colour tracer_color(pov_tracer *t, const pov_ray *ray);
/* What is known of rays: all have finite starts and directions; all have the same start. */
enum { TRACER_SOUND = 1, TRACER_ONE_START = 2 };
/* The same of n rays, which cost less together when neighbours in the list are neighbours in the picture. */
void tracer_colors(pov_tracer *t, const pov_ray *rays, uint32_t n, unsigned known, colour *out);
/* Counts since the tracer was made, those of its queries included. */
pov_counts tracer_counts(const pov_tracer *t);
/* From now on ask while tracing whether to give up; after a yes context.interrupt.given_up holds, and what
 * tracer_color() gives is worth nothing. */
void tracer_set_interrupt(pov_tracer *t, bool (*ask)(void *user), void *user);

#endif
