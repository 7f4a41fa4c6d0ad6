/* surface.h - a window or memory that the viewer draws on and gets events from. Calls that differ go through the table,
 * so that all other code is the same for both. Calls are for the thread that opened the surface, except post. */
#ifndef VIEWER_SURFACE_H
#define VIEWER_SURFACE_H

#include "app.h"

typedef void (*surface_call)(void);
/* Receiver of a surface's events. */
typedef void surface_sink(void *user, const app_event *event);

typedef struct surface surface;
struct surface {
    /* Fetch an OpenGL function, NULL if there is none: neither library is linked against for drawing, for both
     * export the same names. */
    surface_call (*get_proc)(const char *name);
    void (*get_size)(surface *s, int *width, int *height, double *scale);
    /* Deliver events; if there are none, sleep until one comes, or for so many seconds. */
    void (*wait)(surface *s, double seconds);
    void (*swap)(surface *s);
    void (*set_title)(surface *s, const char *title);
    /* Put text into the clipboard, if there is one. */
    void (*copy)(void *surface, const char *text);
    /* Take the whole screen, or give it back, where there is one. */
    void (*fill_screen)(surface *s, bool full);
    /* Hide the surface, before the end. */
    void (*hide)(surface *s);
    /* Wake the thread that waits. Any thread. */
    void (*post)(void *surface);
    void (*close)(surface *s);
    surface_sink *sink;
    /* A file was dropped on the window. */
    void (*take_file)(void *sink_user, const char *path);
    void *sink_user;
};

/* Open a window; NULL: `err` has the reason. */
surface *surface_glfw_open(int width, int height, const char *title, pov_error *err);
/* Memory, drawn into by OSMesa. It needs no display, and its only events are posted ones. */
surface *surface_osmesa_open(int width, int height, pov_error *err);
/* Set the size; for memory only. */
bool surface_osmesa_resize(surface *s, int width, int height);

#endif
