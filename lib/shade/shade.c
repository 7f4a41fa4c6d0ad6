#include "shade/shade.h"

#include "base/bits.h"
#include "base/clock.h"
#include "base/err.h"
#include "base/simd.h"
#include "base/vec.h"
#include "shade/batch.h"
#include "shade/geometry.h"
#include "shade/light.h"
#include "shade/surface.h"

#include <float.h>
#include <string.h>

/* Seconds between two questions whether to give up: a cancelled job ends well within 20 ms, also where rays
 * get a hundred times dearer from one question to the next. */
static const double ask_soon = 0.002, ask_late = 0.008;
enum { EVERY_MAX = 4 * BATCH_MAX };

static void make_camera_paths(batch *b)
{
    const path fresh = { .factor = { { 1.0f, 1.0f, 1.0f }, 1.0f }, .level = 1 };

    for (uint32_t i = 0; i < BATCH_MAX; i++) {
        b->paths[i] = fresh;
        b->paths[i].lane = i;
    }
}

pov_status tracer_create(pov_tracer **out, const model *m, const world *w, pov_error *err)
{
    pov_tracer *t = env_alloc_aligned(m->env, sizeof *t, SIMD_LINE);
    pov_status status;

    if (!t)
        return err_memory(err);
    t->env = m->env;
    t->model = m;
    t->world = w;
    t->plan = world_plan(w);
    t->things = world_things(w);
    make_camera_paths(&t->camera);
    geometry_begin(&t->geometry);
    status = batch_make(t) ? walker_create(&t->walker, w, err) : err_memory(err);
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
    batch_free(t);
    env_free(e, t->media.items);
    env_free(e, t->start.items);
    env_free(e, t->spots.items);
    env_free_aligned(e, t);
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
bool tracer_gives_up(pov_tracer *t, uint32_t rays)
{
    interrupt *i = &t->interrupt;
    double now;

    i->left -= (int)rays;
    if (!i->ask || i->given_up || i->left > 0)
        return i->given_up;
    now = clock_seconds();
    if (now - i->asked < ask_soon && i->every < EVERY_MAX)
        i->every *= 2;
    else if (now - i->asked > ask_late)
        i->every = i->every > 8 ? i->every / 8 : 1;
    i->asked = now;
    i->left = i->every;
    i->given_up = i->ask(i->user);
    return i->given_up;
}

static inline bool is_same(pov_vec3 a, pov_vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

static void see_medium(void *user, uint32_t which)
{
    pov_tracer *t = user;

    if (!media_push(&t->start, t->env, which))
        t->failed = true;
}

/* Where the camera ray starts: media are looked for once for all rays that start at the same point. */
static void find_start(pov_tracer *t, const pov_ray *ray)
{
    if (t->start_known && is_same(t->start_org, ray->org) && is_same(t->start_org_lo, ray->org_lo))
        return;
    t->start.count = 0;
    world_media_at(t->world, ray->org, ray->org_lo, see_medium, t);
    t->start_org = ray->org;
    t->start_org_lo = ray->org_lo;
    t->start_known = true;
}

static media_span copy_start(pov_tracer *t)
{
    media_span span = { t->media.count, 0 };

    for (size_t i = 0; i < t->start.count && !t->failed; i++)
        if (!media_push(&t->media, t->env, t->start.items[i]))
            t->failed = true;
    span.count = t->media.count - span.first;
    return span;
}

/* The media of the camera's paths, each with a list of its own. */
static void begin_media(pov_tracer *t, const pov_ray *ray)
{
    const media_span none = { 0, 0 };
    batch *b = &t->camera;

    find_start(t, ray);
    if (t->start.count == 0 && !t->camera_in_media)
        return;
    t->camera_in_media = t->start.count > 0;
    for (uint32_t i = 0; i < BATCH_MAX; i++)
        b->paths[i].media = i < b->count ? copy_start(t) : none;
}

/* ---- what is seen ---- */

/* Overflow of absurd colours ends here: NaN becomes 0, the infinite the largest number. */
static float finite(float x)
{
    if (x >= -FLT_MAX && x <= FLT_MAX)
        return x;
    return isnan(x) ? 0.0f : copysignf(FLT_MAX, x);
}

/* A sum with anything in it that is no finite number is none either. */
static inline colour finite_colour(colour c)
{
    if (isfinite(c.r + c.g + c.b))
        return c;
    return colour_of(finite(c.r), finite(c.g), finite(c.b));
}

SIMD_CLONES static bool are_finite(const float *x, uint32_t n)
{
    int out = 0;

    for (uint32_t i = 0; i < n; i++)
        out |= !(fabsf(x[i]) <= FLT_MAX);
    return !out;
}

static inline void see(const path *p, colour seen, colour *out)
{
    out[p->lane] = colour_add(out[p->lane], finite_colour(colour_mul(p->factor.by, seen)));
}

/* ---- what rays meet ---- */

/* The surface lies on others. */
static void stand_on(pov_tracer *t, surface *s, const spot *on)
{
    if (!VEC_PUSH(t->env, &t->spots, *on)) {
        t->failed = true;
        return;
    }
    s->spot = (uint32_t)t->spots.count;
    s->above = on->above;
    s->on = 0;
    while (s->on + 1 < on->count && on->at[s->on].object != s->at->object)
        s->on++;
}

static void find_spot(pov_tracer *t, surface *s, const spot *from)
{
    spot on;

    world_spot(t->world, t->walker, s->ray, from, s->at, &on);
    stand_on(t, s, &on);
}

/* A path that starts on a spot meets what it crosses before it has gone anywhere, or else what comes next. */
static bool meet_from_spot(pov_tracer *t, surface *s)
{
    const path *p = s->from;
    spot from = t->spots.items[p->spot - 1];
    uint32_t which;

    from.above = p->above;
    which = spot_crossed(&from, s->ray->dir);
    if (which < from.count) {
        *s->at = from.at[which];
        s->at->entering = pov_dot(s->at->normal, s->ray->dir) < 0.0;
        stand_on(t, s, &from);
        return true;
    }
    if (!world_nearest_from(t->world, t->walker, &from, s->ray, HUGE_VAL, s->at))
        return false;
    if (s->at->company)
        find_spot(t, s, &from);
    return true;
}

static bool meet_alone(pov_tracer *t, surface *s)
{
    return s->from->spot ? meet_from_spot(t, s)
                         : world_nearest(t->world, t->walker, s->ray, HUGE_VAL, s->at);
}

static bool any_on_spot(const batch *b)
{
    for (uint32_t i = 0; i < b->count; i++)
        if (b->paths[i].spot)
            return true;
    return false;
}

/* Ray i's surface, which is to be the n-th. */
static inline void place(pov_tracer *t, surface *s, const batch *b, uint32_t i, uint32_t n)
{
    hit *at = &t->hits[i];
    const pov_ray *ray = b->rays[i];

    s->from = &b->paths[i];
    s->ray = ray;
    s->at = at;
    s->spot = 0;
    t->rays[n] = ray;
    t->met[n] = at;
}

/* Is more to be seen of what was met than its own glow? */
static inline bool is_kept(pov_tracer *t, surface *s, colour *out)
{
    const plan_look *look;

    if (s->at->company && !s->spot)
        find_spot(t, s, NULL);
    s->look = look = &t->plan->looks[t->things[s->at->object].material];
    if (!look->lit && t->plan->lighting)
        t->counts.shadow_idle += t->model->lights.count;
    s->lit = colour_of(0.0f, 0.0f, 0.0f);
    if (look->lit || look->mirrors || look->passes)
        return true;
    see(s->from, look->glow, out);
    return false;
}

/* Rays some of which start on spots. */
static uint32_t meet_each(pov_tracer *t, const batch *b, colour *out)
{
    uint32_t n = 0;

    for (uint32_t i = 0; i < b->count; i++) {
        surface *s = &t->surfaces[n];

        place(t, s, b, i, n);
        if (meet_alone(t, s))
            n += is_kept(t, s, out);
        else
            see(s->from, t->model->background, out);
    }
    return n;
}

/* Of the rays that meet nothing. The camera's all see the same, and are the first to add what they see. */
static void see_background(pov_tracer *t, const batch *b, uint64_t rays, colour *out)
{
    const colour background = t->model->background;
    colour seen = colour_of(0.0f, 0.0f, 0.0f);

    if (b != &t->camera) {
        for (; rays; rays &= rays - 1)
            see(&b->paths[first_of64(rays)], background, out);
        return;
    }
    seen = colour_add(seen, finite_colour(colour_mul(b->paths[0].factor.by, background)));
    for (; rays; rays &= rays - 1) {
        const uint32_t i = first_of64(rays);
        out[t->camera_odd ? b->paths[i].lane : i] = seen;
    }
}

/* What the batch's rays meet: those surfaces of which more than their own glow is seen. */
static uint32_t meet(pov_tracer *t, const batch *b, colour *out)
{
    uint64_t met, rest;
    surface *s = t->surfaces;
    uint32_t n = 0;

    if (t->spots.count > 0 && any_on_spot(b))
        return meet_each(t, b, out);
    if (b == &t->camera && t->fan)
        met = world_nearest_fan(t->world, t->walker, t->fan, t->ways, b->count, HUGE_VAL, t->hits);
    else
        met = world_nearest_many(t->world, t->walker, b->rays, b->count, HUGE_VAL, t->hits);
    see_background(t, b, ~met & ~(uint64_t)0 >> (BATCH_MAX - b->count), out);
    for (rest = met; rest; rest &= rest - 1) {
        place(t, s, b, first_of64(rest), n);
        if (is_kept(t, s, out)) {
            s++;
            n++;
        }
    }
    return n;
}

/* Follow the paths of one batch to where they end, and see which go on. */
static void follow(pov_tracer *t, const batch *b, colour *out)
{
    const uint32_t n = meet(t, b, out);
    uint32_t i;

    geometry_find(t, n);
    light_gather(t, n);
    for (i = 0; i < n; i++)
        see(t->surfaces[i].from, colour_add(t->surfaces[i].look->glow, t->surfaces[i].lit), out);
    t->mirrored->count = t->passed->count = 0;
    surface_branch(t, n);
    t->failed = t->failed || walker_failed(t->walker);
}

/* ---- camera rays ---- */

/* Rays of cameras that do not exist have no direction, or are not numbers. */
static bool is_start(const pov_ray *ray) { return isfinite(ray->org.x + ray->org.y + ray->org.z); }

static bool is_way(pov_vec3 dir) { return isfinite(dir.x + dir.y + dir.z) && pov_largest(dir) > 0.0; }

static bool are_ways(const pov_ray *rays, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++)
        if (!is_way(rays[i].dir))
            return false;
    return true;
}

/* Bit i: ray i is one, and its path begins. */
static uint64_t begin_some(batch *b, const pov_ray *rays, uint32_t n)
{
    uint64_t rays_there = 0;

    b->count = 0;
    for (uint32_t i = 0; i < n; i++) {
        if (!is_start(rays) || !is_way(rays[i].dir))
            continue;
        b->paths[b->count].lane = i;
        b->rays[b->count++] = &rays[i];
        rays_there |= (uint64_t)1 << i;
    }
    return rays_there;
}

/* The same; as a rule all are, and paths have their lanes from one time to the next. */
static uint64_t begin(pov_tracer *t, const pov_ray *rays, uint32_t n, bool sound)
{
    batch *b = &t->camera;
    uint64_t rays_there = ~(uint64_t)0;

    if (t->camera_odd)
        make_camera_paths(b);
    t->camera_odd = !is_start(rays) || !(sound || are_ways(rays, n));
    b->count = n;
    for (uint32_t i = 0; i < n; i++)
        b->rays[i] = &rays[i];
    if (t->camera_odd)
        rays_there = begin_some(b, rays, n);
    if (t->plan->media_at_start && b->count > 0)
        begin_media(t, rays);
    t->counts.camera += b->count;
    return rays_there;
}

static void trace(pov_tracer *t, const pov_ray *rays, uint32_t n, bool sound, colour *out)
{
    const batch *b = &t->camera;
    uint64_t seeing;
    uint32_t i;

    batch_forget(t);
    seeing = begin(t, rays, n, sound);
    for (i = 0; i < n; i++)
        out[i] = colour_of(0.0f, 0.0f, 0.0f);
    if (b->count > 0)
        for (follow(t, b, out); !t->failed && !tracer_gives_up(t, b->count) && batch_next(t); b = t->now)
            follow(t, t->now, out);
    if (!are_finite(&out->r, 3 * n))
        for (i = 0; i < n; i++)
            out[i] = finite_colour(out[i]);
    for (i = 0; t->camera_odd && i < n; i++)
        if (!(seeing >> i & 1))
            out[i] = t->model->background;
}

colour tracer_color(pov_tracer *t, const pov_ray *ray)
{
    colour seen;

    t->fan = NULL;
    trace(t, ray, 1, false, &seen);
    return seen;
}

/* Fewer than there are, for batches are no larger than the number of rays that may be sent between two questions whether
 * to give up; or some that are none. */
static void trace_some(pov_tracer *t, pov_ray *rays, const vec_lanes *ways, uint32_t n, bool sound, colour *out)
{
    uint32_t i, some;

    t->fan = NULL;
    for (i = 0; i < n; i++)
        rays[i].dir = lanes_at(ways, i);
    for (i = 0; i < n && !t->failed && !t->interrupt.given_up; i += some) {
        some = t->interrupt.ask && t->interrupt.every < BATCH_MAX ? (uint32_t)t->interrupt.every : BATCH_MAX;
        some = some < n - i ? some : n - i;
        trace(t, rays + i, some, sound, out + i);
    }
}

void tracer_fan(pov_tracer *t, pov_ray *rays, const vec_lanes *ways, uint32_t n, bool sound, colour *out)
{
    if (!sound || !is_start(rays) || (t->interrupt.ask && (uint32_t)t->interrupt.every < n)) {
        trace_some(t, rays, ways, n, sound, out);
    } else if (!t->failed && !t->interrupt.given_up) {
        t->fan = rays;
        t->ways = ways;
        trace(t, rays, n, true, out);
    }
}
