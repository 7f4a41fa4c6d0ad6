#include "shade/paint.h"

#include "base/simd.h"
#include "shade/coloured.h"
#include "shade/layered.h"
#include "shade/merge.h"
#include "shade/paint_group.h"
#include "shade/stack.h"
#include "texture/normal.h"
#include "world/detail.h"

/* The layers of all stacks are behind them. */
static bool make_stacks(painted *p, const env *e)
{
    stack_layer *layers;

    p->stacks = env_alloc(e, BATCH_MAX, sizeof *p->stacks + STACK_LEVELS * sizeof *layers);
    layers = p->stacks ? (stack_layer *)(p->stacks + BATCH_MAX) : NULL;
    for (uint32_t i = 0; p->stacks && i < BATCH_MAX; i++)
        p->stacks[i].layers = layers + STACK_LEVELS * i;
    p->layered = env_alloc_aligned(e, STACK_LEVELS * sizeof *p->layered, SIMD_LINE);
    return p->stacks && p->layered;
}

bool paint_create(painted *p, const shading *scene)
{
    const size_t capacity = (size_t)scene->most_terms * BATCH_MAX;

    if (capacity == 0)
        return true;
    p->terms = env_alloc(scene->model->env, capacity, sizeof *p->terms);
    p->order = env_alloc(scene->model->env, capacity, sizeof *p->order);
    return p->terms && p->order && (!scene->flat_stacks || make_stacks(p, scene->model->env));
}

void paint_destroy(painted *p, const env *e)
{
    env_free(e, p->terms);
    env_free(e, p->order);
    env_free(e, p->stacks);
    env_free_aligned(e, p->layered);
}

/* ---- points ---- */

static void add(paint_group *g, const shading *scene, const surfaces *s, uint32_t lane)
{
    const hit *h = s->at[lane].at;

    paint_group_add_point(g, scene, h);
    if (scene->uvs)
        paint_group_add_uv(g, scene, h);
    lanes_put(&g->points.normal, g->count, lanes_at(s->geometry.raw, lane));
    if (scene->views)
        lanes_put(&g->points.view, g->count, pov_unit(s->at[lane].ray->dir));
    g->lane[g->count++] = (uint8_t)lane;
}

/* As a rule all surfaces of a batch are of one material: their points stand there by lane. The others are added one by one. */
static bool are_alike(const surfaces *s)
{
    const appearance *first = s->at[0].appearance;
    bool alike = first->varies && !first->stack && !first->material->inside && first->material->texture->blend != BLEND_PARTS;

    for (uint32_t i = 0; alike && i < s->count; i++)
        alike = s->at[i].appearance == first;
    return alike;
}

/* All of a group have been added. */
static void finish_points(paint_group *g, const shading *scene, const surfaces *s)
{
    uint32_t object[BATCH_MAX];

    for (uint32_t i = 0; paint_has_spaces(scene->model) && i < g->count; i++)
        object[i] = s->at[g->lane[i]].at->object;
    paint_group_enter(g, scene, object);
}

static void copy_lanes(const vec_lanes *from, uint32_t n, vec_lanes *to)
{
    const size_t size = lanes_whole(n) * sizeof(double);

    memcpy(to->x, from->x, size);
    memcpy(to->y, from->y, size);
    memcpy(to->z, from->z, size);
}

static void add_all(paint_group *g, const shading *scene, const surfaces *s)
{
    copy_lanes(&s->geometry.to.point, s->count, &g->points.at);
    copy_lanes(&s->geometry.to.point_lo, s->count, &g->points.at_lo);
    copy_lanes(s->geometry.raw, s->count, &g->points.normal);
    if (scene->worlds)
        copy_lanes(&s->geometry.to.point, s->count, &g->points.world);
    for (; g->count < s->count; g->count++) {
        g->lane[g->count] = (uint8_t)g->count;
        if (scene->uvs)
            paint_group_add_uv(g, scene, s->at[g->count].at);
        if (scene->views)
            lanes_put(&g->points.view, g->count, pov_unit(s->at[g->count].ray->dir));
    }
    finish_points(g, scene, s);
}

/* ---- terms ---- */

static const texture *texture_at(const shading *scene, const surface *s, const pov_ray *ray)
{
    return paint_texture_of(scene, s->appearance->material, ray, s->at);
}

/* Bit i: the texture of surface i is to be evaluated. */
static uint64_t varying(const surfaces *s)
{
    uint64_t lanes = 0;

    for (uint32_t i = 0; i < s->count; i++)
        lanes |= (uint64_t)(s->at[i].appearance->varies & !s->at[i].appearance->stack) << i;
    return lanes;
}

