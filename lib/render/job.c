#include "render/job_state.h"

#include "base/clock.h"
#include "base/err.h"

/* ---- a job's life ---- */

static pov_status make_parts(pov_job *job, pov_error *err)
{
    const settings *s = &job->settings;

    tiles_make(&job->tiles, s->crop.width, s->crop.height, s->threads);
    if (!frame_make(&job->frame, job->env, &job->tiles, s->first_step) || !tiles_sort(&job->tiles, job->env))
        return err_set(err, POV_E_MEMORY, "no memory for a picture of %d x %d pixels", s->crop.width, s->crop.height);
    job->all_pixels = (size_t)s->crop.width * (size_t)s->crop.height;
    job->samples = samples_make(job->env, s->samples);
    job->dirty = env_alloc(job->env, job->tiles.count, sizeof *job->dirty);
    if ((size_t)s->threads > job->tiles.count)
        job->settings.threads = (int)job->tiles.count;
    job->threads = env_alloc(job->env, (size_t)job->settings.threads, sizeof *job->threads);
    return job->samples && job->dirty && job->threads ? POV_OK : err_memory(err);
}

static void free_parts(pov_job *job)
{
    for (size_t i = 0; i < job->worker_count; i++) {
        worker_free(job->workers[i], job->env);
        env_free(job->env, job->workers[i]);
    }
    env_free(job->env, job->workers);
    env_free(job->env, job->threads);
    env_free(job->env, job->dirty);
    env_free(job->env, job->samples);
    frame_free(&job->frame, job->env);
    tiles_free(&job->tiles, job->env);
    env_free(job->env, job);
}

pov_status job_create(pov_job **out, const model *m, const world *w, const pov_render_desc *desc, pov_error *err)
{
    pov_job *job = env_alloc(m->env, 1, sizeof *job);
    pov_status status;

    if (!job)
        return err_memory(err);
    job->env = m->env;
    job->model = m;
    job->world = w;
    job->camera = desc->camera ? *desc->camera : m->camera;
    encoding_make(&job->encoding, &m->gamma);
    status = settings_make(&job->settings, desc, err);
    if (status == POV_OK)
        status = make_parts(job, err);
    if (status == POV_OK && !mutex_init(&job->lock))
        status = err_memory(err);
    if (status == POV_OK && !condition_init(&job->changed)) {
        mutex_destroy(&job->lock);
        status = err_memory(err);
    }
    if (status < 0) {
        free_parts(job);
        return status;
    }
    *out = job;
    return POV_OK;
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
    job->started = clock_seconds();
    job->ended = 0.0;
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
           job->claimed < job->tiles.count * (size_t)job->frame.passes;
}

/* Take on the next tile. The lock is held, and there is work. */
static void claim_tile(pov_job *job, worker *w)
{
    claim *c = &w->claim;

    c->generation = job->generation;
    c->camera = job->camera;
    c->pass = (int)(job->claimed / job->tiles.count);
    c->tile = job->tiles.order[job->claimed % job->tiles.count];
    c->rect = tiles_rect(&job->tiles, c->tile);
    c->lattice = frame_lattice(&job->frame, c->pass);
    job->claimed++;
}

/* Does what a worker is tracing still count? The lock is held. */
static bool is_current(const pov_job *job, const claim *c)
{
    return c->generation == job->generation && job->state == POV_JOB_RUNNING && !job->closing;
}

static bool ask_whether_to_give_up(void *user)
{
    worker *w = user;
    bool current;

    mutex_lock(&w->job->lock);
    current = is_current(w->job, &w->claim);
    mutex_unlock(&w->job->lock);
    return !current;
}

/* The lock is held. True: there are tiles to take where there were none. */
static bool mark_dirty(pov_job *job, size_t tile)
{
    if (job->dirty[tile])
        return false;
    job->dirty[tile] = true;
    return job->dirty_count++ == 0;
}

