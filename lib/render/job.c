#include "render/job_state.h"

#include "base/clock.h"
#include "base/err.h"
#include "render/budget.h"
#include "render/budget_singles.h"
#include "render/meter.h"
#include "render/raygen.h"

#include <string.h>

/* ---- a job's life ---- */

/* Pixels that are traced; for a part without any, what numbers may still be divided by. */
static size_t pixels_of(const tiles *t)
{
    size_t pixels = 0;

    for (size_t i = 0; i < t->own; i++) {
        const pov_rect r = tiles_rect(t, t->order[i]);

        pixels += (size_t)r.width * (size_t)r.height;
    }
    return pixels > 0 ? pixels : 1;
}

/* Behind a lens, errors are where objects are not sharp, and cells have some of both. */
static bool has_singles(const pov_job *job)
{
    const settings *s = &job->settings;

    return raygen_has_lens(&job->camera) && s->adaptive && s->samples > BUDGET_PILOT_SINGLES && !job->cells.alike &&
           s->crop.width >= BUDGET_SINGLES_LEAST_EDGE && s->crop.height >= BUDGET_SINGLES_LEAST_EDGE;
}

static pov_status make_parts(pov_job *job, int parts, pov_error *err)
{
    const settings *s = &job->settings;

    /* The tiles of parts are those of so many threads, whoever traces them. */
    tiles_make(&job->tiles, s->crop.width, s->crop.height, parts > 0 ? parts : s->threads,
               parts == 0 && job->scene && job->scene->plan->radiosity);
    if (!framebuffer_make(&job->framebuffer, job->env, &job->tiles, s->first_step) ||
        !tiles_sort(&job->tiles, job->env)) return err_set(err, POV_E_MEMORY,
                                                           "no memory for a picture of %d x %d pixels", s->crop.width,
                                                               s->crop.height);
    if (s->parts > 0)
        tiles_deal(&job->tiles, s->part, s->parts);
    job->all_pixels = pixels_of(&job->tiles);
    if (!cells_make(&job->cells, job->env, s))
        return err_memory(err);
    if (job->scene)
        job->cells.alike = job->scene->plan->radiosity ? ALIKE_SETS : job->scene->plan->photons ? ALIKE_PHOTONS : 0;
    if (job->scene && has_singles(job) && !budget_singles_make(&job->cells, job->env))
        return err_memory(err);
    job->framebuffer.again = job->scene && job->scene->plan->radiosity;
    job->cells.reference = s->reference;
    job->cells.reference_clipped = s->reference_clipped;
    if (s->time_map && !cells_count_time(&job->cells, job->env))
        return err_memory(err);
    job->scratch = env_resize(job->env, NULL, job->cells.count, 2 * GROUPS * sizeof *job->scratch);
    job->queue = env_alloc(job->env, job->tiles.count, sizeof *job->queue);
    job->dirty = env_alloc(job->env, job->tiles.count, sizeof *job->dirty);
    if ((size_t)s->threads > job->tiles.count)
        job->settings.threads = (int)job->tiles.count;
    job->threads = env_alloc(job->env, (size_t)job->settings.threads, sizeof *job->threads);
    if (!job->scratch || !job->queue || !job->dirty || !job->threads)
        return err_memory(err);
    passes_begin(job);
    return POV_OK;
}

/* What a job is made of besides its description. */
typedef struct job_origin { const env *env; const shading *scene; pov_camera camera; gamma gamma; } job_origin;

static void free_worker(pov_job *job, worker *w)
{
    worker_free(w, job->env);
    refinement_free(w->refinement, job->env);
    env_free(job->env, w->meter);
    env_free(job->env, w);
}

static void free_parts(pov_job *job)
{
    for (size_t i = 0; i < job->worker_count; i++)
        free_worker(job, job->workers[i]);
    env_free(job->env, job->workers);
    env_free(job->env, job->threads);
    env_free(job->env, job->dirty);
    cells_free(&job->cells, job->env);
    env_free(job->env, job->scratch);
    env_free(job->env, job->queue);
    env_free(job->env, job->rows.items);
    env_free(job->env, job->wanted);
    env_free(job->env, job->wanted_singles);
    env_free(job->env, job->joined);
    framebuffer_free(&job->framebuffer, job->env);
    tiles_free(&job->tiles, job->env);
    env_free(job->env, job);
}

/* The lock, and what settings need. */
static pov_status complete(pov_job *job, const pov_render_desc *desc, int parts, pov_error *err)
{
    pov_status status = settings_make(&job->settings, desc, &job->camera, err);

    if (status == POV_OK && job->settings.note && job->settings.parts > 0)
        strcpy(job->note, job->settings.note);
    job->round = job->settings.parts > 0;
    if (status == POV_OK)
        status = make_parts(job, parts, err);
    if (status == POV_OK && !mutex_init(&job->lock))
        status = err_memory(err);
    if (status == POV_OK && !condition_init(&job->changed)) {
        mutex_destroy(&job->lock);
        status = err_memory(err);
    }
    return status;
}

