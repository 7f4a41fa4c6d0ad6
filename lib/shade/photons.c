#include "shade/photons.h"

#include "base/err.h"
#include "shade/photon_flight.h"
#include "world/object_box.h"

/* ---- targets ---- */

static uint32_t flags_of(const model *m, uint32_t leaf) { return model_leaf(m, leaf)->flags; }

/* Leaves of one solid are one target: they have the same box. */
static bool is_target(const model *m, uint32_t leaf)
{
    const uint32_t flags = flags_of(m, leaf), acts = PHOTON_REFLECTS | PHOTON_REFRACTS;
    uint32_t of_lights = 0;

    for (size_t i = 0; i < m->lights.count; i++)
        of_lights |= m->lights.items[i].flags;
    return (flags & PHOTON_TARGET) && !(flags & LEAF_NO_SHADOW) && ((flags | of_lights) & acts);
}

static bool is_same_object(const shading *s, uint32_t a, uint32_t b)
{
    return s->objects_info[a].member && s->objects_info[b].member &&
           model_object_of(s->model, a) == model_object_of(s->model, b);
}

/* The targets in the order of their leaves. False: no memory. */
static bool find_targets(photon_scene *p, const shading *s)
{
    const model *m = s->model;
    uint32_t last = 0;

    p->target_of = env_alloc(p->env, m->leaves.count, sizeof *p->target_of);
    p->targets = env_alloc(p->env, m->leaves.count, sizeof *p->targets);
    p->target_flags = env_alloc(p->env, m->leaves.count, sizeof *p->target_flags);
    if (!p->target_of || !p->targets || !p->target_flags)
        return false;
    for (uint32_t i = 0; i < m->leaves.count; i++) {
        photon_target *t = &p->targets[p->target_count];

        if (!is_target(m, i))
            continue;
        if (p->target_count > 0 && is_same_object(s, last, i)) {
            p->target_of[i] = (uint32_t)p->target_count;
            continue;
        }
        t->boxed = world_object_box(s->world, i, &t->box);
        p->target_flags[p->target_count++] = flags_of(m, i);
        p->target_of[i] = (uint32_t)p->target_count;
        last = i;
    }
    return true;
}

/* ---- what blocks ---- */

/* Photons of the aim enter its target, as far as some rays tell. */
static bool enters(pov_tracer *t, const photon_scene *p, const photon_aim *aim)
{
    enum { SOME = 64, MOST = 1024 };
    const uint32_t total = photon_store_emissions(&p->aims, 0);

    for (uint32_t first = 0; first < total && first < MOST; first += SOME) {
        const photon_chunk chunk = { aim, 0, 0, first, total - first < SOME ? total - first : SOME, total };

        if (photon_flight_enters(t, &chunk))
            return true;
    }
    return false;
}

static void find_blocks(pov_tracer *t, photon_scene *p, const model *m)
{
    for (size_t i = 0; i < p->aims.count; i++) {
        const photon_aim *a = &p->aims.items[i];
        bool *blocks = &p->blocks[a->light_number * p->target_count + a->target];

        if (!*blocks && photons_refract(p->target_flags[a->target], m->lights.items[a->light_number].flags))
            *blocks = enters(t, p, a);
    }
}

void photons_aim(shade_context *c, size_t which)
{
    const photon_scene *p = c->scene->photons;

    c->blocks = p && p->target_count > 0 ? p->blocks + which * p->target_count : NULL;
}

bool photons_block(const shade_context *c, const pov_ray *ray, const pov_crossing *at, uint32_t count)
{
    const uint32_t *target_of = c->scene->photons->target_of, from = ray->origin_surface;

    if (from != POV_NO_OWNER && (flags_of(c->scene->model, from) & PHOTON_IGNORES))
        return false;
    for (uint32_t i = 0; i < count; i++)
        if (at[i].owner < c->scene->model->leaves.count && target_of[at[i].owner] && c->blocks[target_of[at[i].owner] - 1])
            return true;
    return false;
}

/* ---- making ---- */

static bool make(photon_scene *p, const shading *s)
{
    const model *m = s->model;
    pov_box around;

    p->max_level = m->photons.max_trace_level >= 0 ? m->photons.max_trace_level : m->max_trace_level;
    p->bailout = (float)(m->photons.adc_bailout >= 0.0 ? m->photons.adc_bailout : m->adc_bailout);
    if (!find_targets(p, s) || !emission_aim(&p->aims, m, p->targets, p->target_flags, p->target_count,
                                             world_bounds(s->world, &around) ? &around : NULL))
        return false;
    p->blocks = env_alloc(p->env, m->lights.count * p->target_count + 1, sizeof *p->blocks);
    p->store = photon_store_create(p->env, &p->aims);
    return p->blocks && p->store;
}

pov_status photons_create(shading *s, pov_error *err)
{
    photon_scene *p;
    pov_tracer *t = NULL;
    pov_status status;

    if (!s->plan->photons)
        return POV_OK;
    p = env_alloc(s->model->env, 1, sizeof *p);
    if (!p)
        return err_memory(err);
    p->env = s->model->env;
    s->photons = p;
    if (!make(p, s))
        return err_memory(err);
    status = tracer_create(&t, s, err);
    if (status < 0)
        return status;
    find_blocks(t, p, s->model);
    status = t->context.failed ? err_memory(err) : POV_OK;
    tracer_destroy(t);
    return status;
}

void photons_destroy(photon_scene *p)
{
    if (!p)
        return;
    photon_store_destroy(p->store);
    emission_free(&p->aims);
    env_free(p->env, p->blocks);
    env_free(p->env, p->target_flags);
    env_free(p->env, p->targets);
    env_free(p->env, p->target_of);
    env_free(p->env, p);
}
