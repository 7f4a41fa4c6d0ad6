#include "shade/shading.h"

#include "base/err.h"
#include "base/vec.h"
#include "shade/air.h"
#include "shade/merge.h"
#include "shade/photons.h"
#include "shade/stack.h"
#include "texture/texture.h"

static uint32_t larger(uint32_t a, uint32_t b) { return a > b ? a : b; }

/* A texture of one pigment, whose normal alone varies. */
static bool has_one_pigment(const material *of)
{
    const texture *t = of->texture;

    return t && !of->inside && t->blend == BLEND_NONE && !t->pigment->pattern && !t->pigment->pigments;
}

/* Of a texture that varies it says what there may be anywhere. */
static void make_appearance(shading *s, appearance *out, const model *m, const material *of)
{
    const bool one = has_one_pigment(of);
    const pigment whole = { of->pigment, of->filter, of->transmit }, at = one ? of->texture->pigment->most : whole;

    appearance_make(out, s->plan, m, one ? &of->texture->finish : &of->finish, &at);
    appearance_set_material(out, of);
    out->varies = of->texture != NULL;
    out->one_pigment = one;
    out->needs_point |= out->varies;
    out->lasts = true;
    out->even = !out->reflective && !out->transmissive && !of->inside && !(out->kinds & (FINISH_IRID | FINISH_CRAND)) &&
                !(out->below_weight > 0.0f) && !(of->texture && texture_is_of_view(of->texture));
    s->angular |= !out->varies && out->angular;
    s->even &= out->even;
}

static bool make_appearances(shading *s, const model *m)
{
    s->even = true;
    s->appearances = env_alloc(m->env, m->materials.count, sizeof *s->appearances);
    for (size_t i = 0; s->appearances && i < m->materials.count; i++)
        make_appearance(s, &s->appearances[i], m, &m->materials.items[i]);
    return s->appearances || m->materials.count == 0;
}

/* ---- finishes of textures ---- */

typedef struct finish_list { const finish **items; size_t count, capacity; } finish_list;

static bool add_finishes(finish_list *list, const env *e, const texture *of)
{
    const finish *own = &of->finish;
    bool done = true;

    if (of->blend == BLEND_NONE)
        return VEC_PUSH(e, list, own);
    for (uint32_t i = 0; done && i < of->count; i++)
        done = add_finishes(list, e, of->textures[i]);
    return done;
}

/* What textures ask of the surface. */
static void note_texture(shading *s, const texture *of)
{
    s->most_terms = larger(s->most_terms, texture_most_terms(of));
    s->views |= texture_is_of_view(of);
    s->uvs |= texture_has_uv(of);
    s->worlds |= texture_is_of_world(of);
}

static bool list_finishes(shading *s, finish_list *list)
{
    const model *m = s->model;
    const material *last = NULL;

    for (size_t i = 0; i < m->materials.count; i++) {
        const material *of = &m->materials.items[i];

        if (!of->texture || (last && last->texture == of->texture && last->inside == of->inside))
            continue;
        last = of;
        if (!add_finishes(list, m->env, of->texture) || (of->inside && !add_finishes(list, m->env, of->inside)))
            return false;
        note_texture(s, of->texture);
        if (of->inside)
            note_texture(s, of->inside);
    }
    return true;
}

/* The slot of a finish, or the free one where it belongs. */
static inline appearance *slot_of(const shading *s, const finish *of)
{
    size_t i = (size_t)(((uint64_t)(uintptr_t)of >> 3) * 0x9e3779b97f4a7c15u >> 32);

    for (i &= s->finish_slots - 1; s->finishes[i].finish && s->finishes[i].finish != of; i = (i + 1) & (s->finish_slots - 1))
        ;
    return &s->finishes[i];
}

static bool make_slots(shading *s, const env *e, size_t count)
{
    for (s->finish_slots = 2; s->finish_slots < 2 * count; s->finish_slots *= 2)
        ;
    s->finishes = env_alloc(e, s->finish_slots, sizeof *s->finishes);
    return s->finishes != NULL;
}

static bool make_finishes(shading *s, const model *m)
{
    static const pigment none;
    finish_list list = { NULL, 0, 0 };
    bool done = list_finishes(s, &list) && (list.count == 0 || make_slots(s, m->env, list.count));

    for (size_t i = 0; done && i < list.count; i++) {
        appearance *to = slot_of(s, list.items[i]);

        if (to->finish)
            continue;
        appearance_make(to, s->plan, m, list.items[i], &none);
        s->angular |= to->angular;
    }
    env_free(m->env, list.items);
    return done;
}

const appearance *shading_finish(const shading *s, const finish *of) { return slot_of(s, of); }

/* ---- stacks of constant layers ---- */

/* Matt layers are merged at each hit, and need no stack. */
static bool is_merged(const shading *s, const stack *of)
{
    for (uint32_t k = 0; k < of->count; k++)
        if (!merge_takes(&of->layers[k].appearance))
            return false;
    return merge_is_possible(s);
}

