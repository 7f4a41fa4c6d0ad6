/* povtrace/render.h - rendering pictures, at once or progressively.
 *
 * One mechanism serves a batch program and a viewer. A job is a list of tiles in passes from coarse to fine; a step
 * traces one tile; a pool of threads is a loop of steps. No pixel is traced twice, and a pixel's value depends on the
 * scene, the camera and its own coordinates only. So the last picture of a progressive job equals the only picture of a
 * plain one. */
#ifndef POVTRACE_RENDER_H
#define POVTRACE_RENDER_H

#include <povtrace/scene.h>

typedef struct pov_job pov_job;
typedef struct pov_rect { int x, y, width, height; } pov_rect;

typedef enum pov_sampling { POV_SAMPLING_UNIFORM, POV_SAMPLING_ADAPTIVE } pov_sampling;

typedef struct pov_render_desc {
    size_t size;
    int width, height;            /* required: size of the whole picture */
    pov_rect crop;                /* the part that is traced and read; width 0: all of it */
    int preview;                  /* edge of a pixel of the first pass: 2, 4, 8 or 16; 0: one full pass */
    int threads;                  /* 0: one for each core */
    int samples;                  /* samples a pixel, on average; 0 or 1: one, through its centre, unless a limit below
                                   * is set */
    const pov_camera *camera;     /* NULL: the scene's; copied */
    void (*wake)(void *user);     /* called by a worker when changes can be taken; it should only wake a loop */
    void *wake_user;
    pov_sampling sampling;        /* the same number for all pixels, or more samples where the error is */
    double target_error;          /* add samples until the estimated rms error, in linear light, is this; 0: none */
    double time_limit;            /* or until so many seconds have passed since the start, or since pov_job_load(); 0: none */
    const float *reference;       /* of the crop, linear, four channels a pixel: each pass is compared with it. Must
                                   * live as long as the job; or NULL */
    uint32_t seed;                /* another seed gives other sample positions, except for a single sample */
    bool reference_clipped;       /* all values of the reference are within 0 .. 1 */
    int time_map;                 /* not 0: measure the time of pixels, for POV_PIXELS_TIME */
    int alpha;                    /* not 0: the background is transparent as far as the scene says, and alpha is what
                                   * hides it; colours are what it hides it with, not divided by alpha */
    int part, parts;              /* trace the part-th of so many parts, 1 .. parts; 0: all. See pov_job_join() */
    const char *note;             /* at most 255 characters that parts keep, for whoever joins them; or NULL; copied */
} pov_render_desc;

typedef enum pov_job_state {
    POV_JOB_IDLE, POV_JOB_RUNNING, POV_JOB_DONE, POV_JOB_CANCELLED, POV_JOB_FAILED
} pov_job_state;
/* ERROR, SAMPLES and TIME are maps of one float a pixel: the estimated rms error, below zero where it is not known; the number
 * of samples; and the pixel's processor seconds since the start, or since the checkpoint of pov_job_load(), below zero
 * if desc.time_map is not set. Values are the same within a cell of 4 by 4 pixels, because those of single pixels would
 * be chance.
 * The others are of the ray through the centre of each pixel, traced when they are read, by the thread that reads: many
 * pixels of a call cost less than as many calls, and several threads may read parts at once. What is seen in mirrors or
 * through glass is not in them. DEPTH: the distance from the eye, one float; 0: no hit. NORMAL: x, y, z, 1 of the unit normal
 * that faces the eye, POSITION: those of the point, ALBEDO: the pigment's red, green, blue, 1, whatever its light; four
 * floats, all 0: no hit. OBJECT: a uint32_t, the number of pov_scene_get_object(); UINT32_MAX: no hit. ALPHA: how much of
 * the background the ray hides, one float, as with desc.alpha. CERTAINTY: one float; 1: double precision decided the hit or
 * miss, 0: double-double arithmetic was needed. A joined job has none, and memory may end: then floats are NaN, and objects
 * UINT32_MAX. */
typedef enum pov_pixels {
    POV_PIXELS_DISPLAY8, POV_PIXELS_LINEAR_FLOAT, POV_PIXELS_ERROR, POV_PIXELS_SAMPLES, POV_PIXELS_TIME, POV_PIXELS_DEPTH,
    POV_PIXELS_NORMAL, POV_PIXELS_POSITION, POV_PIXELS_OBJECT, POV_PIXELS_ALBEDO, POV_PIXELS_ALPHA, POV_PIXELS_CERTAINTY
} pov_pixels;
/* The end of a job; NONE: still running, or failed. PART: a part is complete; or, of a joined job, the parts are to go
 * on. */
typedef enum pov_stop {
    POV_STOP_NONE, POV_STOP_SAMPLES, POV_STOP_ERROR, POV_STOP_TIME, POV_STOP_USER, POV_STOP_PART
} pov_stop;

/* Numbers of rays of each kind that were sent, or not sent and why. */
typedef struct pov_counts {
    uint64_t camera, shadow, reflected, transmitted;   /* sent */
    uint64_t shadow_behind, shadow_idle;  /* not sent: light behind the surface; light or surface that adds nothing */
    uint64_t cut_depth, cut_weight;       /* not sent: max_trace_level, adc_bailout; each adds black */
    uint64_t inner_reflections;           /* total internal reflections among the reflected */
    uint64_t escalated;                   /* intersections that double precision left open */
} pov_counts;

