#include "session_state.h"

#include "say.h"

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>

enum { COARSEST = 16, POLITENESS = 5 };

static void warn(void *user, pov_log_level level, const pov_error *note)
{
    (void)user;
    if (level == POV_LOG_WARN)
        say("warning", note);
}

/* ---- the job ---- */

bool session_shows_job(const session *s)
{
    app_view v = s->app->view;

    return v == APP_PICTURE || v == APP_SAMPLES || v == APP_TIME || v == APP_ERROR;
}

static picture_kind kind_of(const app *a)
{
    switch (a->view) {
    case APP_SAMPLES: return PICTURE_SAMPLES;
    case APP_TIME: return PICTURE_TIME;
    case APP_ERROR: return PICTURE_ERROR;
    default: return a->compare == APP_DIFFERENCE ? PICTURE_DIFFERENCE : PICTURE_COLORS;
    }
}

static maps_kind map_of(app_view view)
{
    return view == APP_DEPTH ? MAPS_DEPTH : view == APP_CERTAINTY ? MAPS_CERTAINTY : MAPS_NORMAL;
}

static void fail(session *s, const pov_error *why)
{
    s->wrong = true;
    s->error = *why;
    s->app->orders |= APP_DRAW;
}

static void steer(session *s)
{
    if (s->job)
        pov_job_pause(s->job, s->app->paused || !session_shows_job(s));
}

static void draw_map(session *s)
{
    maps_request r = { map_of(s->app->view), app_camera(s->app), s->picture.width,
                       s->picture.height, s->app->orbit.reach };
    pov_error err = { 0 };

    if (session_shows_job(s) || !s->scene || !s->picture.pixels)
        return;
    if (!s->maps && maps_create(&s->maps, s->scene, s->desc.wake, s->desc.wake_user, &err) < 0)
        fail(s, &err);
    else
        maps_begin(s->maps, &r);
    s->middle = r.middle;
}

typedef struct start { pov_job *job; pov_status status; pov_error error; } start;

/* Threads inherit the priority of the thread that starts them, where threads have priorities of their own: on Linux. */
static void *start_politely(void *user)
{
    start *s = user;

#ifdef __linux__
    setpriority(PRIO_PROCESS, 0, POLITENESS);
#endif
    s->status = pov_job_start(s->job, &s->error);
    return NULL;
}

/* Tracing threads yield to the window's thread and to those of the driver. */
static pov_status start_job(pov_job *job, pov_error *err)
{
    start s = { job, POV_OK, { 0 } };
    pthread_t thread;

    if (pthread_create(&thread, NULL, start_politely, &s) != 0)
        return pov_job_start(job, err);
    pthread_join(thread, NULL);
    *err = s.error;
    return s.status;
}

/* Create a job of the window's size, replacing the old one, if any. */
static void make_job(session *s)
{
    pov_render_desc d = POV_INIT(d);
    pov_camera camera = app_camera(s->app);
    helper_waste old = { s->job, NULL, NULL, NULL };
    pov_error err = { 0 };

    helper_dispose(s->helper, &old);
    s->job = NULL;
    if (((s->picture.width != s->app->width || s->picture.height != s->app->height) &&
         !picture_resize(&s->picture, s->app->width, s->app->height)) ||
        !reference_fit(&s->reference, s->app->width, s->app->height)) {
        err.status = POV_E_MEMORY;
        snprintf(err.message, sizeof err.message, "no memory for a picture of this size");
        fail(s, &err);
        return;
    }
    d.width = s->picture.width;
    d.height = s->picture.height;
    d.preview = COARSEST;
    d.threads = s->desc.args->threads;
    d.samples = s->desc.args->samples;
    d.sampling = POV_SAMPLING_ADAPTIVE;
    d.target_error = s->desc.args->error;
    d.time_map = 1;
    d.camera = &camera;
    if (reference_fits(&s->reference, d.width, d.height)) {
        d.reference = s->reference.rgba;
        d.reference_clipped = s->reference.image.bits < 32;
    }
    d.wake = s->desc.wake;
    d.wake_user = s->desc.wake_user;
    if (pov_job_create(&s->job, s->scene, &d, &err) < 0) {
        fail(s, &err);
        return;
    }
    steer(s);
    if (!s->desc.by_steps && start_job(s->job, &err) < 0)
        fail(s, &err);
}

