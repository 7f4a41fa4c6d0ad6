#include "shade/shade.h"

#include "base/clock.h"
#include "base/err.h"
#include "shade/surface.h"

#include <float.h>

/* Seconds between two questions whether to give up: a cancelled job ends well within 20 ms, also where rays
 * get a hundred times dearer from one question to the next. */
static const double ask_soon = 0.001, ask_late = 0.004;
enum { ASK_EVERY_MAX = 64 };

/* Level 0 is 1: the camera ray itself is always followed. */
static int levels_of(const model *m)
{
    return m->max_trace_level > 1 ? m->max_trace_level : 1;
}

pov_status tracer_create(pov_tracer **out, const model *m, const world *w, pov_error *err)
{
    pov_tracer *t = env_alloc(m->env, 1, sizeof *t);
    pov_status status;

    if (!t)
        return err_memory(err);
    t->env = m->env;
    t->model = m;
    t->world = w;
    t->plan = world_plan(w);
    t->waiting = env_resize(t->env, NULL, (size_t)levels_of(m) + 1, sizeof *t->waiting);
    status = t->waiting ? walker_create(&t->walker, w, err) : err_memory(err);
    if (status < 0) {
        tracer_destroy(t);
        return status;
    }
    *out = t;
    return POV_OK;
}

void tracer_destroy(pov_tracer *t)
{
    const env *e;

    if (!t)
        return;
    e = t->env;
    walker_destroy(t->walker);
    env_free(e, t->media.items);
    env_free(e, t->start.items);
    env_free(e, t->waiting);
    env_free(e, t);
}

pov_counts tracer_counts(const pov_tracer *t)
{
    pov_counts c = t->counts;

    c.decided = walker_decided(t->walker);
    return c;
}

/* The pace that was found stays. */
void tracer_set_interrupt(pov_tracer *t, bool (*ask)(void *user), void *user)
{
    interrupt *i = &t->interrupt;

    i->ask = ask;
    i->user = user;
    i->given_up = false;
    if (i->every == 0)
        i->every = i->left = 1;
}

/* Rays cost from 100 ns to many milliseconds, so the pace follows the clock. It changes no colour. */
static bool gives_up(interrupt *i)
{
    double now;

    if (!i->ask || i->given_up || --i->left > 0)
        return i->given_up;
    now = clock_seconds();
    if (now - i->asked < ask_soon && i->every < ASK_EVERY_MAX)
        i->every *= 2;
    else if (now - i->asked > ask_late)
        i->every = i->every > 8 ? i->every / 8 : 1;
    i->asked = now;
    i->left = i->every;
    i->given_up = i->ask(i->user);
    return i->given_up;
}

static bool is_same(pov_vec3 a, pov_vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

static void see_medium(void *user, uint32_t which)
{
    pov_tracer *t = user;

    if (!media_push(&t->start, t->env, which))
        t->failed = true;
}

/* The media of a camera ray. They are looked for once for all rays that start at the same point. */
static media_span begin_media(pov_tracer *t, const pov_ray *ray)
{
    media_span span = { 0, 0 };

    t->media.count = 0;
    if (!t->plan->media_at_start)
        return span;
    if (!t->start_known || !is_same(t->start_org, ray->org) || !is_same(t->start_org_lo, ray->org_lo)) {
        t->start.count = 0;
        world_media_at(t->world, ray->org, ray->org_lo, see_medium, t);
        t->start_org = ray->org;
        t->start_org_lo = ray->org_lo;
        t->start_known = true;
    }
    for (size_t i = 0; i < t->start.count && !t->failed; i++)
        if (!media_push(&t->media, t->env, t->start.items[i]))
            t->failed = true;
    span.count = t->media.count;
    return span;
}

/* The next ray to be followed. A mirrored ray goes first and its transmitted sister waits: a mirrored one is
 * always a level deeper, so no more wait than there are levels. */
static bool next_path(pov_tracer *t, path *p, const branches *b)
{
    if (b->reflects && b->transmits)
        t->waiting[t->waiting_count++] = b->transmitted;
    if (b->reflects || b->transmits) {
        *p = b->reflects ? b->reflected : b->transmitted;
        return true;
    }
    if (t->waiting_count == 0)
        return false;
    *p = t->waiting[--t->waiting_count];
    if (t->plan->refraction) {
        const path *below = t->waiting_count > 0 ? &t->waiting[t->waiting_count - 1] : NULL;
        media_settle(&t->media, &p->media, below ? below->media.first + below->media.count : 0);
    }
    return true;
}

/* Overflow of absurd colours ends here: NaN becomes 0, the infinite the largest number. */
static float finite(float x)
{
    return isnan(x) ? 0.0f : fmaxf(-FLT_MAX, fminf(FLT_MAX, x));
}

static colour follow(pov_tracer *t, path *p)
{
    colour sum = { 0.0f, 0.0f, 0.0f };
    branches next;
    hit h;

    t->waiting_count = 0;
    do {
        colour seen = t->model->background;

        next.reflects = next.transmits = false;
        if (world_nearest(t->world, t->walker, &p->ray, HUGE_VAL, &h))
            seen = surface_meet(t, p, &h, &next);
        seen = colour_mul(p->factor, seen);
        sum = colour_add(sum, colour_of(finite(seen.r), finite(seen.g), finite(seen.b)));
        t->failed = t->failed || walker_failed(t->walker);
    } while (!t->failed && !gives_up(&t->interrupt) && next_path(t, p, &next));
    return colour_of(finite(sum.r), finite(sum.g), finite(sum.b));
}

/* Rays of cameras that do not exist: no direction, or one that is not a number. */
static bool is_ray(const pov_ray *ray)
{
    double start = ray->org.x + ray->org.y + ray->org.z, length = pov_largest(ray->dir);

    return isfinite(start) && length > 0.0 && isfinite(ray->dir.x + ray->dir.y + ray->dir.z);
}

colour tracer_color(pov_tracer *t, const pov_ray *ray)
{
    path p = { .ray = *ray, .factor = { 1.0f, 1.0f, 1.0f }, .weight = 1.0f, .level = 1 };

    if (!is_ray(ray))
        return t->model->background;
    t->counts.camera++;
    p.media = begin_media(t, ray);
    return follow(t, &p);
}
