/* session_state.h - the inside of a session, for the files that move it on (session.c) and that ask it (session_ask.c). */
#ifndef VIEWER_SESSION_STATE_H
#define VIEWER_SESSION_STATE_H

#include "file_watch.h"
#include "helper.h"
#include "picture.h"
#include "session.h"

struct session {
    app *app;
    session_desc desc;
    pov_context *context;
    helper *helper;
    file_watch watch;

    pov_scene *scene;            /* all that follows is of this scene; NULL: none was read so far */
    pov_tracer *tracer;
    maps *maps;                  /* made when first asked for */
    pov_job *job;
    pov_scene_info info;
    picture picture;

    bool unread;                 /* the job has more to take */
    bool wrong;
    pov_error error;
    int loads;                   /* asked for and not answered */
    int snapshot;                /* the last one's number */
    double now, begun, worked;   /* the clock; when the job began anew, and for how long it has worked since */
    unsigned long restarts;
};

/* Does the view come from the job? The others are traced apart, and the job rests meanwhile. */
bool session_shows_job(const session *s);

#endif