/* Of these lanes those of the first one's texture are added. Returns the others. */
static uint64_t add_some(paint_group *g, const shading *scene, const surfaces *s, uint64_t lanes)
{
    uint64_t rest = lanes;

    paint_group_begin(g, texture_at(scene, &s->at[first_of64(lanes)], s->rays[first_of64(lanes)]));
    for (; lanes; lanes &= lanes - 1) {
        const uint32_t i = first_of64(lanes);

        if (texture_at(scene, &s->at[i], s->rays[i]) != g->texture)
            continue;
        add(g, scene, s, i);
        rest &= ~((uint64_t)1 << i);
    }
    finish_points(g, scene, s);
    return rest;
}

/* The terms of all of them, one texture after the other. Returns their number. */
static uint32_t evaluate(const shading *scene, const surfaces *s, painted *p)
{
    uint32_t count = 0;
    paint_group g;

    if (s->count > 0 && are_alike(s)) {
        paint_group_begin(&g, s->at[0].appearance->material->texture);
        add_all(&g, scene, s);
        return texture_eval(scene->model, g.texture, &g.points, g.count, p->terms);
    }
    for (uint64_t rest = varying(s); rest;) {
        uint32_t n;

        rest = add_some(&g, scene, s, rest);
        n = texture_eval(scene->model, g.texture, &g.points, g.count, p->terms + count);
        for (uint32_t i = 0; i < n; i++, count++)
            p->terms[count].lane = g.lane[p->terms[count].lane];
    }
    return count;
}

/* As many terms for each surface, as a rule in their order. False: not so. */
static bool are_in_order(painted *p, uint32_t each, uint32_t surface_count)
{
    uint32_t k = 0;

    for (uint32_t i = 0; i < surface_count; i++) {
        p->first[i] = k;
        for (uint32_t end = k + each; k < end; k++) {
            if (p->terms[k].lane != i)
                return false;
            p->order[k] = k;
        }
    }
    p->first[surface_count] = k;
    return true;
}

/* Terms of a surface stay in their order. */
static void sort(painted *p, uint32_t count, uint32_t surface_count)
{
    uint32_t next[BATCH_MAX];

    if (surface_count > 0 && count % surface_count == 0 && are_in_order(p, count / surface_count, surface_count))
        return;
    for (uint32_t i = 0; i <= surface_count; i++)
        p->first[i] = 0;
    for (uint32_t i = 0; i < count; i++)
        p->first[p->terms[i].lane + 1]++;
    for (uint32_t i = 0; i < surface_count; i++)
        next[i] = p->first[i + 1] += p->first[i];
    for (uint32_t i = count; i-- > 0;)
        p->order[--next[p->terms[i].lane]] = i;
}

bool paint_is_single(const painted *p, uint32_t of)
{
    const uint32_t from = p->first[of], count = p->first[of + 1] - from;

    return count == 0 || (count == 1 && p->terms[p->order[from]].share == 1.0f);
}

/* ---- stacks ---- */

/* Is it one stack of few layers that have the surface's normal? */
static bool may_be_flat(const painted *p, uint32_t of)
{
    const uint32_t from = p->first[of], end = p->first[of + 1];

    for (uint32_t k = from; k < end; k++) {
        const texture_term *t = &p->terms[p->order[k]];

        if (t->bent || t->share != 1.0f || (k > from && t->first))
            return false;
    }
    return end - from <= STACK_LEVELS;
}

/* Make the terms of a surface a flat stack, where they are one. finished: of the layers of the last one, as a rule the same. */
static bool make_flat(const shading *scene, surfaces *s, const painted *p, uint32_t of, const appearance *finished[STACK_LEVELS])
{
    const uint32_t from = p->first[of], count = p->first[of + 1] - from;
    stack *out = &p->stacks[of];
    appearance *whole = &s->varying[of];

    if (!may_be_flat(p, of))
        return false;
    out->count = count;
    for (uint32_t k = 0; k < count; k++) {
        const texture_term *t = &p->terms[p->order[from + k]];
        stack_layer *one = &out->layers[k];

        if (!finished[k] || finished[k]->finish != t->finish)
            finished[k] = shading_finish(scene, t->finish);
        appearance_paint(&one->appearance, scene->plan, scene->model, finished[k], &t->pigment);
        appearance_set_material(&one->appearance, s->at[of].appearance->material);
        one->of.first = k == 0;
        one->of.last = k + 1 == count;
        one->of.share = 1.0f;
    }
    stack_weigh(out, scene->plan, scene->model);
    *whole = out->layers[0].appearance;
    stack_make_flat(out, whole);
    whole->stack = out;
    if (out->flat)
        s->at[of].appearance = whole;
    return out->flat;
}

