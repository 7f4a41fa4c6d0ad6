#include "shade/tracer.h"

#include "base/elementary.h"
#include "base/err.h"
#include "base/simd.h"
#include "base/vec3.h"
#include "shade/accumulate.h"
#include "shade/gather.h"
#include "shade/photon_flight.h"
#include "shade/reuse.h"
#include "shade/scatter.h"

#include <string.h>

static void make_camera_paths(batch *b)
{
    const path fresh = { .factor = { { 1.0f, 1.0f, 1.0f }, 1.0f }, .level = 1, .clear = 1.0f, .hue = PATH_WHITE };

    for (uint32_t i = 0; i < BATCH_MAX; i++) {
        b->paths[i] = fresh;
        b->paths[i].lane = i;
    }
}

/* Memory for the queue and for textures. */
static bool make_buffers(pov_tracer *t)
{
    const shading *scene = t->context.scene;
    const env *e = t->context.env;

    if (!batch_make(&t->queue, e) || !paint_create(&t->painted, scene))
        return false;
    if (scene->photons) {
        t->photons = env_alloc_aligned(e, sizeof *t->photons, SIMD_LINE);
        if (!t->photons)
            return false;
        geometry_begin(&t->photons->lanes.on.geometry);
        t->lighting.photons = t->photons;
    }
    if (scene->flat_stacks) {
        t->stacks = env_alloc_aligned(e, sizeof *t->stacks, SIMD_LINE);
        if (!t->stacks)
            return false;
    }
    if (scene->most_terms <= 1)
        return true;
    t->layers = env_alloc_aligned(e, sizeof *t->layers, SIMD_LINE);
    t->shadow_rays = env_alloc_aligned(e, sizeof *t->shadow_rays, SIMD_LINE);
    if (t->layers)
        geometry_begin(&t->layers->on.geometry);
    return t->layers && t->shadow_rays;
}

/* Mirrors and glass may send two rays for each: with a deep limit and without a bail-out they never end. */
static uint64_t most_rays(const model *m)
{
    return m->most_rays > 0 ? m->most_rays : 100000000;
}

/* Can more rays follow from one than may? Where each surface sends one mirrored ray at most, each is a level deeper. */
static bool may_exceed(const shading *s)
{
    return s->plan->transmission || s->plan->hidden || s->plan->radiosity || s->plan->subsurface || s->most_terms > 1 ||
           (uint64_t)s->model->max_trace_level > most_rays(s->model);
}

pov_status tracer_create(pov_tracer **out, const shading *scene, pov_error *err)
{
    const env *e = scene->model->env;
    pov_tracer *t = env_alloc_aligned(e, sizeof *t, SIMD_LINE);
    pov_status status;

    if (!t)
        return err_memory(err);
    t->context.env = e;
    t->context.scene = scene;
    t->camera.camera = true;
    t->counts_followers = may_exceed(scene);
    make_camera_paths(&t->camera);
    geometry_begin(&t->surfaces.geometry);
    status = make_buffers(t) ? query_context_create(&t->context.context, scene->world, err) : err_memory(err);
    if (status < 0) {
        tracer_destroy(t);
        return status;
    }
    *out = t;
    return POV_OK;
}

/* The maps of a seed are those of no other. */
static void let_go(pov_tracer *t)
{
    if (!t->photons || !t->photons->seed)
        return;
    photon_store_let_go(t->context.scene->photons->store, t->photons->seed);
    t->photons->seed = NULL;
    memset(t->photons->known, 0, sizeof t->photons->known);
}

void tracer_destroy(pov_tracer *t)
{
    const env *e;

    if (!t)
        return;
    e = t->context.env;
    let_go(t);
    query_context_destroy(t->context.context);
    batch_free(&t->queue, e);
    paint_destroy(&t->painted, e);
    env_free_aligned(e, t->layers);
    env_free_aligned(e, t->shadow_rays);
    env_free_aligned(e, t->stacks);
    env_free_aligned(e, t->photons);
    env_free(e, t->context.dielectrics.items);
    env_free(e, t->context.coincident_sets.items);
    env_free(e, t->start.found.items);
    env_free_aligned(e, t);
}

pov_counts tracer_counts(const pov_tracer *t)
{
    pov_counts c = t->context.counts;

    c.escalated = query_context_escalated(t->context.context);
    return c;
}

void tracer_set_interrupt(pov_tracer *t, bool (*ask)(void *user), void *user)
{
    interrupt_set(&t->context.interrupt, ask, user);
}

