/* worker.h - one thread's part in a job: a tracer, and the tile that it is at. */
#ifndef RENDER_WORKER_H
#define RENDER_WORKER_H

#include "render/sample.h"
#include "render/settings.h"
#include "render/tiles.h"
#include "shade/tracer.h"

/* What a worker has taken upon itself: a pass over a tile, as the job was at that moment. */
typedef struct claim {
    uint64_t generation;         /* counts the job's restarts: a tile of an older one is dropped */
    pov_camera camera;
    size_t tile;
    int pass;
    pov_rect rect;               /* of the tile, relative to the crop's corner */
    lattice lattice;
    bool refining;               /* more samples of each cell, not the first of a lattice */
} claim;

typedef struct refinement refinement;   /* refine.h */
typedef struct meter meter;             /* meter.h */

typedef struct worker {
    pov_job *job;
    size_t number;               /* of its thread */
    pov_tracer *tracer;          /* NULL until the first tile */
    claim claim;
    float *pixels;               /* of the tile, row by row */
    refinement *refinement;      /* the job's to make and free; NULL when a pixel has one sample */
    meter *meter;                /* the job's to make and free; NULL: nobody asks */
    pov_counts counted;          /* of the tracer's, those that earlier tiles have accounted for */
    double spent;                /* seconds of its thread that have been accounted for */
    struct worker *next_free;    /* in the job's list of those that nobody is using */
} worker;

/* False: no memory. */
bool worker_make(worker *w, pov_job *job, const env *e, int tile_edge);
void worker_free(worker *w, const env *e);
/* Make the tracer if there is none that works; `ask` is asked while tracing whether the claim still holds. */
pov_status worker_prepare(worker *w, const shading *scene, bool (*ask)(void *worker), pov_error *err);
/* Trace one sample of each pixel of the claimed lattice. False: it was given up. Memory that ended shows in
 * tracer->failed. */
bool worker_trace(worker *w, const settings *s);
bool worker_is_given_up(const worker *w);
/* The rays since the last call. */
pov_counts worker_count(worker *w);

void counts_add(pov_counts *sum, const pov_counts *more);

#endif