/* Terms that are not one: flat stacks, or as one if they are matt. False: some are neither. */
static bool join(const shading *scene, surfaces *s, painted *p, bool *stacks)
{
    const appearance *finished[STACK_LEVELS] = { NULL };
    bool joined = true;

    for (uint32_t i = 0; joined && i < s->count; i++) {
        if (paint_is_single(p, i) || paint_is_merged(p, i))
            continue;
        joined = scene->flat_stacks && make_flat(scene, s, p, i, finished);
        p->merged |= (uint64_t)joined << i;
        *stacks |= joined;
    }
    return joined;
}

/* There are no terms. */
static void begin_none(const surfaces *s, painted *p)
{
    memset(p->first, 0, (s->count + 1) * sizeof p->first[0]);
    p->merged = 0;
}

/* The normals of all surfaces, which are of one texture. */
static void perturb_all(const shading *scene, const paint_group *g, surfaces *s)
{
    copy_lanes(&g->points.normal, g->count, &s->geometry.bent);
    normal_eval(scene->model, g->texture->normal, NULL, &g->points, g->count, &s->geometry.bent);
    s->geometry.shading = &s->geometry.bent;
}

/* Surfaces of one pigment need no terms: their normals alone are bent. False: they are not all of one such material. */
static bool find_normals_alike(const shading *scene, surfaces *s, painted *p)
{
    const texture *of = s->count > 0 && s->at[0].appearance->one_pigment ? s->at[0].appearance->material->texture : NULL;
    paint_group g;

    if (!of || !of->normal || !are_alike(s))
        return false;
    paint_group_begin(&g, of);
    add_all(&g, scene, s);
    perturb_all(scene, &g, s);
    begin_none(s, p);
    return true;
}

/* Paint a surface over what it has been, as far as that is of the same finish and material. keeps: nothing else writes there. */
static inline void repaint(const shading *scene, const appearance *of, bool keeps, const pigment *value, surface *at, appearance *out)
{
    const material *own = at->appearance->material;

    if (!keeps || out->finish != of->finish || out->material != own) {
        *out = *of;
        appearance_set_material(out, own);
    }
    if (appearance_is_plain(out, scene->plan, value))
        appearance_repaint_plain(out, scene->model, value);
    else
        appearance_repaint(out, scene->plan, scene->model, value);
    at->appearance = out;
}

/* NULL: it does not vary. */
static const texture *texture_of_first(const surfaces *s)
{
    const appearance *of = s->count > 0 ? s->at[0].appearance : NULL;

    return of && of->varies && !of->stack ? of->material->texture : NULL;
}

/* Surfaces of one material with one layer, whose pigment does not ask for perturbed normals, need no terms either. False: they are not
 * such. */
static bool paint_alike(const shading *scene, surfaces *s, painted *p)
{
    const texture *of = texture_of_first(s);
    pigment pigments[BATCH_MAX];
    const appearance *finished;
    bool coloured;
    paint_group g;

    if (!of || s->at[0].appearance->one_pigment || of->blend != BLEND_NONE || !are_alike(s) || texture_sees_bent(of))
        return false;
    paint_group_begin(&g, of);
    add_all(&g, scene, s);
    if (of->normal)
        perturb_all(scene, &g, s);
    pigment_eval(scene->model, of->pigment, &g.points, g.count, pigments);
    finished = shading_finish(scene, &of->finish);
    coloured = coloured_put(scene, finished, pigments, s);
    for (uint32_t i = 0; !coloured && i < s->count; i++)
        repaint(scene, finished, scene->most_terms == 1, &pigments[i], &s->at[i], &s->varying[i]);
    begin_none(s, p);
    return true;
}

/* Nor do those of one material with layers that are as one. False: they are not such. */
static bool merge_alike(const shading *scene, surfaces *s, painted *p)
{
    const texture *of = texture_of_first(s);
    paint_group g;

    if (!of || !are_alike(s) || !merge_takes_layers(scene, of) || s->at[0].appearance->material->double_illuminate)
        return false;
    paint_group_begin(&g, of);
    add_all(&g, scene, s);
    merge_layers(scene, of, &g.points, s);
    begin_none(s, p);
    return true;
}

/* Nor those of layers that differ by their pigments. False: they are not such. */
static bool put_layered(const shading *scene, surfaces *s, painted *p)
{
    const texture *of = texture_of_first(s);
    paint_group g;

    if (!of || !are_alike(s) || !layered_takes(scene, of, s->at[0].appearance->material))
        return false;
    paint_group_begin(&g, of);
    add_all(&g, scene, s);
    begin_none(s, p);
    return layered_put(scene, of, &g.points, s, &p->stacks[0], p->layered);
}