/* What the layers of surfaces give, chunk by chunk. */
static void shade_layers(pov_tracer *t, colour *out)
{
    shade_context *c = &t->context;
    layers *l = t->layers;

    t->lighting.own = t->shadow_rays->own;
    for (layers_begin(l); !c->failed && layers_take(c, l, &t->surfaces, &t->painted);) {
        light_gather(&t->lighting, c, &l->on);
        accumulate_layers(l, out);
        scatter_layers(c, l, &t->queue);
        if (c->scene->plan->radiosity)
            gather_begin_layers(c, l, &t->queue);
    }
}

/* What surfaces of one term each give. */
static void shade_surfaces(pov_tracer *t, const batch *b, colour *out)
{
    shade_context *c = &t->context;
    surfaces *s = &t->surfaces;

    t->lighting.own = t->queue.mirrored.items[0]->own;
    light_gather(&t->lighting, c, s);
    accumulate_surfaces(s, t->camera_white && b == &t->camera && s->count == b->count, out);
    scatter(c, s, &t->queue);
    if (c->scene->plan->radiosity)
        gather_begin(c, s, &t->queue);
}

/* What surfaces of one term each give, of which some are flat stacks. */
static void shade_stacks(pov_tracer *t, colour *out)
{
    surfaces *s = &t->surfaces;

    t->lighting.own = t->queue.mirrored.items[0]->own;
    light_gather_stacks(&t->lighting, &t->context, s, t->stacks);
    accumulate_stacks(s, t->stacks, out);
    scatter(&t->context, s, &t->queue);
}

/* What the surfaces give that a batch has met, and the paths that continue from them. */
static void shade_found(pov_tracer *t, batch *b, colour *out)
{
    const int kind = surfaces_complete(&t->context, &t->surfaces, &t->painted);

    if (b->reuse)
        reuse_note(&t->context, &t->surfaces, b->reuse);
    if (kind == PAINT_SINGLE)
        shade_surfaces(t, b, out);
    else if (kind == PAINT_STACKS)
        shade_stacks(t, out);
    else
        shade_layers(t, out);
}

/* Trace the paths of one batch to their hits, and spawn the paths that continue. */
static void shade_batch(pov_tracer *t, batch *b, colour *out)
{
    shade_context *c = &t->context;

    surfaces_find(c, &t->surfaces, b, out);
    batch_begin(&t->queue, out);
    if (t->surfaces.count > 0)
        shade_found(t, b, out);
    c->failed = c->failed || query_context_failed(c->context);
}

/* ---- camera rays ---- */

/* Rays of invalid cameras have no direction, or are not numbers. */
static bool is_start(pov_vec3 org) { return isfinite(org.x + org.y + org.z); }

static bool is_direction(pov_vec3 dir) { return isfinite(dir.x + dir.y + dir.z) && pov_largest(dir) > 0.0; }

static bool is_ray(const pov_ray *ray) { return is_start(ray->org) && is_direction(ray->dir); }

static bool are_rays(const pov_ray *rays, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++)
        if (!is_ray(&rays[i]))
            return false;
    return true;
}

/* The dielectrics of the camera's paths, each with a list of its own. */
static void begin_inside(pov_tracer *t, bool one_start)
{
    shade_context *c = &t->context;
    batch *b = &t->camera;
    bool done = dielectric_find(&t->start, c->env, c->scene->world, b->rays[0]);

    if (done && one_start && t->start.found.count == 0 && !t->camera_inside)
        return;
    t->camera_inside = false;
    for (uint32_t i = 0; done && i < b->count; i++) {
        done = (one_start || dielectric_find(&t->start, c->env, c->scene->world, b->rays[i])) &&
               dielectric_begin(&c->dielectrics, c->env, &t->start, &b->paths[i].inside);
        t->camera_inside |= b->paths[i].inside.count > 0;
    }
    c->failed = c->failed || !done;
}

/* The solids without fog and media around a start. */
static uint32_t filled_at(pov_tracer *t, const pov_ray *ray)
{
    filled_start *at = &t->filled;

    if (!at->known || !vec3_is_same(at->org, ray->org) || !vec3_is_same(at->org_lo, ray->org_lo)) {
        at->known = true;
        at->org = ray->org;
        at->org_lo = ray->org_lo;
        at->solids = world_filled_at(t->context.scene->world, ray->org, ray->org_lo);
    }
    return at->solids;
}

