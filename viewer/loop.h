/* loop.h - the viewer at work on a surface: events in, picture out. The same for a window and for memory. */
#ifndef VIEWER_LOOP_H
#define VIEWER_LOOP_H

#include "overlay.h"

typedef struct viewer {
    app app;
    surface *surface;
    present *present;
    session *session;
    overlay overlay;
    args args;
    double began;                /* the clock when it did */
    double fixed_clock;          /* in place of the clock, for what must not depend on it; less than 0: not so */
    double longest;              /* time that the thread of the surface was busy without a look at its events */
    double longest_work;         /* processor's time of that thread in such a stretch */
    double in_events;            /* of the time, what the events took since the last step */
    unsigned long frames;
    double drawn;                /* when the last one was */
    bool behind;                 /* something else than the picture has changed and was not drawn yet */
    char title[200];
} viewer;

/* Open on a surface, which is the viewer's from then on. The scene is not there yet. */
pov_status viewer_open(viewer *v, const args *a, surface *s, bool by_steps, pov_error *err);
void viewer_close(viewer *v);
/* Seconds since it began. */
double viewer_now(const viewer *v);
/* Do what there is to do and draw if something has changed. False: the user wants to quit. */
bool viewer_step(viewer *v);
/* Is there something to draw that was not due yet? */
bool viewer_is_behind(const viewer *v);
/* Sleep until there is something to do, and let the surface deliver its events. */
void viewer_wait(viewer *v, double most);
/* Sit in a window until the user quits. */
void viewer_run(viewer *v);

/* Without a window: do what the keys say, wait for the picture, write it. Returns the exit code. */
int shot_run(const args *a);
/* Its parts, for a viewer whose clock is fixed: wait for a scene, or for why there is none; do what the keys say; wait
 * until all is there, or as many passes as were asked for. */
bool shot_wait_for_scene(viewer *v);
void shot_play(viewer *v, const char *keys);
void shot_settle(viewer *v);
/* Measure: first picture, restarts, how long the window's thread is busy. Returns the exit code. */
int bench_run(const args *a);

#endif
