/* session.h - the scene that is watched: its file, its job, its maps and the picture that they have made so far. Does
 * what the app orders. All calls are for the window's thread, and none of them waits for long. */
#ifndef VIEWER_SESSION_H
#define VIEWER_SESSION_H

#include "app.h"
#include "args.h"

#include <povtrace/render.h>

typedef struct session session;

typedef struct session_desc {
    const args *args;
    void (*wake)(void *user);    /* from any thread: there is something for session_update() */
    void *wake_user;
    bool by_steps;               /* no threads trace, but session_step() does */
} session_desc;

/* What is at a place in the picture. */
typedef struct session_place {
    int x, y;
    bool hit;
    const char *keyword;         /* of the object, and where it stands in the text */
    int line, column;
    double distance;             /* in units of the scene */
    size_t hits;                 /* surfaces on the way, this one and those behind it */
    pov_vec3 point, normal;
    bool certain;
    float color[4];              /* linear, as the job has it; alpha 0: not traced yet */
    float samples, error;        /* how many, and how far off they may be; below 0: not known */
    float seconds;               /* of the processor, that a pixel near it has taken */
} session_place;

/* The session's scene will be read by a thread; session_update() takes it when it is there. */
pov_status session_open(session **out, app *a, const session_desc *desc, pov_error *err);
/* Ends everything but the surface. Waits for the reading of a scene. NULL is allowed. */
void session_close(session *s);
/* Read a file in the scene's place. */
void session_load(session *s, const char *path);
/* Take what the threads have, do what the app orders, and bring what is new into the picture for at most so many
 * seconds. Returns the app's orders. */
unsigned session_update(session *s, double now, double budget);
/* Seconds until session_update() is to be called without an event; 0: at once. */
double session_patience(const session *s, double now);

/* The picture: bytes red, green, blue, alpha; alpha 0 is not there yet. NULL: no scene was read so far. */
const uint8_t *session_pixels(const session *s, int *width, int *height);
/* The rows that have changed since the last call. False: none. */
bool session_take_rows(session *s, int *first, int *last);
bool session_has_rows(const session *s);
/* Has each tile of the picture been seen since the last restart? */
bool session_coarse_is_there(const session *s);
/* When the picture was begun anew, as long as not even its coarse one is whole; less than 0: it is, or another view is
 * shown. */
double session_coarse_since(const session *s);
/* Is all there that was asked for: scene, picture or map, files? */
bool session_is_settled(session *s);
/* Trace until the picture has so many passes, on this thread. */
void session_step(session *s, int passes);
unsigned long session_restarts(const session *s);

pov_context *session_context(session *s);
/* Why there is no scene, or none of the file as it is now; NULL: there is. */
const pov_error *session_error(const session *s);
/* The index-th pass of the picture since it was begun; false past the last. */
bool session_get_pass(const session *s, size_t index, pov_pass *out);
bool session_inspect(session *s, session_place *out);
/* The window's title: name, per cent, what is left. */
void session_title(session *s, char *out, size_t size);

#endif
