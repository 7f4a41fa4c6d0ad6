/* session_state.h - the state of a session, for the files that advance it (session.c) and that query it
 * (session_ask.c). */
#ifndef VIEWER_SESSION_STATE_H
#define VIEWER_SESSION_STATE_H

#include "file_watch.h"
#include "helper.h"
#include "picture.h"
#include "session.h"

/* The last values that were traced for pixels, and for which. */
typedef struct session_traced {
    float *values;
    app_view view;
    unsigned long restarts;
    pov_camera camera;
    pov_rect rect;
} session_traced;

struct session {
    app *app;
    session_desc desc;
    pov_context *context;
    helper *helper;
    char path[RECENT_PATH];      /* the scene's; "" for none */
    recent choices;              /* while there is none */
    file_watch watch;

    pov_scene *scene;            /* the members below belong to this scene; NULL: none was loaded so far */
    pov_tracer *tracer;
    maps *maps;                  /* made when first asked for */
    double middle;               /* the middle depth of the last one, in lengths of the direction */
    pov_job *job;
    pov_scene_info info;
    picture picture;
    session_traced traced;
    reference reference;

    bool unread;                 /* the job has more changed tiles */
    bool wrong;
    pov_error error;
    int loads;                   /* requested and not answered */
    int stale;                   /* of these, of a scene that another one was opened after */
    bool fresh;                  /* the next scene is another one than was shown */
    int snapshot;                /* the last one's number */
    double now, begun, worked;   /* the clock; when the job began anew, and for how long it has worked since */
    unsigned long restarts;
};

/* Is the view one of the job's? Other views are traced separately, while the job rests. */
bool session_shows_job(const session *s);

/* Is the reference seen in this column? Not while the picture still has another size. */
bool session_shows_reference(const session *s, int x);

/* Write what is seen to a file; print and copy the camera. */
void session_save(session *s);
void session_print_camera(session *s);
/* The queries of the app, with a session. */
double session_probe(void *session, double x, double y);
bool session_extent(void *session, double x, double y, pov_box *out);
/* The length in the scene of what depths are counted in. */
double session_depth_unit(const session *s);
/* Size of the scene, and the distance to its centre if the camera looks at nothing. */
double session_measure(const pov_scene *scene, const pov_camera *camera, double *reach);

#endif
