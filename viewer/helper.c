#include "helper.h"

#include "recent.h"

#include <povtrace/image.h>

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct task task;
struct task {
    task *next;
    helper_picture picture;
    helper_waste waste;
    helper_result result;
};

typedef struct list { task *first, **end; } list;

struct helper {
    pov_context *context;
    pov_load_desc desc;
    void (*wake)(void *user);
    void *wake_user;
    bool remember;
    pthread_t thread;
    pthread_mutex_t lock;        /* guards all below */
    pthread_cond_t changed;
    list tasks, results;
    bool closing, busy;
};

static void append(list *l, task *t)
{
    t->next = NULL;
    *l->end = t;
    l->end = &t->next;
}

static task *detach(list *l)
{
    task *t = l->first;

    if (t)
        l->first = t->next;
    if (!l->first)
        l->end = &l->first;
    return t;
}

static void dispose(const helper_waste *w)
{
    pov_job_destroy(w->job);
    maps_destroy(w->maps);
    pov_tracer_destroy(w->tracer);
    pov_scene_destroy(w->scene);
}

/* ---- the work ---- */

static void look_ahead(helper_result *r)
{
    pov_camera camera = POV_INIT(camera);
    pov_hit hit = POV_INIT(hit);

    pov_scene_get_camera(r->scene, &camera);
    if (pov_trace_hit(r->tracer, camera.location, camera.direction, &hit))
        r->reach = hit.distance;
}

static void load(helper *h, helper_result *r)
{
    if (pov_scene_load_file(&r->scene, h->context, r->path, &h->desc, &r->error) < 0)
        return;
    if (pov_tracer_create(&r->tracer, r->scene, &r->error) < 0) {
        pov_scene_destroy(r->scene);
        r->scene = NULL;
        return;
    }
    look_ahead(r);
    if (h->remember && strcmp(r->path, "-") != 0)
        recent_add(r->path);
}

static void fill(const helper_picture *p, float *rgba)
{
    size_t values = (size_t)p->width * (size_t)p->height * 4;
    pov_rect all = { 0, 0, p->width, p->height };

    if (p->bytes) {
        for (size_t i = 0; i < values; i++)
            rgba[i] = (float)(p->bytes[i] / 255.0);
        return;
    }
    pov_job_read(p->job, all, POV_PIXELS_LINEAR_FLOAT, rgba, (size_t)p->width * 4 * sizeof *rgba);
    for (size_t i = 0; i < values && p->gain != 1.0; i++)
        rgba[i] = (float)(rgba[i] * p->gain);
}

static void save(helper *h, const helper_picture *p, helper_result *r)
{
    size_t row = (size_t)p->width * 4 * sizeof(float);
    float *rgba = malloc(row * (size_t)p->height);
    pov_image_options options = POV_INIT(options);

    options.transfer = p->transfer;
    if (rgba) {
        fill(p, rgba);
        pov_image_write(h->context, r->path, p->width, p->height, rgba, row, &options, &r->error);
    } else {
        r->error.status = POV_E_MEMORY;
        snprintf(r->error.message, sizeof r->error.message, "no memory to save a picture");
    }
    free(rgba);
    free(p->bytes);
}

static void work(helper *h, task *t)
{
    switch (t->result.kind) {
    case HELPER_LOAD: load(h, &t->result); break;
    case HELPER_SAVE: save(h, &t->picture, &t->result); break;
    case HELPER_DISPOSE: dispose(&t->waste); break;
    }
}

static void *run(void *user)
{
    helper *h = user;

    pthread_mutex_lock(&h->lock);
    while (!h->closing || h->tasks.first) {
        task *t = detach(&h->tasks);
        bool tell;

        if (!t) {
            pthread_cond_wait(&h->changed, &h->lock);
            continue;
        }
        h->busy = true;
        tell = t->result.kind != HELPER_DISPOSE;
        pthread_mutex_unlock(&h->lock);
        work(h, t);
        pthread_mutex_lock(&h->lock);
        h->busy = false;
        if (tell)
            append(&h->results, t);
        else
            free(t);
        pthread_mutex_unlock(&h->lock);
        if (h->wake)
            h->wake(h->wake_user);
        pthread_mutex_lock(&h->lock);
    }
    pthread_mutex_unlock(&h->lock);
    return NULL;
}

/* ---- asking for it ---- */

pov_status helper_start(helper **out, pov_context *context, const pov_load_desc *desc, void (*wake)(void *),
                        void *wake_user, pov_error *err)
{
    helper *h = calloc(1, sizeof *h);

    if (h) {
        h->context = context;
        h->desc = *desc;
        h->wake = wake;
        h->wake_user = wake_user;
        h->tasks.end = &h->tasks.first;
        h->results.end = &h->results.first;
        pthread_mutex_init(&h->lock, NULL);
        pthread_cond_init(&h->changed, NULL);
        if (pthread_create(&h->thread, NULL, run, h) == 0) {
            *out = h;
            return POV_OK;
        }
    }
    free(h);
    err->status = POV_E_MEMORY;
    snprintf(err->message, sizeof err->message, "no thread could be started");
    return POV_E_MEMORY;
}

void helper_stop(helper *h)
{
    helper_result left;

    if (!h)
        return;
    pthread_mutex_lock(&h->lock);
    h->closing = true;
    pthread_cond_signal(&h->changed);
    pthread_mutex_unlock(&h->lock);
    pthread_join(h->thread, NULL);
    while (helper_take(h, &left)) {
        pov_tracer_destroy(left.tracer);
        pov_scene_destroy(left.scene);
    }
    pthread_cond_destroy(&h->changed);
    pthread_mutex_destroy(&h->lock);
    free(h);
}

static void ask(helper *h, task *t)
{
    pthread_mutex_lock(&h->lock);
    append(&h->tasks, t);
    pthread_cond_signal(&h->changed);
    pthread_mutex_unlock(&h->lock);
}

static task *new_task(helper_kind kind, const char *path)
{
    task *t = calloc(1, sizeof *t);

    if (t) {
        t->result.kind = kind;
        snprintf(t->result.path, sizeof t->result.path, "%s", path);
    }
    return t;
}

void helper_remember(helper *h, bool remember)
{
    h->remember = remember;
}

bool helper_load(helper *h, const char *path)
{
    task *t = strlen(path) < sizeof t->result.path ? new_task(HELPER_LOAD, path) : NULL;

    if (t)
        ask(h, t);
    return t != NULL;
}

bool helper_save(helper *h, const char *path, const helper_picture *picture)
{
    task *t = strlen(path) < sizeof t->result.path ? new_task(HELPER_SAVE, path) : NULL;

    if (t) {
        t->picture = *picture;
        ask(h, t);
    }
    return t != NULL;
}

void helper_dispose(helper *h, const helper_waste *waste)
{
    task *t;

    if (!waste->job && !waste->maps && !waste->tracer && !waste->scene)
        return;
    t = new_task(HELPER_DISPOSE, "");
    if (!t) {
        dispose(waste);
        return;
    }
    t->waste = *waste;
    ask(h, t);
}

bool helper_take(helper *h, helper_result *out)
{
    task *t;

    pthread_mutex_lock(&h->lock);
    t = detach(&h->results);
    pthread_mutex_unlock(&h->lock);
    if (!t)
        return false;
    *out = t->result;
    free(t);
    return true;
}

bool helper_is_idle(helper *h)
{
    bool idle;

    pthread_mutex_lock(&h->lock);
    idle = !h->busy && !h->tasks.first && !h->results.first;
    pthread_mutex_unlock(&h->lock);
    return idle;
}