/* Are all surfaces of one appearance that is the same everywhere? */
static bool is_one(const surfaces *s)
{
    const appearance *first = s->count > 0 ? s->at[0].appearance : NULL;
    bool same = first && (first->stack ? first->stack->flat : !first->varies);

    for (uint32_t i = 1; same && i < s->count; i++)
        same = s->at[i].appearance == first;
    return same;
}

paint_kind paint_evaluate(const shading *scene, surfaces *s, painted *p)
{
    bool stacks = false, single = true;
    uint32_t count;

    if (is_one(s)) {
        begin_none(s, p);
        return s->at[0].appearance->stack && scene->most_terms > 1 ? PAINT_STACKS : PAINT_SINGLE;
    }
    if (paint_alike(scene, s, p) || merge_alike(scene, s, p) || find_normals_alike(scene, s, p))
        return PAINT_SINGLE;
    if (put_layered(scene, s, p))
        return PAINT_STACKS;
    count = evaluate(scene, s, p);
    for (uint32_t i = 0; i < s->count; i++) {
        const stack *of = s->at[i].appearance->stack;

        stacks |= of != NULL;
        single &= !of || of->flat;
    }
    sort(p, count, s->count);
    p->merged = 0;
    if (scene->most_terms <= 1)
        return PAINT_SINGLE;
    merge_terms(scene, s, p);
    if (!single || !join(scene, s, p, &stacks))
        return PAINT_TERMS;
    return stacks ? PAINT_STACKS : PAINT_SINGLE;
}

/* ---- surfaces ---- */

void paint_appearance(const shading *scene, const surface *s, const texture_term *t, appearance *out)
{
    const material *of = s->appearance->material;

    appearance_paint(out, scene->plan, scene->model, shading_finish(scene, t->finish), &t->pigment);
    appearance_set_material(out, of);
}

pov_vec3 paint_normal(const surfaces *s, uint32_t lane, const texture_term *t)
{
    return t && t->bent ? t->normal : lanes_at(s->geometry.raw, lane);
}

/* The term of a surface that is one. NULL: its texture is constant, or its terms are as one. */
static inline const texture_term *term_of(const painted *p, uint32_t i)
{
    return p->first[i + 1] > p->first[i] && !paint_is_merged(p, i) ? &p->terms[p->order[p->first[i]]] : NULL;
}

/* Bit i: the normal of surface i is bent, and there. */
static void set_bent(surfaces *s, uint64_t bent)
{
    geometry *g = &s->geometry;

    for (uint64_t others = ~bent & ~(uint64_t)0 >> (BATCH_MAX - s->count); others; others &= others - 1)
        lanes_put(&g->bent, first_of64(others), lanes_at(g->raw, first_of64(others)));
    g->shading = &g->bent;
}

void paint_surfaces(const shading *scene, surfaces *s, const painted *p)
{
    const bool keeps = scene->most_terms == 1;
    const finish *last = NULL;
    const appearance *of = NULL;
    uint64_t bent = 0;

    for (uint32_t i = 0; p->first[s->count] > 0 && i < s->count; i++) {
        const texture_term *t = term_of(p, i);

        if (!t)
            continue;
        if (t->bent) {
            lanes_put(&s->geometry.bent, i, t->normal);
            bent |= (uint64_t)1 << i;
        }
        if (s->at[i].appearance->one_pigment)
            continue;
        if (t->finish != last)
            of = shading_finish(scene, last = t->finish);
        repaint(scene, of, keeps, &t->pigment, &s->at[i], &s->varying[i]);
    }
    if (bent)
        set_bent(s, bent);
}

/* The place of a single hit; its normal is given as it is turned. */
static void begin_single(paint_group *g, const shading *scene, const texture *of, const hit *h, pov_vec3 normal, pov_vec3 view)
{
    paint_group_begin(g, of);
    paint_group_add_point(g, scene, h);
    paint_group_add_uv(g, scene, h);
    lanes_put(&g->points.normal, 0, normal);
    lanes_put(&g->points.view, 0, view);
    g->count = 1;
    paint_group_enter(g, scene, &h->object);
}

uint32_t paint_hit(const shading *scene, const pov_ray *ray, const hit *h, texture_term *out)
{
    const texture *of = paint_texture_of(scene, shading_constant(scene, h->object)->material, ray, h);
    pov_vec3 normal = h->entering ? h->normal : pov_scale(h->normal, -1.0);
    paint_group g;

    if (shading_info(scene, h->object)->smooth)
        world_shading_normal(scene->world, ray, h, &normal);
    begin_single(&g, scene, of, h, normal, pov_unit(ray->dir));
    return texture_eval(scene->model, of, &g.points, 1, out);
}
