/* povtrace/render.h - images, whole or as they grow.
 *
 * One mechanism serves a batch program and a viewer. A job is a list of tiles
 * in passes from coarse to fine; a step traces one tile; a pool of threads is
 * a loop of steps. No pixel is traced twice, and a pixel's value depends on
 * nothing but the scene, the camera and its own coordinates: so the last
 * picture of a progressive job equals the only picture of a plain one. */
#ifndef POVTRACE_RENDER_H
#define POVTRACE_RENDER_H

#include <povtrace/scene.h>

typedef struct pov_job pov_job;
typedef struct pov_rect { int x, y, width, height; } pov_rect;

typedef enum pov_sampling { POV_SAMPLING_UNIFORM, POV_SAMPLING_ADAPTIVE } pov_sampling;

typedef struct pov_render_desc {
    size_t size;
    int width, height;            /* needed: of the whole picture */
    pov_rect crop;                /* the part that is traced and read; width 0: all of it */
    int preview;                  /* edge of a pixel of the first pass: 2, 4, 8 or 16; 0: one full pass */
    int threads;                  /* 0: one for each core */
    int samples;                  /* a pixel, on average; 0 or 1: one, through its centre, unless a limit below is set */
    const pov_camera *camera;     /* NULL: the scene's; copied */
    void (*wake)(void *user);     /* from a worker: something is there to take. Only poke a loop from it. */
    void *wake_user;
    pov_sampling sampling;        /* samples alike for all pixels, or more of them where the error is */
    double target_error;          /* add samples until the estimated rms error, in linear light, is this; 0: none */
    double time_limit;            /* or until so many seconds have passed since the start, or since pov_job_load(); 0: none */
    const float *reference;       /* of the crop, linear, four channels a pixel: each pass is held against it. Kept
                                     by the caller while the job lives; or NULL */
    uint32_t seed;                /* another one, other places for all samples but a single one */
    bool reference_clipped;       /* the reference holds nothing outside 0 .. 1 */
    int time_map;                 /* not 0: keep account of where the time goes, for POV_PIXELS_TIME */
} pov_render_desc;

typedef enum pov_job_state {
    POV_JOB_IDLE, POV_JOB_RUNNING, POV_JOB_DONE, POV_JOB_CANCELLED, POV_JOB_FAILED
} pov_job_state;
/* The last three are maps of one float a pixel: the estimated rms error, below zero where it is not known; the number of
 * samples; and the seconds of the processor that the pixel has taken since the start, or since what pov_job_load()
 * brought, below zero where desc.time_map did not ask for it. All are alike within a cell of 4 by 4 pixels, for a single
 * pixel's would be chance. */
typedef enum pov_pixels {
    POV_PIXELS_DISPLAY8, POV_PIXELS_LINEAR_FLOAT, POV_PIXELS_ERROR, POV_PIXELS_SAMPLES, POV_PIXELS_TIME
} pov_pixels;
/* What ended a job; NONE: nothing yet, or a failure. */
typedef enum pov_stop { POV_STOP_NONE, POV_STOP_SAMPLES, POV_STOP_ERROR, POV_STOP_TIME, POV_STOP_USER } pov_stop;

/* How many rays of each kind were sent, or not sent and why. */
typedef struct pov_counts {
    uint64_t camera, shadow, reflected, transmitted;   /* sent */
    uint64_t shadow_behind, shadow_idle;  /* not sent: light behind the surface; light or surface that adds nothing */
    uint64_t cut_depth, cut_weight;       /* not sent: max_trace_level, adc_bailout; each adds black */
    uint64_t inner_reflections;           /* total internal reflections among the reflected */
    uint64_t decided;                     /* intersections that double left open and two-part arithmetic decided */
} pov_counts;

typedef struct pov_progress {
    size_t size;
    double fraction, seconds;     /* seconds of wall time from start to now, or to the end */
    int pass, passes, threads;
    pov_counts counts;            /* of the tiles done so far */
    double spp_mean, est_rmse;    /* at the last pass's end; est_rmse is below zero while it is not known */
    pov_stop stop;
    double seconds_left;          /* until the nearest end that is asked for, by the passes so far; below zero: not known */
} pov_progress;

