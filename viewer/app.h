/* app.h - the viewer's state: events go in, orders come out. No window, no OpenGL, no thread; the only queries to a scene
 * are a distance and an extent. Positions are in pixels of the framebuffer, from its upper left corner. */
#ifndef VIEWER_APP_H
#define VIEWER_APP_H

#include "orbit.h"
#include "zoom.h"

/* Keys with a printed capital are named by its ASCII code, others by these. */
enum { APP_KEY_ENTER = 256, APP_KEY_TAB, APP_KEY_ESCAPE, APP_KEY_F1, APP_KEY_F5, APP_KEY_F11, APP_KEY_SHIFT,
       APP_KEY_HOME, APP_KEY_CONTROL, APP_KEY_UP, APP_KEY_DOWN, APP_KEY_PAGE_UP, APP_KEY_PAGE_DOWN };
enum { APP_LEFT, APP_RIGHT, APP_MIDDLE, APP_BUTTONS };

typedef enum app_event_kind {
    APP_CHARACTER,           /* code: the typed character, whatever keys it took */
    APP_KEY,                 /* code, down */
    APP_BUTTON,              /* code, down */
    APP_POINTER,             /* x, y */
    APP_WHEEL,               /* y: steps, away from the user is positive */
    APP_SIZE,                /* x, y: of the framebuffer; scale */
    APP_LEAVE,               /* the window has lost its focus: no key is held any more */
    APP_CLOSE
} app_event_kind;

typedef struct app_event { app_event_kind kind; int code; bool down; double x, y, scale; } app_event;

/* Orders to the session, as a set of bits. */
enum {
    APP_DRAW = 1,            /* the view has changed */
    APP_RESTART = 2,         /* restart with app_camera() */
    APP_RESIZE = 4,          /* the same, with a picture of another size */
    APP_RELOAD = 8,
    APP_PRINT = 16,          /* the camera, to standard output */
    APP_SNAPSHOT = 32,
    APP_PAUSE = 64,          /* `paused` has changed */
    APP_TONE = 128,          /* `exposure` has changed */
    APP_VIEW = 256,          /* `view` has changed */
    APP_QUIT = 512,
    APP_MARK = 1024,         /* `clipped` has changed */
    APP_FULL = 2048,         /* `full` has changed */
    APP_OPEN = 4096          /* read the scene `chosen` of the start page */
};

typedef enum app_view {
    APP_PICTURE, APP_NORMAL, APP_DEPTH, APP_SAMPLES, APP_TIME, APP_ERROR, APP_CERTAINTY, APP_VIEWS
} app_view;
/* The picture, or what is seen of its reference instead: all of it, how far they differ, or the part left of the
 * pointer. */
typedef enum app_compare { APP_PLAIN, APP_REFERENCE, APP_DIFFERENCE, APP_WIPE } app_compare;
typedef enum app_drag { APP_NO_DRAG, APP_ORBIT, APP_PAN, APP_FLY, APP_SHIFT } app_drag;

/* Distance to a surface along orbit_ray(x, y), in lengths of that ray; not positive: none. */
typedef double app_probe(void *user, double x, double y);

/* A box around what is seen of the object at (x, y). False: there is none. */
typedef bool app_extent(void *user, double x, double y, pov_box *out);

typedef struct app {
    orbit orbit;
    bool has_scene;
    bool sized;              /* the user has set the size of the picture: it has povc's aspect ratio */
    double size;             /* of the scene, for the speed of flight */
    int width, height;
    double scale;            /* of text, for displays with small pixels */
    double x, y;             /* the pointer */
    zoom zoom;
    double zoomed;           /* when the wheel last changed it */
    app_drag drag;
    int drag_button;
    bool shift, control;
    unsigned flying;         /* a bit for each of the keys WASDQE that is held */
    double flown;            /* time up to which flight was computed */
    app_view view;
    app_compare compare;     /* with APP_PICTURE only */
    int reference_width, reference_height;   /* 0: there is no reference */
    int exposure;            /* in thirds of a stop */
    bool clipped;            /* mark what the display cannot show */
    bool paused, help, inspect, curve;
    bool full;               /* all of the screen is wanted */
    double help_from, help_below;   /* pixels of the help above the shown part, at present and at most */
    bool greets;             /* a word on the help when the first scene is there */
    bool moved, resized;     /* the job has not been told yet */
    double restarted;
    unsigned orders;
    char note[160];          /* a word to the user, until */
    double note_until;
    int choices, chosen;     /* scenes on the start page, and the one whose number was typed */
    bool has_box;
    pov_box box;             /* around the finite objects */
    app_probe *probe;
    app_extent *extent;
    void *probe_user;
} app;

void app_init(app *a, int width, int height, app_probe *probe, void *probe_user);
/* A scene was loaded: its camera, its size, a box around its finite objects or NULL. */
void app_set_scene(app *a, const pov_camera *camera, double reach, double size, const pov_box *box);
void app_take(app *a, const app_event *event, double now);
/* Advance the flight to the present time, and return the orders. While the camera moves, the picture is restarted
 * whenever its first coarse pass is complete, and at least 20 times a second. */
unsigned app_update(app *a, double now, bool coarse_is_there);
/* Seconds until app_update() has work without an event; less than 0: never. */
double app_patience(const app *a, double now);
/* So many pixels of the help do not fit into the window. */
void app_fit_help(app *a, double below);
void app_scroll_help(app *a, double lines);
void app_say(app *a, double now, const char *format, ...) POV_PRINTF(3, 4);
pov_camera app_camera(const app *a);
/* Magnify or show more, about the pointer. */
void app_zoom(app *a, double steps, double now);
/* Compare with the reference, or no more; says why where that cannot be. */
void app_compare_with(app *a, app_compare how, double now);
/* Is the reference seen in this column of the picture? */
bool app_shows_reference(const app *a, double x);
/* Where the pointer is in the picture, in its pixels. */
void app_pointed(const app *a, double *x, double *y);
const char *app_view_name(app_view view);
/* Factor of light before display. */
double app_gain(const app *a);

#endif
