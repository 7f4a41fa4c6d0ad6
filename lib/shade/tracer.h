/* tracer.h - from a ray to a colour. */
#ifndef SHADE_TRACER_H
#define SHADE_TRACER_H

#include "shade/batch.h"
#include "shade/layers.h"
#include "shade/lighting.h"
#include "shade/photon_light.h"

/* How many solids without fog and media are around the last start that was asked. */
typedef struct filled_start { pov_vec3 org, org_lo; uint32_t solids; bool known; } filled_start;

/* One thread's tracer: the public opaque type. */
struct pov_tracer {
    shade_context context;
    dielectric_start start;      /* the dielectrics around the camera */
    batch camera;                /* paths of camera rays; their constant members were set once */
    bool camera_odd, camera_inside;   /* its paths are not those of all lanes in order; some are in dielectrics */
    bool camera_white;           /* its paths are those of all lanes, and carry white */
    filled_start filled;
    uint32_t lanes_filled;       /* ... and around the starts of all its paths; UINT32_MAX: they differ */
    sample_id own_samples[BATCH_MAX];   /* of rays that nobody numbered */
    bool counts_followers;       /* more rays may follow than may */
    uint64_t followers[BATCH_MAX];      /* rays that followed, by lane of the camera ray */
    uint64_t follower_batches;   /* their batches */
    batch_queue queue;
    surfaces surfaces;           /* of the present batch */
    painted painted;             /* their textures */
    batch *shadow_rays;          /* memory for the rays to lights from layers */
    layers *layers;              /* chunks of their terms; NULL: no texture has several */
    lit_stacks *stacks;          /* what their layers reflect where they are flat stacks; NULL: there are none */
    lighting lighting;
    photon_work *photons;        /* NULL: there are none */
};

pov_status tracer_create(pov_tracer **out, const shading *scene, pov_error *err);
void tracer_destroy(pov_tracer *t);

/* The colour along a camera ray. The tracer finds the dielectrics that contain its start. */
colour tracer_color(pov_tracer *t, const pov_ray *ray);
/* Known properties of rays: all have finite starts and directions; all have the same start. */
enum { TRACER_SOUND = 1, TRACER_ONE_START = 2 };
/* The same for n rays, which cost less together if neighbours in the list are neighbours in the picture. alpha NULL: the
 * background is opaque; else it is transparent as far as the scene says, and alpha receives how much of it each hides.
 * samples: which ones they are, if plan->random; NULL: their bits decide. */
void tracer_colors(pov_tracer *t, const pov_ray *rays, uint32_t n, unsigned known, const sample_id *samples, colour *out,
                   float *alpha);
/* Begin paths of n valid rays that carry these colours: photons. */
void tracer_begin(pov_tracer *t, const pov_ray *rays, uint32_t n, const colour *carried);
/* Trace the rays of a batch, and all that follow from them. */
void tracer_follow(pov_tracer *t, batch *b, colour *out);
/* For photons: how far apart rays of neighbouring pixels start, how much farther apart they are for each unit of their length,
 * the screen or NULL, and the seed. All are 0 before. */
void tracer_set_pixel(pov_tracer *t, double width, double slope, const struct photon_screen *screen, uint32_t seed);
/* What a tracer that failed has to say. */
pov_status tracer_error(const pov_tracer *t, pov_error *err);
/* Counts since the tracer was made, including those of its queries. */
pov_counts tracer_counts(const pov_tracer *t);
/* Set a callback that is asked for an interrupt while tracing; after a yes context.interrupt.given_up holds, and the
 * results of tracer_color() are invalid. */
void tracer_set_interrupt(pov_tracer *t, bool (*ask)(void *user), void *user);

#endif
