/* job_state.h - the state of a job, for the files that advance it (job.c) and that observe and control it (watch.c). */
#ifndef RENDER_JOB_STATE_H
#define RENDER_JOB_STATE_H

#include "base/thread.h"
#include "render/framebuffer.h"
#include "render/identity.h"
#include "render/job.h"
#include "render/refine.h"
#include "render/settings.h"
#include "render/worker.h"

/* A pass of first samples. Threads may already trace tiles of the next pass when its last tile is committed. So each
 * pass has an account of its own, which does not depend on those tiles. */
typedef struct lattice_pass {
    size_t tiles;                /* committed */
    pov_counts counts;
} lattice_pass;

/* A pool of threads is a loop of steps, and so is a program that steps by itself: each step borrows a worker, and the
 * worker claims a tile, traces it and commits it. */
struct pov_job {
    const env *env;
    const shading *scene;        /* NULL: joined from parts, and nothing is traced */
    settings settings;
    identity *joined;            /* that of the parts; NULL: this job has its own */
    uint32_t *wanted;            /* a part's targets of all groups after this round; NULL: the first round */
    singles *wanted_singles;     /* those of single pixels, in `gets`; NULL: as in cells */
    int round;                   /* of parts: 1, 2, ...; else 0 */
    char note[SETTINGS_NOTE];
    tiles tiles;
    encoding encoding;
    size_t all_pixels;

    /* The lock guards everything below, with two exceptions: the bodies of workers, which belong to the thread that
     * borrowed them, and the address of the frame's pixels, which never changes. Tracing holds no lock. All waiting is
     * for `changed`: idle workers wait for work, other threads for news or the end. */
    mutex lock;
    condition changed;
    pov_job_state state;
    bool closing, paused;
    uint64_t generation;
    pov_camera camera;
    framebuffer framebuffer;
    cells cells;
    double *scratch;             /* two numbers for each group of a cell */
    uint32_t *queue;             /* tiles in which the current pass of more samples has work */
    size_t due, claimed, committed;   /* steps of the lattices' passes together, or of the pass of more samples */
    lattice_pass lattices[LATTICES_MAX];
    int lattices_ended;          /* lattice passes that have a row, without the last one */
    bool refining;               /* all lattices are committed, more samples are being taken */
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
    bool news;                   /* tiles to take where there were none, or the end; for job_wait() */
    int waiting;                 /* threads in job_wait() */
    double started, ended;       /* ended: 0 while it runs */
    pov_error error;             /* why the state is FAILED */
    worker **workers;            /* all workers */
    size_t worker_count, worker_capacity;
    worker *free_workers;
    thread *threads;
    int thread_count;
    bool threads_wanted;         /* job_start() was called */
};

/* An idle job without a scene, for the results of `parts` parts. */
pov_status job_create_joined(pov_job **out, const env *e, const gamma *g, const pov_render_desc *desc, int parts, pov_error *err);
/* A job without memory ends as failed. The lock is held. */
void job_fail_memory(pov_job *job);

/* Passes; see passes.c. The lock is held for each. */
/* Drop all results. */
void passes_begin(pov_job *job);
/* Claim the next tile; there is work. */
void passes_claim(pov_job *job, worker *w);
/* Skip the passes that a checkpoint contained. */
void passes_skip(pov_job *job);
/* A checkpoint may have contained all work of its pass: go on to the next pass, or to the end. */
void passes_resume(pov_job *job);
/* All tiles have all they shall have so far: note it, and decide what is next. */
void passes_end(pov_job *job);
/* Begin the pass that the cells' targets ask for. */
void passes_queue(pov_job *job);
/* Commit a complete and current tile. The last tile of a pass ends it: the next pass is decided by all committed
 * results, so not by the order of tiles. True: waiting threads should be told. */
bool passes_commit(pov_job *job, worker *w, const pov_counts *fresh, const class_counts *classes);
/* The job ends before its pass: add the row of the present picture. */
void passes_stop(pov_job *job, pov_stop why);
/* End the job if its time limit is reached. True: it did. */
bool passes_expire(pov_job *job);
/* Fraction of the work until the nearest requested end, as far as can be predicted. */
double passes_fraction(const pov_job *job);
/* Seconds of wall time until that end; negative while there is no estimate. */
double passes_left(const pov_job *job);

/* The clock starts. The lock is held. */
void job_begin(pov_job *job);
/* The clock stops, and all waiting threads are woken. The lock is held. */
void job_end(pov_job *job, pov_job_state state);

#endif