/* The picture at the end of a pass: a row of the report of error against run time. docs/report.md has more. */
typedef struct pov_pass {
    size_t size;
    int pass, threads;
    double wall_s, cpu_s;         /* since the start */
    double spp_mean;
    int spp_max;
    pov_counts counts;
    /* The rms error of the picture in linear light as the difference of two independent halves of the samples shows
     * it, the band that holds the true one in 95 of 100 cases, and of the cells' own the one that 99 of 100 are below.
     * What is cut off (counts.cut_depth, cut_weight) they cannot see. Below zero: not known. Where all samples agree to
     * the bit est_rmse is 0, and the band ends at what so many equal samples do not exclude: a feature that covers less
     * of a cell than that. */
    double est_rmse, est_ci95_lo, est_ci95_hi, est_p99_tile;
    double ref_rmse, ref_max;     /* against the reference; below zero: there is none */
    uint64_t unresolved;          /* pixels of cells whose own error is above the target, or 1/255 without one; tells
                                     something where est_rmse does */
    uint64_t clipped;             /* pixels outside 0 .. 1, which a file of integers will not hold */
} pov_pass;

/* What a class of primitives was asked by rays, after boxes and filters, and what double left open of it. */
typedef struct pov_class_counts {
    size_t size;
    const char *keyword;          /* the scene's, as long as it lives */
    uint64_t asked, decided;      /* intersections; decided: by two-part arithmetic */
} pov_class_counts;

/* desc is copied; the scene must outlive the job. */
POV_API pov_status pov_job_create(pov_job **out, const pov_scene *scene, const pov_render_desc *desc, pov_error *err);
POV_API void pov_job_destroy(pov_job *job);             /* cancels and joins first */

/* Any thread, any time between create and destroy. */
POV_API pov_status pov_job_start(pov_job *job, pov_error *err);   /* desc.threads workers, each a loop of steps */
POV_API pov_job_state pov_job_step(pov_job *job);                 /* trace one tile on this thread */
POV_API pov_job_state pov_job_wait(pov_job *job, double seconds); /* until news, the end, or the time is up */
POV_API bool pov_job_take(pov_job *job, pov_rect *changed);       /* next changed tile, or false; never blocks */
/* Copy pixels, top row first, four channels; rect is relative to the crop's corner, stride is in bytes. Before a
 * pixel is traced its nearest coarser one stands for it. DISPLAY8 is encoded as the scene asks. */
POV_API void pov_job_read(pov_job *job, pov_rect rect, pov_pixels format, void *dst, size_t stride);
/* Drop all pixels and begin with the coarsest; NULL keeps the camera. */
POV_API void pov_job_restart(pov_job *job, const pov_camera *camera);
/* While a job is paused nobody begins another tile: its threads sleep, a step traces nothing. All else goes on. */
POV_API void pov_job_pause(pov_job *job, bool paused);
POV_API void pov_job_cancel(pov_job *job);
POV_API void pov_job_get_progress(pov_job *job, pov_progress *out);
/* Write all there is to go on from, at any time; a job of the same scene text, settings and version takes it up before
 * its start, refuses any other's, and ends with the same bits, rows included but for their times. */
POV_API pov_status pov_job_save(pov_job *job, const char *file, pov_error *err);
POV_API pov_status pov_job_load(pov_job *job, const char *file, pov_error *err);
/* The index-th pass that has ended since the start; false past the last. */
POV_API bool pov_job_get_pass(pov_job *job, size_t index, pov_pass *out);
/* Of the tiles done so far, for the index-th class in the order of the scene; false past the last. Classes from the
 * sixteenth on are counted together. */
POV_API bool pov_job_get_class(pov_job *job, size_t index, pov_class_counts *out);
/* Why a job is POV_JOB_FAILED; POV_OK otherwise. */
POV_API pov_status pov_job_get_error(pov_job *job, pov_error *err);

#endif
