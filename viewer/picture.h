/* picture.h - the displayed bytes, updated from a job tile by tile. */
#ifndef VIEWER_PICTURE_H
#define VIEWER_PICTURE_H

#include "reference.h"

#include <povtrace/render.h>

/* The displayed quantity: colours, errors, or costs. */
typedef enum picture_kind { PICTURE_COLORS, PICTURE_SAMPLES, PICTURE_TIME, PICTURE_ERROR, PICTURE_DIFFERENCE } picture_kind;

/* Is a colour within what the display shows? */
typedef enum picture_clipped { PICTURE_INSIDE, PICTURE_ABOVE, PICTURE_BELOW } picture_clipped;

typedef struct picture {
    uint8_t *pixels;             /* red, green, blue, alpha; alpha 0: nothing yet */
    int width, height;
    int first, last;             /* rows changed since the last query; last < first: none */
    picture_kind kind;
    const reference *reference;  /* of PICTURE_DIFFERENCE, and of the same size */
    bool toned;                  /* by `tone`; else as the scene asks */
    tone tone;
    int reread;                  /* rows from here on are to be read again; height: none */
    bool marked;                 /* colour clipped pixels */
    uint8_t *outside;            /* picture_clipped of each pixel, while marked */
    size_t clipped[3];           /* how many pixels are; of those inside only the change */
    unsigned *seen;              /* for each grid cell of tile corners: the restart after which it was last read */
    unsigned restart;
    size_t covered;              /* pixels of the tiles read since the restart */
} picture;

/* Change the size: old pixels are stretched until better ones come. False: no memory, and nothing has changed. */
bool picture_resize(picture *p, int width, int height);
void picture_free(picture *p);
/* The job was restarted: old pixels stay visible until their tiles come. */
void picture_restart(picture *p);
/* Display with this gain; 1 is bit-identical to the job's encoding. */
void picture_expose(picture *p, pov_transfer transfer, double gain);
/* Samples from 1 to 1024, a pixel's time from a microsecond to 10 ms and errors and differences from 0.0001 to 0.1 go from dark to
 * bright, by their logarithm. */
void picture_show(picture *p, picture_kind kind);
/* Colour pixels that are brighter than the display shows magenta, and those with a negative channel cyan. */
void picture_mark(picture *p, bool marked);
/* Read all rows again, as time allows. */
void picture_reread(picture *p);
/* Read changed tiles from the job until the time is up. True: some are left. */
bool picture_update(picture *p, pov_job *job, double seconds);
void picture_touch(picture *p, int first, int last);
bool picture_is_covered(const picture *p);

#endif
