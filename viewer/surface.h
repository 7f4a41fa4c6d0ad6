/* surface.h - where the viewer draws and where events come from: a window, or memory. One of each kind of call goes
 * through the table, so that all else is the same for both. Calls are for the thread that opened it, but for post. */
#ifndef VIEWER_SURFACE_H
#define VIEWER_SURFACE_H

#include "app.h"

typedef void (*surface_call)(void);
/* What a surface hands its events to. */
typedef void surface_sink(void *user, const app_event *event);

typedef struct surface surface;
struct surface {
    /* Fetch an OpenGL function, NULL if there is none: neither library is linked against for drawing, for both
     * export the same names. */
    surface_call (*get_proc)(const char *name);
    void (*get_size)(surface *s, int *width, int *height, double *scale);
    /* Deliver what has happened; sleep until something does, or for so many seconds. */
    void (*wait)(surface *s, double seconds);
    void (*swap)(surface *s);
    void (*set_title)(surface *s, const char *title);
    /* Out of the user's sight, before the end. */
    void (*hide)(surface *s);
    /* Wake the thread that waits. Any thread. */
    void (*post)(void *surface);
    void (*close)(surface *s);
    surface_sink *sink;
    void *sink_user;
};

/* A window; NULL: `err` says why there is none. */
surface *surface_glfw_open(int width, int height, const char *title, pov_error *err);
/* Memory, drawn into by OSMesa. It needs no display, and no event ever comes from it but what is posted. */
surface *surface_osmesa_open(int width, int height, pov_error *err);
/* Only memory changes its size by being told. */
bool surface_osmesa_resize(surface *s, int width, int height);

#endif
