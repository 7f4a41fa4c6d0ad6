/* part.h - one part of a picture, for other processes or machines to trace the others. */
#ifndef CLI_PART_H
#define CLI_PART_H

#include "messages.h"

#include <limits.h>

/* What a joined picture takes over from the command line of its parts. */
typedef struct part_note {
    char text[256], format[16];
    pov_image_options options;
    double error;
} part_note;

/* False: the format's name is too long. */
bool part_note_write(part_note *n, const pov_image_options *o, double error);
/* False: povc did not write that. */
bool part_note_read(part_note *n, const char *text);

/* OUTPUT.part-I-of-N, and OUTPUT.round. False: too long. */
bool part_path(const char *output, int part, int parts, char out[PATH_MAX]);
bool part_round_path(const char *output, char out[PATH_MAX]);
/* Could the part be written? And take up the round that is written down beside the output, if there is one. */
pov_status part_begin(const args *a, const messages *m, pov_context *context, pov_job *job, pov_error *err);
pov_status part_end(const args *a, const messages *m, pov_job *job, pov_error *err);

#endif