static bool add_stack(shading *s, const model *m, size_t which)
{
    stack *one = stack_create(s->plan, m, &m->materials.items[which]);

    if (!one || !vec_reserve(m->env, (void **)&s->stacks, &s->stack_capacity, s->stack_count, sizeof *s->stacks)) {
        env_free(m->env, one);
        return false;
    }
    s->stacks[s->stack_count++] = one;
    if (is_merged(s, one))
        return true;
    s->appearances[which].stack = one;
    if (s->flat_stacks)
        stack_make_flat(one, &s->appearances[which]);
    return true;
}

/* Is all light of such a kind that it can reach the layers of one hit together? */
static bool lights_stacks(const shading *s, const model *m)
{
    const bool plain = !s->plan->radiosity && !s->plan->subsurface && !s->photons && m->light_groups.count == 0;

    for (size_t k = 0; plain && k < s->light_count; k++)
        if (s->lights[k].light->through_count > 0 || (s->lights[k].light->flags & LIGHT_AREA_ILLUMINATION))
            return false;
    return plain;
}

static bool make_stacks(shading *s, const model *m)
{
    s->flat_stacks = s->most_terms > 1 && lights_stacks(s, m);
    for (size_t i = 0; i < m->materials.count; i++)
        if (stack_is_there(&m->materials.items[i]) && !add_stack(s, m, i))
            return false;
    return true;
}

static void free_stacks(shading *s)
{
    for (size_t i = 0; i < s->stack_count; i++)
        env_free(s->model->env, s->stacks[i]);
    env_free(s->model->env, s->stacks);
}

/* ---- lights ---- */

static bool make_light(scene_light *out, const model *m, const light *l)
{
    const bool is_area = (l->flags & LIGHT_AREA) && l->area.counts[0] * l->area.counts[1] > 1;

    out->light = l;
    out->class = light_class_of(l);
    out->grid = is_area ? grid_create(m->env, l, m->soft_lights) : NULL;
    return out->grid || !is_area;
}

static bool make_lights(shading *s, const model *m)
{
    s->light_count = m->lights.count;
    s->lights = env_alloc(m->env, s->light_count, sizeof *s->lights);
    for (size_t i = 0; s->lights && i < s->light_count; i++)
        if (!make_light(&s->lights[i], m, &m->lights.items[i]))
            return false;
    return s->lights || s->light_count == 0;
}

/* How far away from the camera the scene's finite objects are, at most. */
static double find_scale(const model *m, const world *w)
{
    pov_vec3 far;
    pov_box box;

    if (!world_bounds(w, &box))
        return 1.0;
    far = pov_vec3_of(pov_max(fabs(box.lo.x - m->camera.location.x), fabs(box.hi.x - m->camera.location.x)),
                      pov_max(fabs(box.lo.y - m->camera.location.y), fabs(box.hi.y - m->camera.location.y)),
                      pov_max(fabs(box.lo.z - m->camera.location.z), fabs(box.hi.z - m->camera.location.z)));
    return sqrt(pov_dot(far, far));
}

pov_status shading_create(shading **out, const model *m, const world *w, pov_error *err)
{
    shading *s = env_alloc(m->env, 1, sizeof *s);
    pov_status status;

    if (!s)
        return err_memory(err);
    s->model = m;
    s->world = w;
    s->plan = world_plan(w);
    s->dims = air_dims(m) || s->plan->media;
    s->air = s->dims || !air_is_plain(m);
    s->behind = air_is_plain(m) ? air_plain_colour(m) : m->background;
    s->scale = find_scale(m, w);
    s->objects_info = world_object_info(w);
    s->own_names = world_own_names(w);
    s->solids = world_own_solids(w);
    s->unseen.transmissive = s->unseen.needs_point = s->unseen.clear = true;
    finish_init(&s->plain_finish);
    s->unseen.finish = &s->plain_finish;
    s->unseen.onward.filter = coefficient_of(colour_of(1.0f, 1.0f, 1.0f));
    if (!make_appearances(s, m) || !make_finishes(s, m) || !make_lights(s, m)) {
        shading_destroy(s);
        return err_memory(err);
    }
    status = photons_create(s, err);
    if (status >= 0 && !make_stacks(s, m))
        status = err_memory(err);
    if (status < 0) {
        shading_destroy(s);
        return status;
    }
    *out = s;
    return POV_OK;
}

void shading_destroy(shading *s)
{
    if (!s)
        return;
    photons_destroy(s->photons);
    free_stacks(s);
    env_free(s->model->env, s->appearances);
    env_free(s->model->env, s->finishes);
    for (size_t i = 0; s->lights && i < s->light_count; i++)
        env_free(s->model->env, s->lights[i].grid);
    env_free(s->model->env, s->lights);
    env_free(s->model->env, s);
}
