/* shade.h - from a ray to a colour. */
#ifndef SHADE_SHADE_H
#define SHADE_SHADE_H

#include "shade/refract.h"
#include "world/world.h"

#include <povtrace/render.h>
#include <povtrace/trace.h>

/* A ray on its way, and what it is worth. The picture's value is a sum over all rays that a camera ray leads
 * to, so none waits for another's result: a list of those still to be followed takes the place of recursion. */
typedef struct path {
    pov_ray ray;
    colour factor;               /* the product of the coefficients on the way here */
    float weight;                /* the product of their largest components */
    int level;                   /* 1: the camera ray */
    int standing;                /* crossings in a row that did not move the ray: see surface.c */
    media_span media;            /* what it is in */
} path;

/* Asking now and then whether to give up, each few milliseconds at most, whatever a ray costs. */
typedef struct interrupt {
    bool (*ask)(void *user);     /* NULL: never */
    void *user;
    bool given_up;
    int left, every;             /* rays until the next question, and from one question to the next */
    double asked;                /* when the last one was */
} interrupt;

/* One thread's tracer: the public opaque type. */
struct pov_tracer {
    const env *env;
    const model *model;
    const world *world;
    const plan *plan;
    walker *walker;
    pov_counts counts;
    bool failed;                 /* memory ended; what was computed since is worth nothing */
    interrupt interrupt;
    media_stack media;           /* of the ray being followed and of those that wait */
    media_stack start;           /* those that hold start_org + start_org_lo, when start_known */
    pov_vec3 start_org, start_org_lo;
    bool start_known;
    path *waiting;               /* transmitted rays, at most one a level: room for all is made at creation */
    int waiting_count;
};

pov_status tracer_create(pov_tracer **out, const model *m, const world *w, pov_error *err);
void tracer_destroy(pov_tracer *t);

/* What is seen along a camera ray. The tracer finds the media that hold its start. */
colour tracer_color(pov_tracer *t, const pov_ray *ray);
/* Counts since the tracer was made, those of its walker included. */
pov_counts tracer_counts(const pov_tracer *t);
/* From now on ask while tracing whether to give up; after a yes t->interrupt.given_up holds, and what
 * tracer_color() gives is worth nothing. */
void tracer_set_interrupt(pov_tracer *t, bool (*ask)(void *user), void *user);

#endif
