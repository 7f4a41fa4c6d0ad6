/* frames_run.h - what the command line asks for, once or for each frame of an animation. */
#ifndef CLI_FRAMES_RUN_H
#define CLI_FRAMES_RUN_H

#include "run.h"

/* A frame that fails is said and left out, and the rest is drawn: the error is then how many there were. With --resume frames
 * that are there stay. */
pov_status frames_run(args *a, messages *m, run_end *end, pov_error *err);

#endif