/* Those around the camera's; `lanes_filled` are around all of them. */
static void begin_filled(pov_tracer *t, bool one_start)
{
    batch *b = &t->camera;
    const uint32_t first = filled_at(t, b->rays[0]);

    if (one_start && t->lanes_filled == first)
        return;
    for (uint32_t i = 0; i < (one_start ? BATCH_MAX : b->count); i++)
        b->paths[i].solids = one_start ? first : filled_at(t, b->rays[i]);
    t->lanes_filled = one_start ? first : UINT32_MAX;
}

/* Fog has dimmed the paths of earlier rays. */
static void clear_factors(batch *b, uint32_t n)
{
    const coefficient white = { { 1.0f, 1.0f, 1.0f }, 1.0f };

    for (uint32_t i = 0; i < n; i++) {
        b->paths[i].factor = white;
        b->paths[i].clear = 1.0f;
    }
}

/* Bit i: ray i is valid, and its path begins. */
static uint64_t begin_some(batch *b, const pov_ray *rays, uint32_t n)
{
    uint64_t are_rays = 0;

    b->count = 0;
    for (uint32_t i = 0; i < n; i++) {
        if (!is_ray(&rays[i]))
            continue;
        b->paths[b->count].lane = i;
        b->rays[b->count++] = &rays[i];
        are_rays |= (uint64_t)1 << i;
    }
    return are_rays;
}

/* The same; usually all rays are valid, and paths keep their lanes from one call to the next. */
static uint64_t begin(pov_tracer *t, const pov_ray *rays, uint32_t n, unsigned known)
{
    shade_context *c = &t->context;
    batch *b = &t->camera;
    uint64_t begun = ~(uint64_t)0;

    if (t->camera_odd) {
        make_camera_paths(b);
        t->lanes_filled = 0;
    }
    t->camera_odd = !(known & TRACER_SOUND || are_rays(rays, n));
    t->camera_white = !t->camera_odd && !c->scene->dims;
    if (c->scene->dims)
        clear_factors(b, n);
    b->count = n;
    for (uint32_t i = 0; i < n; i++)
        b->rays[i] = &rays[i];
    if (t->camera_odd)
        begun = begin_some(b, rays, n);
    if (c->scene->plan->dielectrics_at_start && b->count > 0)
        begin_inside(t, known & TRACER_ONE_START);
    if (c->scene->dims && b->count > 0)
        begin_filled(t, known & TRACER_ONE_START);
    c->counts.camera += b->count;
    return begun;
}

void tracer_begin(pov_tracer *t, const pov_ray *rays, uint32_t n, const colour *carried)
{
    batch_forget(&t->queue, &t->context);
    begin(t, rays, n, TRACER_SOUND);
    for (uint32_t i = 0; i < n; i++)
        t->camera.paths[i].factor.by = carried[i];
    t->camera_white = false;
    t->camera_odd = true;        /* the paths of camera rays carry white */
}

/* ---- photons ---- */

static bool is_wanted(void *tracer)
{
    pov_tracer *t = tracer;

    return !interrupt_is_due(&t->context.interrupt, BATCH_MAX);
}

void tracer_set_pixel(pov_tracer *t, double width, double slope, const photon_screen *screen, uint32_t seed)
{
    if (!t->photons)
        return;
    for (uint32_t i = 0; i < BATCH_MAX; i++) {
        t->photons->views[i].width = width;
        t->photons->views[i].slope = slope;
    }
    t->photons->on_screen = screen != NULL;
    if (screen)
        t->photons->screen = *screen;
    if (seed != t->photons->seed_number)
        let_go(t);
    t->photons->seed_number = seed;
}

/* NULL: no memory, or given up. */
static const photon_maps *take_map(pov_tracer *t, uint32_t number)
{
    photon_store *store = t->context.scene->photons->store;
    photon_work *w = t->photons;

    if (!w->seed)
        w->seed = photon_store_hold(store, w->seed_number);
    return w->seed ? photon_store_take(store, w->seed, number, photon_flight_trace, is_wanted, t) : NULL;
}

/* The map for each ray, made if need be. False: no memory, or given up. */
static bool take_maps(pov_tracer *t, const pov_ray *rays, uint32_t n)
{
    shade_context *c = &t->context;
    photon_work *w = t->photons;

    for (uint32_t i = 0; i < n; i++) {
        const uint32_t number = photon_store_number(c->samples[i].number);

        if (!w->known[number])
            w->known[number] = take_map(t, number);
        if (!w->known[number]) {
            c->failed = c->failed || !c->interrupt.given_up;
            return false;
        }
        w->maps[i] = w->known[number];
        photon_view_begin(&w->views[i], w->on_screen ? &w->screen : NULL, &rays[i], c->samples[i].number);
    }
    c->photons = w->maps;
    c->views = w->views;
    return true;
}

