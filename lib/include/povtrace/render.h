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

typedef struct pov_render_desc {
    size_t size;
    int width, height;            /* needed: of the whole picture */
    pov_rect crop;                /* the part that is traced and read; width 0: all of it */
    int preview;                  /* edge of a pixel of the first pass: 2, 4, 8 or 16; 0: one full pass */
    int threads;                  /* 0: one for each core */
    int samples;                  /* for each pixel; 0: one, through its centre */
    const pov_camera *camera;     /* NULL: the scene's; copied */
    void (*wake)(void *user);     /* from a worker: something is there to take. Only poke a loop from it. */
    void *wake_user;
} pov_render_desc;

typedef enum pov_job_state {
    POV_JOB_IDLE, POV_JOB_RUNNING, POV_JOB_DONE, POV_JOB_CANCELLED, POV_JOB_FAILED
} pov_job_state;
typedef enum pov_pixels { POV_PIXELS_DISPLAY8, POV_PIXELS_LINEAR_FLOAT } pov_pixels;

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
} pov_progress;

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
/* Why a job is POV_JOB_FAILED; POV_OK otherwise. */
POV_API pov_status pov_job_get_error(pov_job *job, pov_error *err);

#endif