static void begin_anew(session *s)
{
    picture_restart(&s->picture);
    s->begun = s->now;
    s->worked = 0.0;
    s->restarts++;
    draw_map(s);
}

static void restart(session *s, bool resize)
{
    pov_camera camera = app_camera(s->app);

    if (!s->scene)
        return;
    if (resize || !s->job)
        make_job(s);
    else
        pov_job_restart(s->job, &camera);
    begin_anew(s);
}

/* ---- scenes ---- */

static void adopt(session *s, const helper_result *r)
{
    helper_waste old = { s->job, s->maps, s->tracer, s->scene };
    pov_camera camera = POV_INIT(camera);
    pov_scene_info info = POV_INIT(info);
    double reach = r->reach, size;
    pov_box box;
    bool again = s->scene != NULL && !s->fresh;

    helper_dispose(s->helper, &old);
    s->job = NULL;
    s->maps = NULL;
    s->scene = r->scene;
    s->tracer = r->tracer;
    s->wrong = false;
    pov_scene_get_info(s->scene, &info);
    s->info = info;
    pov_scene_get_camera(s->scene, &camera);
    size = session_measure(s->scene, &camera, &reach);
    s->app->has_scene = again;
    s->fresh = false;
    app_set_scene(s->app, &camera, reach, size, pov_scene_get_bounds(s->scene, &box) ? &box : NULL);
    make_job(s);
    begin_anew(s);
    if (s->picture.toned)
        picture_expose(&s->picture, info.transfer, app_gain(s->app));
    reference_expose(&s->reference, info.transfer, app_gain(s->app));
    if (again)
        app_say(s->app, s->now, "read again");
}

void session_load(session *s, const char *path)
{
    pov_error err = { 0 };

    if (helper_load(s->helper, path)) {
        s->loads++;
        return;
    }
    err.status = POV_E_ARGUMENT;
    snprintf(err.message, sizeof err.message, "the scene's path is too long");
    fail(s, &err);
}

void session_open_scene(session *s, const char *path)
{
    if (strlen(path) >= sizeof s->path) {
        app_say(s->app, s->now, "the scene's path is too long");
        return;
    }
    snprintf(s->path, sizeof s->path, "%s", path);
    file_watch_begin(&s->watch, s->path, s->now);
    s->snapshot = 0;
    s->app->choices = 0;
    s->stale = s->loads;
    s->fresh = true;
    session_load(s, s->path);
}

const recent *session_choices(const session *s)
{
    return s->path[0] ? NULL : &s->choices;
}

/* ---- from moment to moment ---- */

static void take_scene(session *s, const helper_result *r)
{
    helper_waste old = { NULL, NULL, r->tracer, r->scene };

    s->loads--;
    if (s->stale > 0) {
        s->stale--;
        helper_dispose(s->helper, &old);
    } else if (r->scene) {
        adopt(s, r);
    } else {
        fail(s, &r->error);
    }
}

static void take_results(session *s)
{
    helper_result r;

    while (helper_take(s->helper, &r)) {
        if (r.kind == HELPER_LOAD) {
            take_scene(s, &r);
        } else if (r.error.status < 0) {
            app_say(s->app, s->now, "not saved: %.130s", r.error.message);
        } else {
            app_say(s->app, s->now, "saved %.140s", r.path);
        }
    }
}

static void obey(session *s, unsigned orders)
{
    if (orders & (APP_RESTART | APP_RESIZE))
        restart(s, (orders & APP_RESIZE) != 0);
    if (orders & (APP_PAUSE | APP_VIEW))
        steer(s);
    if (orders & APP_VIEW) {
        if (session_shows_job(s)) {
            if (s->maps)
                maps_stop(s->maps);
            picture_show(&s->picture, kind_of(s->app));
        } else {
            draw_map(s);
        }
    }
    if (orders & APP_TONE) {
        picture_expose(&s->picture, s->info.transfer, app_gain(s->app));
        reference_expose(&s->reference, s->info.transfer, app_gain(s->app));
    }
    if (orders & APP_MARK)
        picture_mark(&s->picture, s->app->clipped);
    if (orders & APP_PRINT)
        session_print_camera(s);
    if (orders & APP_SNAPSHOT)
        session_save(s);
    if ((orders & APP_RELOAD) && s->path[0])
        session_load(s, s->path);
    if (orders & APP_OPEN)
        session_open_scene(s, s->choices.paths[s->app->chosen]);
}

