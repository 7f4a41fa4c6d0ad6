/* session.h - the displayed scene: its file, its job, its maps and the picture made so far. Executes the app's orders.
 * All calls are for the window's thread, and none of them waits for long. */
#ifndef VIEWER_SESSION_H
#define VIEWER_SESSION_H

#include "app.h"
#include "args.h"
#include "recent.h"

#include <povtrace/render.h>

typedef struct session session;

typedef struct session_desc {
    const args *args;
    void (*wake)(void *user);    /* called from any thread: session_update() has work */
    void (*copy)(void *user, const char *text);   /* to the clipboard */
    void *wake_user;             /* of both */
    bool by_steps;               /* session_step() traces, and no threads */
    bool remember;               /* scenes that were read become recent ones */
} session_desc;

/* The surface at a position in the picture. */
typedef struct session_place {
    int x, y;
    bool hit;
    const char *keyword;         /* keyword of the object, and its position in the text */
    int line, column;
    double distance;             /* in units of the scene */
    size_t hits;                 /* surfaces along the ray, from this one on */
    pov_vec3 point, normal;
    bool certain;
    float color[4];              /* linear colour of the job; alpha 0: not traced yet */
    bool compared;               /* there is a reference of this size, with this colour */
    float reference[3];
    float samples, error;        /* number of samples, and estimated error; below 0: not known */
    float seconds;               /* processor seconds of a pixel near it */
} session_place;

/* A thread loads the session's scene; session_update() takes it when it is complete. */
pov_status session_open(session **out, app *a, const session_desc *desc, pov_error *err);
/* Ends everything except the surface. Waits for the loading of a scene. NULL is allowed. */
void session_close(session *s);
/* Load another file in the scene's place. */
void session_load(session *s, const char *path);
/* Go over to another scene: its camera counts, and its file is watched. */
void session_open_scene(session *s, const char *path);
/* The scenes to choose from while there is none; NULL: there is one, or it is being read. */
const recent *session_choices(const session *s);
/* Take the threads' results, execute the app's orders, and copy new pixels into the picture for at most so many
 * seconds. Returns the app's orders. */
unsigned session_update(session *s, double now, double budget);
/* Seconds until session_update() is to be called without an event; 0: at once. */
double session_patience(const session *s, double now);

/* The picture: bytes red, green, blue, alpha; alpha 0 is not there yet. NULL: no scene was read so far. */
const uint8_t *session_pixels(const session *s, int *width, int *height);
/* The rows that have changed since the last call. False: none. */
bool session_take_rows(session *s, int *first, int *last);
/* The same for the reference; NULL: there is none. */
const uint8_t *session_reference_pixels(const session *s, int *width, int *height);
bool session_take_reference_rows(session *s, int *first, int *last);
const char *session_reference_path(const session *s);
/* The last pass's root mean square of the difference; below 0: not known. */
double session_reference_rms(const session *s);
/* Bytes of the pixel that is seen here, the reference's where that is in the picture's place. */
const uint8_t *session_seen_pixel(const session *s, int x, int y);
/* Depth of what is middle grey in the depth view, in units of the scene. */
double session_middle_depth(const session *s);
/* Pixels whose surface double precision decided, or double-double; of those traced so far. */
void session_count_certain(const session *s, size_t *certain, size_t *uncertain);
/* Pixels brighter than the display shows, and with a negative channel, while they are marked. */
void session_count_clipped(const session *s, size_t *above, size_t *below);
bool session_has_rows(const session *s);
/* Has each tile of the picture been read since the last restart? */
bool session_coarse_is_there(const session *s);
/* Time of the last restart while not even its coarse pass is complete; less than 0: it is, or another view is shown. */
double session_coarse_since(const session *s);
/* Is everything requested complete: scene, picture or map, files? */
bool session_is_settled(session *s);
/* Trace until the picture has so many passes, on this thread. */
void session_step(session *s, int passes);
unsigned long session_restarts(const session *s);

pov_context *session_context(session *s);
/* The reason why there is no scene of the file as it is now; NULL: there is one. */
const pov_error *session_error(const session *s);
/* The index-th pass of the picture since the restart; false past the last. */
bool session_get_pass(const session *s, size_t index, pov_pass *out);
bool session_inspect(session *s, session_place *out);
/* The numbers behind the pixels of a rectangle of the picture in this view, three floats for each of which so many count
 * as are returned; the first is NAN where nothing is known. Linear colours, normals, depths in units of the scene,
 * samples, microseconds, errors, differences from the reference, and 1 for double or 2 for double-double. */
int session_values(session *s, pov_rect r, float *out);
/* The window's title: name, per cent, what is left. */
void session_title(session *s, char *out, size_t size);

#endif
