#include "shade/photon_flight.h"

#include "base/vec.h"
#include "media/march.h"
#include "shade/interior_walk.h"
#include "shade/scatter.h"

/* Photons of a chunk on their way; what the surfaces of the present batch do to them. */
typedef struct flight {
    pov_tracer *tracer;
    const photon_scene *scene;
    const photon_chunk *chunk;
    photon_catch *out;           /* NULL: only whether they enter the target is asked */
    bool entered;
    bool reflects[BATCH_MAX], transmits[BATCH_MAX];
} flight;

/* ---- at surfaces ---- */

static const light *light_of(const flight *f)
{
    return &f->tracer->context.scene->model->lights.items[f->chunk->aim->light_number];
}

/* What lies close to a solid is not lit by what arrives at the solid's surface from within. */
static uint32_t held_by(const flight *f, const surface *s)
{
    const shading *scene = f->tracer->context.scene;
    const bool within = !s->at->outside && plan_is_solid(model_leaf(scene->model, s->at->object));

    return within ? shading_solid(scene, s->at->object) : photon_free;
}

static void deposit(flight *f, const surface *s, pov_vec3 normal)
{
    const pov_vec3 dir = pov_unit(s->ray->dir);
    const float by = (float)emission_factor(light_of(f), s->from->travelled);
    const photon p = { s->at->point, colour_scale(s->from->factor.by, by),
                       { (float)dir.x, (float)dir.y, (float)dir.z }, { (float)normal.x, (float)normal.y, (float)normal.z }, held_by(f, s) };

    if (!colour_is_black(p.flux) && !VEC_PUSH(f->scene->env, &f->out->of[PHOTON_ON], p))
        f->tracer->context.failed = true;
}

/* ---- in media ---- */

/* The photon at a random point of a segment, for part of its length. */
static void leave_at(flight *f, const path *p, const media_set *set, const media_segment *on, double at, double part)
{
    const media_segment before = { on->from, on->dir, at };
    const float by = (float)(part * emission_factor(light_of(f), p->travelled + at));
    const colour left = media_transmittance(f->tracer->context.scene->model, set, &before);
    const photon one = { pov_add(on->from, pov_scale(on->dir, at)), colour_scale(colour_mul(p->factor.by, left), by),
                         { (float)on->dir.x, (float)on->dir.y, (float)on->dir.z }, { 0.0f, 0.0f, 0.0f }, photon_free };

    if (!colour_is_black(one.flux) && !VEC_PUSH(f->scene->env, &f->out->of[PHOTON_IN], one))
        f->tracer->context.failed = true;
}

/* The fewer photons a map has, the more points has each; one of the first level has four. */
static void leave_in(flight *f, const path *p, const media_set *set, const media_segment *on)
{
    const uint32_t level = f->chunk->map / PHOTON_HALVES, n = level < 2 ? 4u >> level : 1;
    const media_random random = media_random_of(on);
    const double part = on->length / n;

    for (uint32_t i = 0; i < n; i++)
        leave_at(f, p, set, on, ((double)i + media_number(&random, i)) * part, part);
}

/* What media of objects do to a photon on its way to a surface: they dim it, and scatter what met the target before. Neither
 * the atmosphere nor fog does, as in POV-Ray. */
static void cross_media(flight *f, const surface *s, path *p, double length)
{
    const shade_context *c = &f->tracer->context;
    const media_segment on = { s->ray->org, pov_unit(s->ray->dir), length };
    interior_walk w;
    media_set set;

    walk_begin(c, p, &w);
    walk_media(c->scene, &w, &set);
    if (set.count == 0 || !(length > 0.0))
        return;
    if (p->struck && f->out && set.scatters && c->scene->model->photons.media)
        leave_in(f, p, &set, &on);
    p->factor.by = colour_mul(p->factor.by, media_transmittance(c->scene->model, &set, &on));
}

/* ---- arrival ---- */

/* What becomes of a photon at a surface: on its way to the target it goes through what lets photons pass, at the target
 * and behind it it is reflected and refracted where that is on. */
static void decide(flight *f, uint32_t i, const surface *s, path *p)
{
    const uint32_t flags = model_leaf(f->tracer->context.scene->model, s->at->object)->flags, own = light_of(f)->flags;
    const bool is_target = f->scene->target_of[s->at->object] == f->chunk->aim->target + 1;

    if (!p->struck && !is_target) {
        f->reflects[i] = false;
        f->transmits[i] = (flags & PHOTON_THROUGH) != 0;
        return;
    }
    p->struck = true;
    f->reflects[i] = photons_reflect(flags, own);
    f->transmits[i] = photons_refract(flags, own);
}