static void look_at_job(session *s)
{
    pov_error err = { 0 };

    if (s->job && !s->wrong && pov_job_get_error(s->job, &err) < 0)
        fail(s, &err);
}

static void take_pixels(session *s, double budget)
{
    int first, last;

    s->unread = reference_update(&s->reference, budget);
    if (!s->job || !s->picture.pixels)
        return;
    if (session_shows_job(s)) {
        s->unread |= picture_update(&s->picture, s->job, budget);
    } else if (s->maps && maps_take(s->maps, s->picture.pixels, &first, &last)) {
        picture_touch(&s->picture, first, last);
    }
}

unsigned session_update(session *s, double now, double budget)
{
    unsigned orders;

    if (s->job && !s->app->paused && session_shows_job(s) && pov_job_wait(s->job, 0.0) == POV_JOB_RUNNING)
        s->worked += now - s->now;
    s->now = now;
    take_results(s);
    if (file_watch_changed(&s->watch, now))
        session_load(s, s->path);
    orders = app_update(s->app, now, s->scene && session_shows_job(s) && picture_is_covered(&s->picture));
    obey(s, orders);
    take_pixels(s, budget);
    look_at_job(s);
    return orders;
}

static double sooner(double a, double b)
{
    return a < 0.0 ? b : b < 0.0 || a < b ? a : b;
}

double session_patience(const session *s, double now)
{
    const double often_enough = 1.0;
    double left = sooner(app_patience(s->app, now), file_watch_patience(&s->watch, now));

    return s->unread ? 0.0 : sooner(left, often_enough);
}

bool session_is_settled(session *s)
{
    if (!helper_is_idle(s->helper) || s->loads > 0 || s->app->orders || s->app->moved || s->app->resized)
        return false;
    if (!s->job || s->wrong)
        return true;
    if (!session_shows_job(s))
        return s->maps && maps_is_done(s->maps);
    return !s->unread && (s->app->paused || s->desc.by_steps || pov_job_wait(s->job, 0.0) != POV_JOB_RUNNING);
}

void session_step(session *s, int passes)
{
    pov_progress p = POV_INIT(p);

    while (s->job && !s->app->paused && session_shows_job(s)) {
        pov_job_get_progress(s->job, &p);
        if (p.pass > passes || pov_job_step(s->job) != POV_JOB_RUNNING)
            return;
    }
}

/* ---- life ---- */

pov_status session_open(session **out, app *a, const session_desc *desc, pov_error *err)
{
    session *s = calloc(1, sizeof *s);
    pov_context_desc c = POV_INIT(c);
    pov_load_desc l = POV_INIT(l);
    pov_status status;

    if (!s) {
        err->status = POV_E_MEMORY;
        snprintf(err->message, sizeof err->message, "no memory to begin with");
        return POV_E_MEMORY;
    }
    s->app = a;
    s->desc = *desc;
    a->probe = session_probe;
    a->extent = session_extent;
    a->probe_user = s;
    c.log = warn;
    c.plugin_path = desc->args->plugin_path;
    l.dialect = desc->args->dialect;
    l.max_trace_level = desc->args->max_depth;
    l.threads = desc->args->threads;
    status = pov_context_create(&s->context, &c, err);
    if (status == POV_OK)
        status = reference_read(&s->reference, s->context, desc->args, err);
    a->reference_width = s->reference.image.width;
    a->reference_height = s->reference.image.height;
    s->picture.reference = &s->reference;
    if (status == POV_OK)
        status = helper_start(&s->helper, s->context, &l, desc->wake, desc->wake_user, err);
    if (status < 0) {
        session_close(s);
        return status;
    }
    helper_remember(s->helper, desc->remember);
    *out = s;
    if (desc->args->scene) {
        session_open_scene(s, desc->args->scene);
        return POV_OK;
    }
    recent_read(&s->choices);
    a->choices = s->choices.count;
    return POV_OK;
}

void session_close(session *s)
{
    if (!s)
        return;
    helper_stop(s->helper);
    pov_job_destroy(s->job);
    maps_destroy(s->maps);
    pov_tracer_destroy(s->tracer);
    pov_scene_destroy(s->scene);
    reference_free(&s->reference, s->context);
    pov_context_destroy(s->context);
    picture_free(&s->picture);
    free(s->traced.values);
    free(s);
}