typedef struct pov_progress {
    size_t size;
    double fraction, seconds;     /* seconds of wall time from start to now, or to the end */
    int pass, passes, threads;
    pov_counts counts;            /* of the tiles done so far */
    double spp_mean, est_rmse;    /* at the last pass's end; est_rmse is below zero while it is not known */
    pov_stop stop;
    double seconds_left;          /* until the nearest requested end, predicted from the passes so far; below zero: not
                                   * known */
    int width, height;            /* of the pixels that can be read */
    int round;                    /* of parts: 1, 2, ... */
} pov_progress;

/* The picture at the end of a pass: a row of the report of error against run time. docs/report.md has more. */
typedef struct pov_pass {
    size_t size;
    int pass, threads;
    double wall_s, cpu_s;         /* since the start */
    double spp_mean;
    int spp_max;
    pov_counts counts;
    /* The rms error of the picture in linear light, estimated from two independent halves of the samples; the interval
     * that holds the true error in 95 of 100 cases; and the 99th percentile of the errors of cells. They do not include
     * what is cut off (counts.cut_depth, cut_weight). Below zero: not known. Where all samples are bit-identical,
     * est_rmse is 0, and the interval ends at an error that so many equal samples do not exclude: that of a feature
     * which covers a smaller part of a cell. */
    double est_rmse, est_ci95_lo, est_ci95_hi, est_p99_tile;
    double ref_rmse, ref_max;     /* against the reference; below zero: there is none */
    uint64_t unresolved;          /* pixels of cells with an error above the target, or above 1/255 without a target;
                                   * valid where est_rmse is */
    uint64_t clipped;             /* pixels outside 0 .. 1, which a file of integers clips */
} pov_pass;

/* Queries of a class of primitives, after boxes and filters, and those that double precision left open. */
typedef struct pov_class_counts {
    size_t size;
    const char *keyword;          /* valid while the scene lives */
    uint64_t asked, escalated;    /* intersections; those decided by double-double arithmetic */
} pov_class_counts;

/* desc is copied; the scene must outlive the job. */
POV_API pov_status pov_job_create(pov_job **out, const pov_scene *scene, const pov_render_desc *desc, pov_error *err);
POV_API void pov_job_destroy(pov_job *job);             /* cancels and joins first */

/* Any thread, any time between create and destroy. */
POV_API pov_status pov_job_start(pov_job *job, pov_error *err);   /* desc.threads workers, each a loop of steps */
POV_API pov_job_state pov_job_step(pov_job *job);                 /* trace one tile on this thread */
POV_API pov_job_state pov_job_wait(pov_job *job, double seconds); /* until news, the end, or the time is up */
POV_API bool pov_job_take(pov_job *job, pov_rect *changed);       /* next changed tile, or false; never blocks */
/* Copy pixels, top row first, four channels but for maps; rect is relative to the crop's corner, stride is in bytes. A pixel not yet
 * traced has the value of its nearest coarser one. DISPLAY8 is encoded as the scene asks. */
POV_API void pov_job_read(pov_job *job, pov_rect rect, pov_pixels format, void *dst, size_t stride);
/* Drop all pixels and begin with the coarsest; NULL keeps the camera. */
POV_API void pov_job_restart(pov_job *job, const pov_camera *camera);
/* While a job is paused no thread begins another tile, and a step traces nothing. All other calls work. */
POV_API void pov_job_pause(pov_job *job, bool paused);
POV_API void pov_job_cancel(pov_job *job);
POV_API void pov_job_get_progress(pov_job *job, pov_progress *out);
/* Write a checkpoint, at any time. A job of the same scene text, settings and version continues it if it is loaded
 * before the start, and ends with the same bits, rows included except for their times. Other checkpoints are
 * refused. */
POV_API pov_status pov_job_save(pov_job *job, const char *file, pov_error *err);
POV_API pov_status pov_job_load(pov_job *job, const char *file, pov_error *err);
/* A picture in parts, on one machine or many, has the bits of the same picture in one piece. Each part is a job of
 * desc.part, which has no time limit and no preview. Once it is done with POV_STOP_PART, pov_job_save() writes its file,
 * for another program to join. All files of a round make a job that is done and traces nothing. If it ends with
 * POV_STOP_PART, the next samples depend on the whole picture: pov_job_save() writes what every part of the next round
 * takes by pov_job_load() before its start, and after it, if it is still there, the part's own file of the round before,
 * which spares it that work. The context must outlive the job. */
POV_API pov_status pov_job_join(pov_job **out, pov_context *context, const char *const *files, size_t count, pov_error *err);
/* The note of the parts that were joined, or of the job's description; valid while the job lives; never NULL. */
POV_API const char *pov_job_get_note(const pov_job *job);
/* The index-th pass that has ended since the start; false past the last. */
POV_API bool pov_job_get_pass(pov_job *job, size_t index, pov_pass *out);
/* Counts of the finished tiles for the index-th class in the order of the scene; false past the last. Classes from the
 * sixteenth on share one count. */
POV_API bool pov_job_get_class(pov_job *job, size_t index, pov_class_counts *out);
/* A scene file to an image file, in one call: with a context, a scene and a job of its own, by pov_image_write(), with the
 * scene's encoding, and with alpha if desc has it. load may be NULL; desc NULL: 800 x 600. image_width and image_height are
 * desc's where load says nothing. Returns when the file is written, or the error of the step that failed. */
POV_API pov_status pov_render_file(const char *scene, const char *image, const pov_load_desc *load, const pov_render_desc *desc,
                                   pov_error *err);
/* Why a job is POV_JOB_FAILED; POV_OK otherwise. */
POV_API pov_status pov_job_get_error(pov_job *job, pov_error *err);

#endif
