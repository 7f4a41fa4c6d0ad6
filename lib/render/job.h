/* job.h - rendering a picture: tiles in passes, claimed, traced and committed. The inside of the public type. */
#ifndef RENDER_JOB_H
#define RENDER_JOB_H

#include "shade/tracer.h"

/* The public calls of povtrace/render.h call these; see there. */
pov_status job_create(pov_job **out, const shading *scene, const pov_render_desc *desc, pov_error *err);
void job_destroy(pov_job *job);
pov_status job_start(pov_job *job, pov_error *err);
pov_job_state job_step(pov_job *job);
pov_job_state job_wait(pov_job *job, double seconds);
bool job_take(pov_job *job, pov_rect *changed);
void job_read(pov_job *job, pov_rect rect, pov_pixels format, void *dst, size_t stride);
void job_restart(pov_job *job, const pov_camera *camera);
void job_pause(pov_job *job, bool paused);
void job_cancel(pov_job *job);
void job_get_progress(pov_job *job, pov_progress *out);
pov_status job_save(pov_job *job, const char *file, pov_error *err);
pov_status job_load(pov_job *job, const char *file, pov_error *err);
pov_status job_join(pov_job **out, const env *e, const char *const *files, size_t count, pov_error *err);
const char *job_note(const pov_job *job);
bool job_get_pass(pov_job *job, size_t index, pov_pass *out);
bool job_get_class(pov_job *job, size_t index, pov_class_counts *out);
pov_status job_get_error(pov_job *job, pov_error *err);

#endif
