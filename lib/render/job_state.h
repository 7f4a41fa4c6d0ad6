/* job_state.h - the inside of a job, for the files that move it on (job.c) and that watch and steer it
 * (watch.c). */
#ifndef RENDER_JOB_STATE_H
#define RENDER_JOB_STATE_H

#include "base/thread.h"
#include "render/frame.h"
#include "render/job.h"
#include "render/refine.h"
#include "render/settings.h"
#include "render/worker.h"

/* A pass of first samples. Threads may be tiles ahead in the next one when its last tile comes, so that each has its own
 * account: what is said of it does not depend on them. */
typedef struct lattice_pass {
    size_t tiles;                /* that are in */
    pov_counts counts;
} lattice_pass;

/* A pool of threads is a loop of steps, and so is a program that steps by itself: each borrows a worker, and
 * the worker claims a tile, traces it and commits it. */
struct pov_job {
    const env *env;
    const shading *scene;
    settings settings;
    tiles tiles;
    encoding encoding;
    size_t all_pixels;

    /* The lock guards everything below: nothing of it is touched without, but the bodies of workers, which
     * are those of whoever borrowed them, and where the frame's pixels are, which stays. Tracing holds no lock.
     * Whoever waits for anything waits for `changed`: idle workers for work, others for news or the end. */
    mutex lock;
    condition changed;
    pov_job_state state;
    bool closing, paused;
    uint64_t generation;
    pov_camera camera;
    frame frame;
    cells cells;
    double *scratch;             /* a number for each group of a cell */
    uint32_t *queue;             /* the tiles that the current pass of more samples has work in */
    size_t due, claimed, committed;   /* steps of the lattices' passes together, or of the pass of more samples */
    lattice_pass lattices[LATTICES_MAX];
    int lattices_ended;          /* those, but for the last one, that a row tells of */
    bool refining;               /* all lattices are in, more samples are being taken */
    struct { pov_pass *items; size_t count, capacity; } rows;
    bool last_is_partial;        /* the last row is not of a whole pass */
    pov_stop stop;
    double cpu;                  /* seconds of all threads */
    double earlier;              /* seconds of wall time before a checkpoint */
    size_t done_pixels;
    pov_counts counts;
    class_counts classes;
    bool *dirty;                 /* for each tile: changed since it was last taken */
    size_t dirty_count, dirty_next;
    bool news;                   /* tiles to take where there were none, or the end: for job_wait() */
    int waiting;                 /* threads in job_wait() */
    double started, ended;       /* ended: 0 while it runs */
    pov_error error;             /* why the state is FAILED */
    worker **workers;            /* all there are */
    size_t worker_count, worker_capacity;
    worker *free_workers;
    thread *threads;
    int thread_count;
    bool threads_wanted;         /* job_start() was called */
};

/* A job without memory ends as failed. The lock is held. */
void job_fail_memory(pov_job *job);

/* From one pass to the next; see passes.c. The lock is held for each. */
/* Forget all there was. */
void passes_begin(pov_job *job);
/* Take on the next tile; there is work. */
void passes_claim(pov_job *job, worker *w);
/* Go past what a checkpoint brought. */
void passes_skip(pov_job *job);
/* A checkpoint may have brought all that its pass was to do: go on to the next one, or to the end. */
void passes_resume(pov_job *job);
/* Begin the pass that the cells' targets ask for. */
void passes_queue(pov_job *job);
/* A tile is whole and current; the last one of a pass ends it: what the next one does is decided by what is in, so
 * not by the order of tiles. True: whoever waits for news should hear of it. */
bool passes_commit(pov_job *job, worker *w, const pov_counts *fresh, const class_counts *classes);
/* An end before the pass's: the row of what there is. */
void passes_stop(pov_job *job, pov_stop why);
/* End the job if its time is over. True: it did. */
bool passes_expire(pov_job *job);
/* Of the work until the nearest end that is asked for, as far as can be told. */
double passes_fraction(const pov_job *job);
/* Seconds of wall time until that end; below zero while nobody can tell. */
double passes_left(const pov_job *job);

/* The clock starts. The lock is held. */
void job_begin(pov_job *job);
/* The clock stops, and everybody who waits is told. The lock is held. */
void job_end(pov_job *job, pov_job_state state);

#endif