static pov_status make(pov_job **out, const job_origin *from, const pov_render_desc *desc, int parts, pov_error *err)
{
    pov_job *job = env_alloc(from->env, 1, sizeof *job);
    pov_status status;

    if (!job)
        return err_memory(err);
    job->env = from->env;
    job->scene = from->scene;
    job->camera = desc->camera ? *desc->camera : from->camera;
    encoding_make(&job->encoding, &from->gamma);
    status = complete(job, desc, parts, err);
    if (status < 0)
        free_parts(job);
    else
        *out = job;
    return status;
}

pov_status job_create(pov_job **out, const shading *scene, const pov_render_desc *desc, pov_error *err)
{
    const job_origin from = { scene->model->env, scene, scene->model->camera, scene->model->gamma };

    return make(out, &from, desc, desc->parts, err);
}

pov_status job_create_joined(pov_job **out, const env *e, const gamma *g, const pov_render_desc *desc, int parts, pov_error *err)
{
    const job_origin from = { .env = e, .gamma = *g };

    return make(out, &from, desc, parts, err);
}

void job_destroy(pov_job *job)
{
    if (!job)
        return;
    mutex_lock(&job->lock);
    job->closing = true;
    condition_wake_all(&job->changed);
    mutex_unlock(&job->lock);
    for (int i = 0; i < job->thread_count; i++)
        thread_join(job->threads[i]);
    condition_destroy(&job->changed);
    mutex_destroy(&job->lock);
    free_parts(job);
}

/* ---- claim, trace, commit ---- */

static void poke(const pov_job *job)
{
    if (job->settings.wake)
        job->settings.wake(job->settings.wake_user);
}

void job_begin(pov_job *job)
{
    job->state = POV_JOB_RUNNING;
    job->started = clock_seconds() - job->earlier;
    job->ended = 0.0;
    passes_resume(job);
}

void job_end(pov_job *job, pov_job_state state)
{
    job->state = state;
    job->ended = clock_seconds();
    job->news = true;
    condition_wake_all(&job->changed);
}

/* The lock is held. */
static bool has_work(const pov_job *job)
{
    return job->state == POV_JOB_RUNNING && !job->closing && !job->paused &&
           job->claimed < job->due;
}

/* Is a worker's tile still needed? The lock is held. */
static bool is_current(const pov_job *job, const claim *c)
{
    return c->generation == job->generation && job->state == POV_JOB_RUNNING && !job->closing;
}

static bool ask_whether_to_give_up(void *user)
{
    worker *w = user;
    bool current;

    mutex_lock(&w->job->lock);
    passes_expire(w->job);
    current = is_current(w->job, &w->claim);
    mutex_unlock(&w->job->lock);
    return !current;
}

/* The lock is held. */
static void fail(pov_job *job, const pov_error *why)
{
    if (job->state != POV_JOB_RUNNING)
        return;
    job->error = *why;
    job_end(job, POV_JOB_FAILED);
}

void job_fail_memory(pov_job *job)
{
    pov_error error = { 0 };

    err_memory(&error);
    fail(job, &error);
}

static bool trace(pov_job *job, worker *w)
{
    if (w->claim.refining)
        return refine_more(w, &job->settings, &job->cells, &job->encoding);
    return worker_trace(w, &job->settings);
}

/* Processor time since the last call: asking the system takes a microsecond. */
static double spend(worker *w)
{
    const double now = clock_thread_seconds(), spent = now - w->spent;

    w->spent = now;
    return spent;
}

/* What the thread spent on the job's present picture. The lock is held. */
static void add_spent(pov_job *job, worker *w)
{
    const double spent = spend(w);

    if (w->claim.generation == job->generation)
        job->cpu += spent;
}

/* After a tile. Small ones are asked for together, until their pass ends or the thread has nothing to do. */
static void add_spent_now_and_then(pov_job *job, worker *w)
{
    static const double microseconds = 1e6, least = 100.0;
    const double now = clock_seconds();

    if (microseconds * (now - w->asked) < least && job->committed + 1 < job->due && !w->meter)
        return;
    w->asked = now;
    add_spent(job, w);
}

/* Trace the claimed tile, and commit it unless the job was restarted meanwhile. */
static void work(pov_job *job, worker *w)
{
    pov_error error = { 0 };
    pov_counts fresh = { 0 };
    class_counts classes = { 0 };
    bool whole = false, tell = false;

    if (worker_prepare(w, job->scene, ask_whether_to_give_up, &error) == POV_OK) {
        whole = trace(job, w);
        fresh = worker_count(w);
        query_context_take_classes(w->tracer->context.context, &classes);
        if (w->tracer->context.failed)
            tracer_error(w->tracer, &error);
    }
    mutex_lock(&job->lock);
    add_spent_now_and_then(job, w);
    if (is_current(job, &w->claim)) {
        if (error.status < 0) {
            fail(job, &error);
            tell = true;
        } else if (whole) {
            tell = passes_commit(job, w, &fresh, &classes);
        }
    } else if (job->stop == POV_STOP_TIME) {
        tell = true;
    }
    mutex_unlock(&job->lock);
    if (tell)
        poke(job);
}

