/* worker.h - one thread's part in a job: a tracer, and the claimed tile. */
#ifndef RENDER_WORKER_H
#define RENDER_WORKER_H

#include "render/cells.h"
#include "render/sample.h"
#include "render/settings.h"
#include "render/tiles.h"
#include "shade/tracer.h"
#include "shade/window.h"

/* The work that a worker has claimed: a pass over a tile, with the job's settings at that moment. */
typedef struct claim {
    uint64_t generation;         /* number of the job's restarts: a tile from before a restart is dropped */
    pov_camera camera;
    size_t tile;
    int pass;
    pov_rect rect;               /* of the tile, relative to the crop's corner */
    lattice lattice;
    bool refining;               /* more samples of each cell, not the first of a lattice */
} claim;

typedef struct meter meter;             /* meter.h */

typedef struct worker {
    pov_job *job;
    size_t number;               /* of its thread */
    pov_tracer *tracer;          /* NULL until the first tile */
    claim claim;
    float *pixels;               /* of the tile, row by row */
    refinement *refinement;      /* the job's to make and free; NULL when a pixel has one sample */
    windows *windows;            /* of the tile's first samples; NULL until some lend */
    bool lends;                  /* they do */
    meter *meter;                /* the job allocates and frees it; NULL: not requested */
    pov_counts counted;          /* counts of the tracer that earlier tiles have already added */
    double spent, asked;         /* seconds of its thread that were already added, and when that was */
    struct worker *next_free;    /* next in the job's list of idle workers */
} worker;

/* False: no memory. */
bool worker_make(worker *w, pov_job *job, const env *e, int tile_edge);
void worker_free(worker *w, const env *e);
/* Make the tracer if there is no working one; `ask` is called while tracing: is the claim still valid? */
pov_status worker_prepare(worker *w, const shading *scene, bool (*ask)(void *worker), pov_error *err);
/* Tell the tracer how far pixels of the claim's camera are apart. */
void worker_set_pixel(worker *w, const settings *s);
/* Trace one sample of each pixel of the claimed lattice. False: given up. tracer->failed tells that memory ended. */
bool worker_trace(worker *w, const settings *s);
bool worker_is_given_up(const worker *w);
/* Counts of rays since the last call. */
pov_counts worker_count(worker *w);

void counts_add(pov_counts *sum, const pov_counts *more);

#endif
