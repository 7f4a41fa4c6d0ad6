#include "loop.h"
#include "say.h"
#include "script.h"

#include <povtrace/image.h>

#include <stdio.h>
#include <stdlib.h>

enum { USUAL_WIDTH = 1024, USUAL_HEIGHT = 768 };

/* The clock of a shot advances by this with each step, so that nothing waits for it or depends on it. */
static const double TICK_SECONDS = 10.0;

static void tick(viewer *v)
{
    v->fixed_clock += TICK_SECONDS;
    viewer_step(v);
}

void shot_settle(viewer *v)
{
    for (;;) {
        viewer_step(v);
        if (v->args.frames > 0)
            session_step(v->session, v->args.frames);
        if (session_is_settled(v->session))
            break;
        viewer_wait(v, 0.05);
    }
    viewer_step(v);
}

static void send(viewer *v, app_event_kind kind, int code, bool down, double x, double y)
{
    app_event event = { kind, code, down, x, y, v->app.scale };

    app_take(&v->app, &event, v->fixed_clock);
}

/* Drag from the centre, and move the pointer back. */
static void drag(viewer *v, int button, double x, double y)
{
    double old_x = v->app.x, old_y = v->app.y, left = 0.5 * v->app.width, top = 0.5 * v->app.height;

    send(v, APP_POINTER, 0, false, left, top);
    send(v, APP_BUTTON, button, true, 0.0, 0.0);
    send(v, APP_POINTER, 0, false, left + x, top + y);
    send(v, APP_BUTTON, button, false, 0.0, 0.0);
    send(v, APP_POINTER, 0, false, old_x, old_y);
}

static void fly(viewer *v, const char *keys, double seconds)
{
    send(v, APP_BUTTON, APP_RIGHT, true, 0.0, 0.0);
    for (const char *k = keys; *k; k++)
        send(v, APP_KEY, *k, true, 0.0, 0.0);
    v->fixed_clock += seconds;
    viewer_step(v);
    for (const char *k = keys; *k; k++)
        send(v, APP_KEY, *k, false, 0.0, 0.0);
    send(v, APP_BUTTON, APP_RIGHT, false, 0.0, 0.0);
}

static void play(viewer *v, const script_step *step)
{
    switch (step->kind) {
    case SCRIPT_CHARACTER:
        /* Pictures are saved when they are complete. */
        if (step->code == 's' || step->code == 'S')
            shot_settle(v);
        send(v, APP_CHARACTER, step->code, true, 0.0, 0.0);
        break;
    case SCRIPT_KEY: send(v, APP_KEY, step->code, true, 0.0, 0.0); break;
    case SCRIPT_DRAG: drag(v, APP_LEFT, step->x, step->y); break;
    case SCRIPT_PAN: drag(v, APP_MIDDLE, step->x, step->y); break;
    case SCRIPT_LOOK: drag(v, APP_RIGHT, step->x, step->y); break;
    case SCRIPT_MOVE: send(v, APP_POINTER, 0, false, step->x, step->y); break;
    case SCRIPT_WHEEL: send(v, APP_WHEEL, 0, false, 0.0, step->x); break;
    case SCRIPT_FLY: fly(v, step->word, step->x); break;
    case SCRIPT_SIZE: surface_osmesa_resize(v->surface, (int)step->x, (int)step->y); break;
    case SCRIPT_LOAD:
        /* The picture of the previous scene would stand under a message. */
        shot_settle(v);
        session_load(v->session, step->word);
        shot_settle(v);
        break;
    case SCRIPT_END: break;
    }
    tick(v);
}

void shot_play(viewer *v, const char *keys)
{
    char problem[128];
    script_step step;

    while (script_next(&keys, &step, problem, sizeof problem) && step.kind != SCRIPT_END)
        play(v, &step);
}

bool shot_wait_for_scene(viewer *v)
{
    while (!v->app.has_scene && !session_error(v->session)) {
        viewer_wait(v, 0.05);
        viewer_step(v);
    }
    return v->app.has_scene;
}

static pov_status write_drawing(viewer *v, pov_error *err)
{
    size_t values = (size_t)v->app.width * (size_t)v->app.height * 4;
    pov_image_options options = POV_INIT(options);
    uint8_t *bytes = malloc(values);
    float *rgba = malloc(values * sizeof *rgba);
    pov_status status = POV_E_MEMORY;

    options.transfer = POV_TRANSFER_LINEAR;
    if (bytes && rgba) {
        present_read(v->present, v->app.width, v->app.height, bytes);
        for (size_t i = 0; i < values; i++)
            rgba[i] = (float)(bytes[i] / 255.0);
        status = pov_image_write(session_context(v->session), v->args.shot, v->app.width, v->app.height, rgba,
                                 (size_t)v->app.width * 4 * sizeof *rgba, &options, err);
    } else {
        err->status = status;
        snprintf(err->message, sizeof err->message, "no memory to write a picture");
    }
    free(bytes);
    free(rgba);
    return status;
}

static pov_status take(viewer *v, pov_error *err)
{
    pov_status status = pov_image_check(session_context(v->session), v->args.shot, NULL, err);

    if (status < 0)
        return status;
    v->fixed_clock = 0.0;
    if (!shot_wait_for_scene(v)) {
        *err = *session_error(v->session);
        return err->status;
    }
    shot_play(v, v->args.keys);
    shot_settle(v);
    tick(v);
    return write_drawing(v, err);
}

int shot_run(const args *a)
{
    int width = a->width > 0 ? a->width : USUAL_WIDTH, height = a->height > 0 ? a->height : USUAL_HEIGHT;
    pov_error err = { 0 };
    surface *s = surface_osmesa_open(width, height, &err);
    viewer v;

    if (s && viewer_open(&v, a, s, a->frames > 0, &err) == POV_OK) {
        take(&v, &err);
        viewer_close(&v);
    }
    if (err.status == POV_OK)
        return 0;
    say("error", &err);
    return 1;
}