/* Photons arrive: those that met the target before are collected, unless the surface reflects no light or collects none. */
static void arrive(flight *f, surfaces *on)
{
    const model *m = f->tracer->context.scene->model;

    for (uint32_t i = 0; i < on->count; i++) {
        surface *s = &on->at[i];
        path *p = s->from;
        const double far = s->at->crossing.t * sqrt(pov_dot(s->ray->dir, s->ray->dir));

        if (f->tracer->context.scene->plan->media)
            cross_media(f, s, p, far);
        p->travelled += far;
        f->entered = f->entered || (p->struck && !p->mirrored);
        if (p->struck && f->out && s->appearance->lit && !(model_leaf(m, s->at->object)->flags & PHOTON_IGNORES))
            deposit(f, s, lanes_at(&on->geometry.to.normal, i));
        decide(f, i, s, p);
    }
}

/* ---- onwards ---- */

/* Leave out the rays that photons do not take. */
static void restrain(const flight *f, surfaces *on, uint32_t i, uint32_t of)
{
    appearance *own = &on->varying[i];

    if (on->at[i].appearance != own)
        *own = *on->at[i].appearance;
    own->reflective = own->reflective && f->reflects[of];
    own->transmissive = own->transmissive && f->transmits[of];
    own->powered = false;
    on->at[i].appearance = own;
}

static void fly_layers(flight *f)
{
    pov_tracer *t = f->tracer;
    shade_context *c = &t->context;
    layers *l = t->layers;

    for (layers_begin(l); !c->failed && layers_take(c, l, &t->surfaces, &t->painted);) {
        for (uint32_t i = 0; i < l->on.count; i++)
            restrain(f, &l->on, i, l->of[i].of);
        scatter_layers(c, l, &t->queue);
    }
}

static void fly_batch(flight *f, batch *b, colour *unused)
{
    pov_tracer *t = f->tracer;
    shade_context *c = &t->context;
    bool plain;

    surfaces_find(c, &t->surfaces, b, NULL);
    batch_begin(&t->queue, unused);
    plain = surfaces_complete(c, &t->surfaces, &t->painted) != PAINT_TERMS;
    arrive(f, &t->surfaces);
    if (!plain) {
        fly_layers(f);
        return;
    }
    for (uint32_t i = 0; i < t->surfaces.count; i++)
        restrain(f, &t->surfaces, i, i);
    t->surfaces.alike = false;
    scatter(c, &t->surfaces, &t->queue);
}

/* Up to BATCH_MAX emissions, and all that becomes of them. */
static void fly(flight *f, uint32_t first, uint32_t n)
{
    pov_tracer *t = f->tracer;
    shade_context *c = &t->context;
    const photon_chunk *chunk = f->chunk;
    batch *b = &t->camera;
    colour unused[BATCH_MAX];
    emission_batch e;

    emission_rays(chunk->aim, chunk->seed, chunk->map, chunk->first + first, n, chunk->total, &e);
    tracer_begin(t, e.rays, n, e.flux);
    do
        fly_batch(f, b, unused);
    while (!c->failed && batch_next(&t->queue, c) && (b = t->queue.now) != NULL);
}

static bool fly_chunk(flight *f)
{
    shade_context *c = &f->tracer->context;
    const pov_counts counts = c->counts;
    float *const alpha = c->alpha;

    c->photons_fly = true;
    c->alpha = NULL;
    for (uint32_t i = 0; i < f->chunk->count && !c->failed; i += BATCH_MAX)
        fly(f, i, f->chunk->count - i < BATCH_MAX ? f->chunk->count - i : BATCH_MAX);
    c->failed = c->failed || query_context_failed(c->context);
    c->photons_fly = false;
    c->alpha = alpha;
    c->counts = counts;
    return !c->failed;
}

bool photon_flight_trace(void *tracer, const photon_chunk *chunk, photon_catch *out)
{
    pov_tracer *t = tracer;
    flight f = { .tracer = t, .scene = t->context.scene->photons, .chunk = chunk, .out = out };

    return fly_chunk(&f);
}

bool photon_flight_enters(pov_tracer *t, const photon_chunk *chunk)
{
    flight f = { .tracer = t, .scene = t->context.scene->photons, .chunk = chunk };

    return fly_chunk(&f) && f.entered;
}