/* The lock is held, the tile is whole and current. True: whoever waits for news should hear of it. */
static bool commit(pov_job *job, worker *w, const pov_counts *fresh)
{
    const claim *c = &w->claim;
    bool first = mark_dirty(job, c->tile);

    frame_put(&job->frame, c->tile, c->pass, w->pixels);
    counts_add(&job->counts, fresh);
    job->done_pixels += lattice_pixels(c->lattice, c->rect.width, c->rect.height);
    job->committed++;
    if (job->committed == job->tiles.count * (size_t)job->frame.passes) {
        job_end(job, POV_JOB_DONE);
        return true;
    }
    if (first) {
        job->news = true;
        if (job->waiting > 0)
            condition_wake_all(&job->changed);
    }
    return first;
}

/* The lock is held. */
static void fail(pov_job *job, const pov_error *why)
{
    if (job->state != POV_JOB_RUNNING)
        return;
    job->error = *why;
    job_end(job, POV_JOB_FAILED);
}

/* Trace what was claimed, and hand it in unless the job has gone on without it. */
static void work(pov_job *job, worker *w)
{
    pov_error error = { 0 };
    pov_counts fresh = { 0 };
    bool whole = false, tell = false;

    if (worker_prepare(w, job->model, job->world, ask_whether_to_give_up, &error) == POV_OK) {
        whole = worker_trace(w, &job->settings, job->samples);
        fresh = worker_count(w);
        if (w->tracer->failed)
            err_memory(&error);
    }
    mutex_lock(&job->lock);
    if (is_current(job, &w->claim)) {
        if (error.status < 0) {
            fail(job, &error);
            tell = true;
        } else if (whole) {
            tell = commit(job, w, &fresh);
        }
    }
    mutex_unlock(&job->lock);
    if (tell)
        poke(job);
}

/* ---- workers and threads ---- */

/* A worker that nobody is using, or a new one. NULL: no memory. */
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
    if (!w || !worker_make(w, job, job->env, job->tiles.edge)) {
        env_free(job->env, w);
        return NULL;
    }
    mutex_lock(&job->lock);
    grown = env_resize(job->env, job->workers, job->worker_count + 1, sizeof *grown);
    if (grown) {
        job->workers = grown;
        job->workers[job->worker_count++] = w;
    }
    mutex_unlock(&job->lock);
    if (!grown) {
        worker_free(w, job->env);
        env_free(job->env, w);
    }
    return grown ? w : NULL;
}

static void give_back(pov_job *job, worker *w)
{
    mutex_lock(&job->lock);
    w->next_free = job->free_workers;
    job->free_workers = w;
    mutex_unlock(&job->lock);
}

/* A thread goes on to the end of the job's life: a restart may come at any time. */
static void *run(void *user)
{
    worker *w = user;
    pov_job *job = w->job;

    mutex_lock(&job->lock);
    while (!job->closing) {
        if (!has_work(job)) {
            condition_wait(&job->changed, &job->lock);
            continue;
        }
        claim_tile(job, w);
        mutex_unlock(&job->lock);
        work(job, w);
        mutex_lock(&job->lock);
    }
    mutex_unlock(&job->lock);
    return NULL;
}

/* Start as many threads as are to be had; one at least, else it failed. */
static pov_status start_threads(pov_job *job, pov_error *err)
{
    for (int i = 0; i < job->settings.threads; i++) {
        worker *w = borrow(job);

        if (!w)
            return err_memory(err);
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
    if (!w) {
        pov_error error = { 0 };
        err_memory(&error);
        fail(job, &error);
    }
    while (job->state == POV_JOB_RUNNING && !has_work(job) && !job->closing && !job->paused)
        condition_wait(&job->changed, &job->lock);
    working = w && has_work(job);
    if (working)
        claim_tile(job, w);
    mutex_unlock(&job->lock);
    if (working)
        work(job, w);
    if (w)
        give_back(job, w);
    mutex_lock(&job->lock);
    state = job->state;
    mutex_unlock(&job->lock);
    return state;
}