/* Count the rays of a batch, which are of different camera rays. False: one has more than it may have. */
static bool count_followers(pov_tracer *t, const batch *b, uint64_t most)
{
    bool enough = true;

    for (uint32_t i = 0; i < b->count; i++)
        t->followers[b->paths[i].lane]++;
    if (++t->follower_batches <= most)
        return true;
    for (uint32_t i = 0; i < b->count; i++)
        enough &= t->followers[b->paths[i].lane] <= most;
    return enough;
}

pov_status tracer_error(const pov_tracer *t, pov_error *err)
{
    if (!t->context.exhausted)
        return err_memory(err);
    return err_set(err, POV_E_UNSUPPORTED, "more than %llu rays follow from one ray of the camera, which is as many as may",
                   (unsigned long long)most_rays(t->context.scene->model));
}

void tracer_follow(pov_tracer *t, batch *b, colour *out)
{
    shade_context *c = &t->context;
    const uint64_t most = most_rays(c->scene->model);

    t->follower_batches = 0;
    for (shade_batch(t, b, out); !c->failed && !interrupt_is_due(&c->interrupt, b->count); b = t->queue.now) {
        if (!batch_next(&t->queue, c))
            return;
        if (t->counts_followers && t->follower_batches == 0)
            memset(t->followers, 0, sizeof t->followers);
        if (t->counts_followers && !count_followers(t, t->queue.now, most)) {
            c->failed = c->exhausted = true;
            return;
        }
        shade_batch(t, t->queue.now, t->queue.now->out);
    }
}

/* A ray that is none: outside of the camera's picture, or of a camera that is not valid. */
static void leave_out(const pov_tracer *t, const pov_ray *ray, colour *out, float *alpha)
{
    const bool is_outside = isinf(ray->dir.x);

    *out = is_outside ? colour_of(0.0f, 0.0f, 0.0f) : t->context.scene->model->background;
    if (alpha)
        *alpha = is_outside ? 0.0f : 1.0f;
}

/* Rays that are no samples of a picture have random numbers by their directions. */
static const sample_id *number_rays(pov_tracer *t, const pov_ray *rays, uint32_t n)
{
    if (!t->context.scene->plan->random)
        return NULL;
    for (uint32_t i = 0; i < n; i++) {
        const uint64_t bits = mix_bits(elementary_bits(rays[i].dir.x) * 0x9e3779b97f4a7c15u ^ elementary_bits(rays[i].dir.y));
        const sample_id id = { mix_bits(bits ^ elementary_bits(rays[i].dir.z)), 0, 0, 0 };

        t->own_samples[i] = id;
    }
    return t->own_samples;
}

/* Up to BATCH_MAX rays. */
static void trace(pov_tracer *t, const pov_ray *rays, uint32_t n, unsigned known, const sample_id *samples, colour *out,
                  float *alpha)
{
    uint64_t begun;
    uint32_t i;

    for (i = 0; i < n; i++)
        out[i] = colour_of(0.0f, 0.0f, 0.0f);
    t->context.samples = samples ? samples : number_rays(t, rays, n);
    if (t->photons && !take_maps(t, rays, n))
        return;
    t->context.alpha = alpha;
    for (i = 0; alpha && i < n; i++)
        alpha[i] = 1.0f;
    batch_forget(&t->queue, &t->context);
    begun = begin(t, rays, n, known);
    if (t->camera.count > 0)
        tracer_follow(t, &t->camera, out);
    accumulate_end(out, n);
    for (i = 0; t->camera_odd && i < n; i++)
        if (!(begun >> i & 1))
            leave_out(t, &rays[i], &out[i], alpha ? &alpha[i] : NULL);
}

colour tracer_color(pov_tracer *t, const pov_ray *ray)
{
    colour seen;

    trace(t, ray, 1, 0, NULL, &seen, NULL);
    return seen;
}

/* Batches are no larger than the number of rays between two checks for an interrupt. */
void tracer_colors(pov_tracer *t, const pov_ray *rays, uint32_t n, unsigned known, const sample_id *samples, colour *out,
                   float *alpha)
{
    const interrupt *ask = &t->context.interrupt;
    uint32_t i, some;

    for (i = 0; i < n && !t->context.failed && !ask->given_up; i += some) {
        some = ask->ask && ask->every < BATCH_MAX && !t->context.scene->plan->radiosity ? (uint32_t)ask->every : BATCH_MAX;
        some = some < n - i ? some : n - i;
        trace(t, rays + i, some, known, samples ? samples + i : NULL, out + i, alpha ? alpha + i : NULL);
    }
}
