/* progress.h - the progress of the picture, on standard error. */
#ifndef CLI_PROGRESS_H
#define CLI_PROGRESS_H

#include "messages.h"

typedef struct progress {
    args_progress mode;          /* never AUTO */
    bool lines;                  /* a line from time to time instead of a bar */
    bool drawn;                  /* a bar stands on the screen */
    double shown;                /* seconds of the job, or of the animation, when it was last shown */
    int frame, done, frames;     /* of an animation: the number of what is drawn, how many are done, of how many */
    double before;               /* seconds of the frames that are done */
} progress;

void progress_init(progress *p, const args *a);
/* Is the display due again, `seconds` after the job's start? Querying the job costs time, so it is done only then. */
bool progress_due(const progress *p, double seconds);
void progress_show(progress *p, const pov_progress *now);
/* Show the last state, and remove the bar from the screen, if no frame follows. */
void progress_end(progress *p, const pov_progress *now);

/* From the state of a frame that of the whole animation: how much of it is there, its seconds and those that are left. */
pov_progress progress_over_all(const progress *p, const pov_progress *now);
/* "42.3": rounded down, and 100 only at the end. */
void progress_percent(double fraction, char *out, size_t size);
/* "4 s", "3:07", "2:03:07". */
void progress_duration(double seconds, char *out, size_t size);
uint64_t progress_rays(const pov_counts *counts);

/* The numbers of a bar in less than so many columns: whole fields, of which the time left goes last. Returns its width. */
size_t progress_text(const pov_progress *now, int columns, char *out, size_t size);

#endif
