/* reference.h - a picture from a file that the scene's is compared with. */
#ifndef VIEWER_REFERENCE_H
#define VIEWER_REFERENCE_H

#include "args.h"
#include "tone.h"

typedef struct reference {
    pov_bitmap image;            /* of the file: linear; no pixels: there is none */
    int width, height;           /* of the picture that it is compared with */
    const float *rgba;           /* of that size: the file's, or `scaled` */
    float *scaled;
    uint8_t *bytes;              /* as displayed: red, green, blue, alpha */
    int encoded;                 /* rows above this one are up to date */
    int first, last;             /* rows changed since the last query; last < first: none */
    bool exact;                  /* no gain: encoded as the job does it; else by `tone` */
    pov_transfer transfer;
    tone tone;
} reference;

/* Without a size on the command line a picture to be compared has its reference's. */
pov_status reference_fill_size(args *a, pov_error *err);
/* Read the file that --reference names. */
pov_status reference_read(reference *r, pov_context *context, const args *a, pov_error *err);
void reference_free(reference *r, pov_context *context);
/* Scale it to a picture's size, where its own is another: each pixel is the mean of what the file has on its area. False: no
 * memory. */
bool reference_fit(reference *r, int width, int height);
/* Can it be compared with a picture of this size? */
bool reference_fits(const reference *r, int width, int height);
/* Display it like the picture. */
void reference_expose(reference *r, pov_transfer transfer, double gain);
/* Encode rows until the time is up. True: some are left. */
bool reference_update(reference *r, double seconds);
bool reference_take_rows(reference *r, int *first, int *last);
/* The linear colour of a pixel. */
const float *reference_color(const reference *r, int x, int y);
/* The picture's colour less the reference's. Of files of whole numbers, which hold nothing outside of 0 to 1, the
 * picture is taken as it would be written too. */
void reference_difference(const reference *r, int x, int y, const float *color, float *out);
/* The largest of the three, without its sign. */
float reference_distance(const float *difference);

#endif
