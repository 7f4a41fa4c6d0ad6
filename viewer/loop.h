/* loop.h - the viewer's main loop on a surface: events in, picture out. The same for a window and for memory. */
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
    double fixed_clock;          /* fixed time in place of the clock, for results that must not depend on it; less than
                                  * 0: none */
    double longest;              /* time that the surface's thread was busy without checking events */
    double longest_work;         /* processor's time of that thread in such a stretch */
    double in_events;            /* of the time, what the events took since the last step */
    unsigned long frames;
    double drawn;                /* when the last one was */
    bool behind;                 /* something other than the picture has changed and was not drawn yet */
    char title[200];
} viewer;

/* Open on a surface, which the viewer owns from then on. The scene is not loaded yet. */
pov_status viewer_open(viewer *v, const args *a, surface *s, bool by_steps, pov_error *err);
void viewer_close(viewer *v);
/* Seconds since it began. */
double viewer_now(const viewer *v);
/* Process all events and results, and draw if something has changed. False: the user wants to quit. */
bool viewer_step(viewer *v);
/* Is there a change whose drawing is not due yet? */
bool viewer_is_behind(const viewer *v);
/* Sleep until there is something to do, and let the surface deliver its events. */
void viewer_wait(viewer *v, double most);
/* Run in a window until the user quits. */
void viewer_run(viewer *v);

/* Without a window: execute the keys, wait for the picture, write it. Returns the exit code. */
int shot_run(const args *a);
/* Its parts, for a viewer with a fixed clock: wait for a scene, or for the reason why there is none; execute the keys;
 * wait until all is complete, or for the requested number of passes. */
bool shot_wait_for_scene(viewer *v);
void shot_play(viewer *v, const char *keys);
void shot_settle(viewer *v);
/* Measure the first picture, restarts, and the busy time of the window's thread. Returns the exit code. */
int bench_run(const args *a);

#endif
