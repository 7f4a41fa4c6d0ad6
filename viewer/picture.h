/* picture.h - the bytes that are shown, brought up to date from a job a tile at a time. */
#ifndef VIEWER_PICTURE_H
#define VIEWER_PICTURE_H

#include "tone.h"

#include <povtrace/render.h>

/* What of the job is shown: its colours, or how far they may be off, or what they have cost. */
typedef enum picture_kind { PICTURE_COLORS, PICTURE_SAMPLES, PICTURE_TIME, PICTURE_ERROR } picture_kind;

typedef struct picture {
    uint8_t *pixels;             /* red, green, blue, alpha; alpha 0: nothing yet */
    int width, height;
    int first, last;             /* rows changed since they were last asked for; last < first: none */
    picture_kind kind;
    bool toned;                  /* by `tone`; else as the scene asks */
    tone tone;
    int reread;                  /* rows from here on are to be read again; height: none */
    unsigned *seen;              /* for each cell of tile corners: the restart that it was last seen after */
    unsigned restart;
    size_t covered;              /* pixels of the tiles seen since the restart */
} picture;

/* Of another size: what was there is stretched, until better comes. False: no memory, and nothing has changed. */
bool picture_resize(picture *p, int width, int height);
void picture_free(picture *p);
/* A job has begun anew: what is there stays in sight until its tiles come. */
void picture_restart(picture *p);
/* Show with this gain; 1 is to the bit what the job encodes. */
void picture_expose(picture *p, pov_transfer transfer, double gain);
/* Samples from 1 to 1024, a pixel's time from a microsecond to 10 ms and errors from 0.0001 to 0.1 go from dark to
 * bright, by their logarithm. */
void picture_show(picture *p, picture_kind kind);
/* Read all rows again, as time allows. */
void picture_reread(picture *p);
/* Take changed tiles from the job until the time is up. True: some are left. */
bool picture_update(picture *p, pov_job *job, double seconds);
void picture_touch(picture *p, int first, int last);
bool picture_is_covered(const picture *p);

#endif