/* ---- workers and threads ---- */

static bool make_worker(pov_job *job, worker *w)
{
    if (!worker_make(w, job, job->env, job->tiles.edge))
        return false;
    if (job->settings.sampling)
        w->refinement = refinement_make(job->env, job->tiles.edge, job->cells.sums);
    if (job->settings.time_map)
        w->meter = env_alloc(job->env, 1, sizeof *w->meter);
    return (w->refinement || !job->settings.sampling) && (w->meter || !job->settings.time_map);
}

/* An idle worker, or a new one. NULL: no memory. */
static worker *borrow(pov_job *job)
{
    worker *w, **grown;

    mutex_lock(&job->lock);
    w = job->free_workers;
    if (w)
        job->free_workers = w->next_free;
    mutex_unlock(&job->lock);
    if (w)
        return w;
    w = env_alloc(job->env, 1, sizeof *w);
    if (!w)
        return NULL;
    if (!make_worker(job, w)) {
        free_worker(job, w);
        return NULL;
    }
    mutex_lock(&job->lock);
    grown = env_resize(job->env, job->workers, job->worker_count + 1, sizeof *grown);
    if (grown) {
        job->workers = grown;
        job->workers[job->worker_count++] = w;
    }
    mutex_unlock(&job->lock);
    if (!grown)
        free_worker(job, w);
    return grown ? w : NULL;
}

static void give_back(pov_job *job, worker *w)
{
    mutex_lock(&job->lock);
    w->next_free = job->free_workers;
    job->free_workers = w;
    mutex_unlock(&job->lock);
}

/* A thread lives as long as the job: a restart may come at any time. */
static void *run(void *user)
{
    worker *w = user;
    pov_job *job = w->job;

    spend(w);
    /* Otherwise the first tile in each part would ask for it with the lock held, and all other threads would wait. */
    framebuffer_touch(&job->framebuffer, w->number, (size_t)job->settings.threads);
    mutex_lock(&job->lock);
    while (!job->closing) {
        passes_expire(job);
        if (!has_work(job)) {
            add_spent(job, w);
            condition_wait(&job->changed, &job->lock);
            continue;
        }
        passes_claim(job, w);
        mutex_unlock(&job->lock);
        work(job, w);
        mutex_lock(&job->lock);
    }
    mutex_unlock(&job->lock);
    return NULL;
}

/* Start as many threads as possible; the start failed if there is none. */
static pov_status start_threads(pov_job *job, pov_error *err)
{
    for (int i = 0; i < job->settings.threads; i++) {
        worker *w = borrow(job);

        if (!w)
            return err_memory(err);
        w->number = (size_t)i;
        if (!thread_start(&job->threads[i], run, w)) {
            give_back(job, w);
            return i > 0 ? POV_OK : err_set(err, POV_E_MEMORY, "no thread could be started");
        }
        mutex_lock(&job->lock);
        job->thread_count++;
        mutex_unlock(&job->lock);
    }
    return POV_OK;
}

pov_status job_start(pov_job *job, pov_error *err)
{
    pov_error error = { 0 };
    bool first;

    mutex_lock(&job->lock);
    first = !job->threads_wanted && (job->state == POV_JOB_IDLE || job->state == POV_JOB_RUNNING);
    if (first) {
        job->threads_wanted = true;
        if (job->state == POV_JOB_IDLE)
            job_begin(job);
    }
    mutex_unlock(&job->lock);
    if (!first || start_threads(job, &error) == POV_OK)
        return job_get_error(job, err);
    mutex_lock(&job->lock);
    fail(job, &error);
    mutex_unlock(&job->lock);
    if (err)
        *err = error;
    return error.status;
}

pov_job_state job_step(pov_job *job)
{
    worker *w = borrow(job);
    pov_job_state state;
    bool working;

    mutex_lock(&job->lock);
    if (job->state == POV_JOB_IDLE)
        job_begin(job);
    if (!w)
        job_fail_memory(job);
    passes_expire(job);
    while (job->state == POV_JOB_RUNNING && !has_work(job) && !job->closing && !job->paused)
        condition_wait(&job->changed, &job->lock);
    working = w && has_work(job);
    if (working)
        passes_claim(job, w);
    mutex_unlock(&job->lock);
    if (working) {
        spend(w);
        w->asked = 0.0;          /* the next tile may be another thread's */
        work(job, w);
    }
    if (w)
        give_back(job, w);
    mutex_lock(&job->lock);
    state = job->state;
    mutex_unlock(&job->lock);
    return state;
}
