#include "loop.h"
#include "say.h"

#include <stdio.h>

enum { USUAL_WIDTH = 1024, USUAL_HEIGHT = 768 };

/* Duration of a measured drag, and the time limit of a whole picture, in seconds. */
static const double DRAG_SECONDS = 3.0, PICTURE_SECONDS = 10.0;
/* Events come from a mouse this often. */
static const double MOUSE_SECONDS = 0.008;

typedef struct figures { double load, preview, picture, restarts, frames, longest, work; bool whole; } figures;

/* Step until the scene is loaded; then count until all of its tiles have been drawn. */
static bool measure_first(viewer *v, figures *f)
{
    double loaded = 0.0;

    while (!v->app.has_scene) {
        loaded = viewer_now(v);
        if (!viewer_step(v) || session_error(v->session))
            return false;
        if (!v->app.has_scene)
            viewer_wait(v, 0.05);
    }
    while (!session_coarse_is_there(v->session) || viewer_is_behind(v)) {
        viewer_wait(v, 0.05);
        if (!viewer_step(v))
            return false;
    }
    f->load = loaded;
    f->preview = viewer_now(v) - loaded;
    return true;
}

/* Move the pointer in a circle with the left button held. */
static bool measure_drag(viewer *v, figures *f)
{
    app_event button = { APP_BUTTON, APP_LEFT, true, 0.0, 0.0, 1.0 };
    app_event pointer = { APP_POINTER, 0, false, 0.5 * v->app.width, 0.5 * v->app.height, 1.0 };
    double start = viewer_now(v), now = start;
    unsigned long restarts = session_restarts(v->session), frames = v->frames;

    v->surface->sink(v, &pointer);
    v->surface->sink(v, &button);
    while (now - start < DRAG_SECONDS) {
        pointer.x = v->app.width * (0.5 + 0.2 * sin(2.0 * (now - start)));
        pointer.y = v->app.height * (0.5 + 0.1 * cos(2.0 * (now - start)));
        v->surface->sink(v, &pointer);
        if (!viewer_step(v))
            return false;
        viewer_wait(v, MOUSE_SECONDS);
        now = viewer_now(v);
    }
    button.down = false;
    v->surface->sink(v, &button);
    f->restarts = (double)(session_restarts(v->session) - restarts) / (now - start);
    f->frames = (double)(v->frames - frames) / (now - start);
    return true;
}

static bool measure_whole(viewer *v, figures *f)
{
    double start = viewer_now(v);

    do {
        if (!viewer_step(v))
            return false;
        viewer_wait(v, 0.05);
        f->whole = session_is_settled(v->session);
    } while (!f->whole && viewer_now(v) - start < PICTURE_SECONDS);
    viewer_step(v);
    f->picture = viewer_now(v) - start;
    return true;
}

static void print(const viewer *v, const figures *f, bool window)
{
    printf("surface: %s\n", window ? "window" : "memory");
    printf("size: %d x %d\n", v->app.width, v->app.height);
    printf("load: %.4f s\n", f->load);
    printf("first_preview: %.4f s\n", f->preview);
    printf("restarts: %.1f /s\n", f->restarts);
    printf("frames: %.1f /s\n", f->frames);
    if (f->whole)
        printf("picture: %.4f s\n", f->picture);
    printf("longest_block: %.4f s\n", f->longest);
    printf("longest_work: %.4f s\n", f->work);
}

int bench_run(const args *a)
{
    int width = a->width > 0 ? a->width : USUAL_WIDTH, height = a->height > 0 ? a->height : USUAL_HEIGHT;
    pov_error err = { 0 };
    surface *window = surface_glfw_open(width, height, "povview", &err), *s = window;
    figures f = { 0 };
    viewer v;
    bool done;

    if (!s)
        s = surface_osmesa_open(width, height, &err);
    if (!s || viewer_open(&v, a, s, false, &err) < 0) {
        say("error", &err);
        return 1;
    }
    done = measure_first(&v, &f) && measure_drag(&v, &f) && measure_whole(&v, &f);
    f.longest = v.longest;
    f.work = v.longest_work;
    if (done)
        print(&v, &f, window != NULL);
    else if (session_error(v.session))
        say("error", session_error(v.session));
    viewer_close(&v);
    return done ? 0 : 1;
}
