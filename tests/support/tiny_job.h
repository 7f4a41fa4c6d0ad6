/* tiny_job.h - pictures of a room with a bit of everything, for the tests of jobs. */
#ifndef SUPPORT_TINY_JOB_H
#define SUPPORT_TINY_JOB_H

#include "support/tiny.h"

#include "render/job.h"

/* A floor, a mirror sphere, a glass sphere, a matt one, two lights. */
void tiny_room(tiny *s, const pov_allocator *memory);
/* Half-mirrors that split rays without end: a pixel takes longer than any test waits. */
void tiny_endless(tiny *s);
pov_job *tiny_job(const tiny *s, const pov_render_desc *desc);
/* A description of `width` x `height` pixels; the rest is zero. */
pov_render_desc tiny_desc(int width, int height);
/* Start, wait for the end, read all pixels as linear floats; the caller frees them. The job is destroyed. */
float *tiny_picture(const tiny *s, const pov_render_desc *desc);
/* All pixels of a job as they are. */
float *tiny_read(pov_job *job, int width, int height);

#endif
