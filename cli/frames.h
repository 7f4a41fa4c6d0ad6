/* frames.h - which pictures of an animation are drawn, their clocks and the names of their files. */
#ifndef CLI_FRAMES_H
#define CLI_FRAMES_H

#include <povtrace/povtrace.h>

typedef struct frames {
    bool asked;                  /* false: one still picture */
    int first, last;             /* the animation's, of which the clock goes from first_clock to last_clock */
    int from, to, step;          /* what is drawn of it */
    bool cyclic;                 /* one behind the last is the first again, and has last_clock */
    double first_clock, last_clock;
} frames;

int frames_count(const frames *f);
/* What the scene's text finds as clock, frame_number and so on. */
pov_animation frames_animation(const frames *f, int frame);
/* The file's name with the frame's number before its ending, as wide as that of the last one. Standard output and devices keep
 * theirs. False: it is too long. */
bool frames_name(const frames *f, int frame, const char *path, char *out, size_t size);

#endif
