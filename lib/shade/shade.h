/* shade.h - from a ray to a colour. */
#ifndef SHADE_SHADE_H
#define SHADE_SHADE_H

#include "query/query.h"
#include "shade/refract.h"

#include <povtrace/render.h>
#include <povtrace/trace.h>

/* A ray on its way, and what it is worth. The picture's value is a sum over all rays that a camera ray leads
 * to, so none waits for another's result: a list of those still to be followed takes the place of recursion. */
typedef struct path {
    coefficient factor;          /* the product of the coefficients on the way here, and of their weights */
    int level;                   /* 1: the camera ray */
    uint32_t lane;               /* whose camera ray it comes from */
    uint32_t spot, above;        /* it starts where surfaces lie on each other: that of t->spots, counted from 1, and its
                                  * sides of them; spot 0: it does not */
    media_span media;            /* what it is in */
    int standing;                /* crossings in a row that did not move the ray: see surface.c */
} path;

/* Paths that are followed in company: of neighbouring camera rays the same way on, at most one of each, ordered by
 * lane. So what a camera ray's paths give is added up in the same order in any company, and alone. */
enum { BATCH_MAX = WORLD_MANY };
typedef struct batch {
    uint32_t count;
    path paths[BATCH_MAX];
    const pov_ray *rays[BATCH_MAX];   /* of the paths: the caller's camera rays, or those in `room` */
    SIMD_ALIGNED pov_ray room[BATCH_MAX];
    struct batch *next;          /* of those that are spare */
} batch;

/* A hit, seen from the ray's start. */
typedef struct surface {
    const path *from;
    const pov_ray *ray;          /* the path's */
    hit *at;
    const plan_look *look;       /* of its material */
    uint32_t spot, above, on;    /* it lies on others: as in a path; which of them it is */
    colour lit;                  /* what it sends along the ray of what the lights send it */
} surface;

/* Loops over lanes run through whole vectors of the processor, without a rest that goes lane by lane. What lies past
 * the end is of earlier surfaces, and nobody looks at it. */
static inline uint32_t lanes_whole(uint32_t n) { return (n + 3) & ~3u; }

/* How surfaces lie towards the rays that meet them, by lane. */
typedef struct geometry {
    approaches to;
    vec_lanes view;              /* the way, unit */
    vec_lanes mirrored;          /* view, mirrored; unit */
    double cosine[BATCH_MAX];    /* between normal and the way back, >= 0 */
} geometry;

/* How lit surfaces answer light, by lane: what plan_look says of them. */
typedef struct SIMD_ALIGNED finishes {
    float red[BATCH_MAX], green[BATCH_MAX], blue[BATCH_MAX], body[BATCH_MAX], phong[BATCH_MAX];
    double dull[BATCH_MAX];
    int64_t power[BATCH_MAX];
} finishes;

/* Rays to one light. */
typedef struct light_rays {
    uint32_t count;
    const pov_ray *rays[BATCH_MAX];
    uint8_t of[BATCH_MAX];       /* lanes of the surfaces that ask for it */
    uint32_t lit_count;
    uint8_t lit[BATCH_MAX];      /* lanes of the surfaces that lights change */
    finishes finishes;
    pov_ray *room;               /* each surface's, whose direction is the current light's: that of t->mirrored, which
                                  * is empty until all lights are done, so that fewer lines of memory are in use */
} light_rays;

/* A batch that waits, and how many media and spots there are behind it; the last of them on top. */
typedef struct wait { batch *paths; size_t media, spots; } wait;
typedef struct spot_stack { spot *items; size_t count, capacity; } spot_stack;
typedef struct wait_stack { wait *items; size_t count, capacity; } wait_stack;

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
    const world_thing *things;
    walker *walker;
    pov_counts counts;
    bool failed;                 /* memory ended; what was computed since is worth nothing */
    interrupt interrupt;
    media_stack media;           /* of the paths being followed and of those that wait */
    media_stack start;           /* those that hold start_org + start_org_lo, when start_known */
    pov_vec3 start_org, start_org_lo;
    bool start_known;
    wait_stack waits;            /* transmitted rays, at most one batch a level */
    spot_stack spots;            /* of paths and of surfaces, in their order */
    pov_ray *fan;                /* the camera's rays, whose directions are in `ways`; NULL: they are in the rays */
    const vec_lanes *ways;
    batch camera;                /* paths of camera rays; what is the same for all of them was set once */
    bool camera_odd, camera_in_media;   /* its paths are not those of all lanes in turn; some hold media */
    batch *now, *mirrored, *passed;   /* being followed, and those that go on from it */
    batch *spare;
    SIMD_ALIGNED hit hits[BATCH_MAX];
    surface surfaces[BATCH_MAX];
    const pov_ray *rays[BATCH_MAX];   /* theirs, in their order, and what these met */
    hit *met[BATCH_MAX];
    geometry geometry;           /* of the surfaces, in their order */
    light_rays light_rays;
};

pov_status tracer_create(pov_tracer **out, const model *m, const world *w, pov_error *err);
void tracer_destroy(pov_tracer *t);

/* What is seen along a camera ray. The tracer finds the media that hold its start. */
colour tracer_color(pov_tracer *t, const pov_ray *ray);
/* The same of up to BATCH_MAX that start at one point, which cost less in company when neighbours in the list are
 * neighbours in the picture. ways: their directions, by lane; the rays' own may be written. sound: all have directions for
 * certain, as raygen_aim() says. */
void tracer_fan(pov_tracer *t, pov_ray *rays, const vec_lanes *ways, uint32_t n, bool sound, colour *out);
/* Counts since the tracer was made, those of its walker included. */
pov_counts tracer_counts(const pov_tracer *t);
/* From now on ask while tracing whether to give up; after a yes t->interrupt.given_up holds, and what
 * tracer_color() gives is worth nothing. */
void tracer_set_interrupt(pov_tracer *t, bool (*ask)(void *user), void *user);

/* For this room, after so many rays: is it time to give up? */
bool tracer_gives_up(pov_tracer *t, uint32_t rays);

#endif
