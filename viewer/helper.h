/* helper.h - a thread for slow tasks, so that the window's never waits: loading scenes, writing pictures, and freeing
 * unused objects. Tasks are done in order. */
#ifndef VIEWER_HELPER_H
#define VIEWER_HELPER_H

#include "maps.h"

#include <povtrace/render.h>

typedef struct helper helper;

typedef enum helper_kind { HELPER_LOAD, HELPER_SAVE, HELPER_DISPOSE } helper_kind;

/* A picture to write: a job's, or bytes that were copied for it, which the task frees. */
typedef struct helper_picture {
    pov_job *job;
    uint8_t *bytes;
    int width, height;
    double gain;
    pov_transfer transfer;
} helper_picture;

/* Objects that are freed together; any of them may be NULL. */
typedef struct helper_waste { pov_job *job; maps *maps; pov_tracer *tracer; pov_scene *scene; } helper_waste;

typedef struct helper_result {
    helper_kind kind;
    pov_scene *scene;            /* of HELPER_LOAD: the caller's now; NULL: error says why */
    pov_tracer *tracer;          /* with it */
    double reach;                /* of what the scene's camera looks at, in lengths of its direction; 0: nothing */
    pov_error error;
    char path[512];
} helper_result;

pov_status helper_start(helper **out, pov_context *context, const pov_load_desc *desc, void (*wake)(void *),
                        void *wake_user, pov_error *err);
/* Finishes all tasks, then ends. NULL is allowed. */
void helper_stop(helper *h);
/* Put scenes that were read on the list of recent ones. Before the first task. */
void helper_remember(helper *h, bool remember);
bool helper_load(helper *h, const char *path);
bool helper_save(helper *h, const char *path, const helper_picture *picture);
/* Without memory for a task it is done on this thread. */
void helper_dispose(helper *h, const helper_waste *waste);
/* The next result, or false; never waits for the thread's work. */
bool helper_take(helper *h, helper_result *out);
/* Are there no tasks and no results? */
bool helper_is_idle(helper *h);

#endif
