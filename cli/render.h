/* render.h - from a loaded scene to an image file. */
#ifndef CLI_RENDER_H
#define CLI_RENDER_H

#include "messages.h"
#include "part.h"

typedef struct render {
    const args *args;
    const messages *messages;
    pov_context *context;
    const pov_scene *scene;
    pov_job *job;
    float *pixels;               /* four channels each, of the crop */
    int width, height;           /* of the crop */
    pov_image_options options;
    part_note note;              /* what a part's file says of the picture's */
    pov_progress progress;       /* at the end */
    double write_seconds;        /* of the last picture written */
    pov_bitmap reference;        /* what --reference names */
    bool short_of;               /* a budget ended it before the requested error or count was reached */
} render;

/* Can the output be written, as far as this is known before the work? */
pov_status render_check_output(pov_context *context, const args *a, pov_error *err);
/* Trace and write. A signal for an early end cancels the rest, and the present picture is written. Call render_free()
 * whatever the result. */
pov_status render_run(render *r, const args *a, const messages *m, pov_context *context,
                      const pov_scene *scene, pov_error *err);
void render_free(render *r);

#endif
