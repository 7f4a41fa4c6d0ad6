#include "loop.h"

#include <math.h>
#include <string.h>
#include <time.h>

/* Longest time of copying pixels between two checks for events. */
static const double PIXEL_SECONDS = 0.008;
/* No display shows more pictures a second, and drawing unseen ones takes time from the tracing threads. */
static const double FRAME_SECONDS = 1.0 / 60.0;
/* After a restart the first picture is drawn when its coarse pass is complete, because earlier drawing delays it. A
 * slow picture is drawn in parts, this often. */
static const double PART_SECONDS = 0.045;

static double seconds_of(clockid_t clock)
{
    struct timespec t;

    clock_gettime(clock, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static double clock_seconds(void)
{
    return seconds_of(CLOCK_MONOTONIC);
}

static void take_event(void *user, const app_event *event)
{
    viewer *v = user;
    double start = clock_seconds();

    app_take(&v->app, event, viewer_now(v));
    v->in_events += clock_seconds() - start;
}

static void take_file(void *user, const char *path)
{
    viewer *v = user;

    session_open_scene(v->session, path);
}

double viewer_now(const viewer *v)
{
    return v->fixed_clock >= 0.0 ? v->fixed_clock : clock_seconds() - v->began;
}

static void draw(viewer *v)
{
    const app *a = &v->app;
    present_look look = { &a->zoom, 0.0 };
    const uint8_t *pixels;
    int width, height, first, last;
    double scale;

    pixels = session_pixels(v->session, &width, &height);
    look.reference_right = a->compare == APP_REFERENCE ? a->width : a->compare == APP_WIPE ? floor(a->x) : 0.0;
    if (session_take_rows(v->session, &first, &last))
        present_picture(v->present, pixels, width, height, first, last);
    pixels = session_reference_pixels(v->session, &width, &height);
    if (session_take_reference_rows(v->session, &first, &last))
        present_reference(v->present, pixels, width, height, first, last);
    v->drawn = viewer_now(v);
    v->behind = false;
    v->surface->get_size(v->surface, &width, &height, &scale);
    /* A minimised window has no size. */
    if (width < 1 || height < 1)
        return;
    present_draw(v->present, &look, width, height);
    v->surface->swap(v->surface);
    v->frames++;
}

pov_status viewer_open(viewer *v, const args *a, surface *s, bool by_steps, pov_error *err)
{
    session_desc desc = { &v->args, s->post, s->copy, s, by_steps, a->remember };
    app_event size = { APP_SIZE, 0, false, 0.0, 0.0, 1.0 };
    present_look look = { &v->app.zoom, 0.0 };
    pov_status status;
    int width, height;

    memset(v, 0, sizeof *v);
    v->args = *a;
    v->surface = s;
    v->began = clock_seconds();
    v->fixed_clock = -1.0;
    v->drawn = -1.0;
    s->get_size(s, &width, &height, &size.scale);
    app_init(&v->app, width, height, NULL, NULL);
    v->app.sized = a->width > 0;
    size.x = width;
    size.y = height;
    app_take(&v->app, &size, 0.0);
    s->sink = take_event;
    s->sink_user = v;
    status = present_create(&v->present, s, err);
    /* Drivers allocate memory and compile shaders at the first draw: do it now, while nothing is shown. */
    if (status == POV_OK) {
        present_nothing(v->present, width, height);
        present_draw(v->present, &look, width, height);
        s->swap(s);
    }
    if (status == POV_OK)
        status = session_open(&v->session, &v->app, &desc, err);
    s->take_file = status == POV_OK ? take_file : NULL;
    if (status < 0)
        viewer_close(v);
    return status;
}

/* Threads wake the surface, so they must end before it; their remaining results are not needed. */
void viewer_close(viewer *v)
{
    v->surface->sink = NULL;
    v->surface->take_file = NULL;
    v->surface->hide(v->surface);
    session_close(v->session);
    overlay_free(&v->overlay);
    present_destroy(v->present);
    v->surface->close(v->surface);
}

static void show_title(viewer *v)
{
    char title[sizeof v->title];

    session_title(v->session, title, sizeof title);
    if (strcmp(title, v->title) == 0)
        return;
    memcpy(v->title, title, sizeof title);
    v->surface->set_title(v->surface, title);
}

/* Time of the next drawing. */
static double due(const viewer *v)
{
    double since = session_coarse_since(v->session);

    if (!v->behind && !session_has_rows(v->session))
        return HUGE_VAL;
    return v->behind || since < 0.0 ? v->drawn + FRAME_SECONDS : fmax(v->drawn, since) + PART_SECONDS;
}

bool viewer_is_behind(const viewer *v)
{
    return due(v) < HUGE_VAL;
}

bool viewer_step(viewer *v)
{
    bool in_hurry = v->fixed_clock < 0.0;
    double start = clock_seconds(), worked = seconds_of(CLOCK_THREAD_CPUTIME_ID), busy;
    unsigned orders = session_update(v->session, viewer_now(v), in_hurry ? PIXEL_SECONDS : 1e9);
    bool changed = overlay_update(&v->overlay, &v->app, v->session, v->present);

    app_fit_help(&v->app, overlay_help_below(&v->overlay));
    if (orders & APP_FULL)
        v->surface->fill_screen(v->surface, v->app.full);

    /* A restart alone changes nothing visible. */
    v->behind = v->behind || (orders & ~(unsigned)APP_RESTART) || changed;
    if (in_hurry ? viewer_now(v) >= due(v) : viewer_is_behind(v))
        draw(v);
    show_title(v);
    busy = clock_seconds() - start + v->in_events;
    worked = seconds_of(CLOCK_THREAD_CPUTIME_ID) - worked;
    v->in_events = 0.0;
    v->longest_work = worked > v->longest_work ? worked : v->longest_work;
    v->longest = busy > v->longest ? busy : v->longest;
    return !(orders & APP_QUIT);
}

void viewer_wait(viewer *v, double most)
{
    double now = viewer_now(v), patience = fmin(session_patience(v->session, now), fmax(due(v) - now, 0.0));

    v->surface->wait(v->surface, fmin(patience, most));
}

void viewer_run(viewer *v)
{
    while (viewer_step(v))
        viewer_wait(v, 1.0);
}
