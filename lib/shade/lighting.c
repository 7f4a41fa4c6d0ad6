#include "shade/lighting.h"

#include "base/lane_mask.h"
#include "shade/area_light.h"
#include "shade/photon_light.h"
#include "shade/photons.h"
#include "shade/shadow.h"
#include "shade/subsurface.h"

#include <string.h>

/* Rays from a surface start alike for all lights. */
static inline void begin_ray(lighting *l, uint32_t i)
{
    const hit *h = l->on->at[i].at;

    if (l->begun >> i & 1)
        return;
    world_origin_put(&l->own[i], h);
    world_origin_reflect(&l->own[i], h, 1.0);
    l->begun |= (uint64_t)1 << i;
}

/* Those of all lit surfaces. */
static void begin_rays(lighting *l)
{
    for (uint32_t k = 0; k < l->finishes.count; k++)
        begin_ray(l, l->finishes.lit[k]);
}

void lighting_put_rays(lighting *l)
{
    for (uint32_t k = 0; k < l->count; k++) {
        const uint32_t i = l->of[k];

        begin_ray(l, i);
        l->own[i].dir = lanes_at(l->dir, i);
        l->rays[k] = &l->own[i];
    }
    if (l->sided)
        shadow_put_sides(l);
}

/* The lit surfaces. */
static uint64_t lit_of(const finishes *f)
{
    uint64_t lit = 0;

    if (f->count == f->on->count)
        return lane_mask_all(f->count);
    for (uint32_t k = 0; k < f->count; k++)
        lit |= (uint64_t)1 << f->lit[k];
    return lit;
}

/* Lit surfaces that reflect any of the light. Counts those that do not. */
static uint64_t contributing(lighting *l, const finishes *f, const light_sample *s)
{
    const uint64_t lit = lit_of(f), front = lit & lane_mask_of(s->front, f->on->count), out = lit & lane_mask_of(s->contributes, f->on->count);

    l->context->counts.shadow_behind += lane_mask_count(lit & ~front);
    l->context->counts.shadow_idle += lane_mask_count(front) - lane_mask_count(out);
    return out;
}

/* The origin surfaces of rays to the light, given as bits. */
static uint64_t lanes_of(const lighting *l, uint64_t rays)
{
    uint64_t out = 0;

    if (l->count == l->on->count)
        return rays;
    for (; rays; rays &= rays - 1)
        out |= (uint64_t)1 << l->of[first_of64(rays)];
    return out;
}

/* Half of the lanes, whose bits fit numbers as wide as floats. */
enum { HALF = LANES_MAX / 2 };

static inline void add_half(float *restrict to, const float *restrict from, uint32_t lanes)
{
    for (uint32_t i = 0; i < HALF; i++) {
        const float x = from[i];

        to[i] += lanes >> i & 1 ? x : 0.0f;
    }
}

/* Add what some lanes of the first n reflect. */
SIMD_CLONES static void add_lanes(const light_sample *restrict s, uint64_t lanes, uint32_t n, colour_lanes *restrict to)
{
    for (uint32_t i = 0; i < n; i += HALF) {
        add_half(to->red + i, s->red + i, (uint32_t)(lanes >> i));
        add_half(to->green + i, s->green + i, (uint32_t)(lanes >> i));
        add_half(to->blue + i, s->blue + i, (uint32_t)(lanes >> i));
    }
}

/* Does nothing stand in the way of this light? */
static bool is_free(const lighting *l, const light *from)
{
    return !l->context->scene->plan->shadows || (from->flags & LIGHT_SHADOWLESS);
}

/* The rays to the light that are not occluded. filtered: some light may have been. */
static uint64_t trace(lighting *l, const scene_light *from, const light_lanes *in, colour *through, bool *filtered)
{
    const light_origin origin = light_own_origin(from->light);

    if (shadow_is_by_lane(l, from))
        return shadow_trace_lanes(l, shadow_end(from, in, &origin, false), through, filtered);
    *filtered = !shadow_is_white(l, from);
    lighting_put_rays(l);
    return from->grid ? area_trace(l, from, in, through)
                      : shadow_trace(l, from->light, shadow_end(from, in, &origin, false), through);
}

static void add_visible(lighting *l, const scene_light *from, const light_sample *s, const light_lanes *in)
{
    const uint32_t n = lanes_whole(l->on->count);
    colour through[BATCH_MAX];
    bool filtered = false;
    uint64_t rays;

    l->dir = &in->dir;
    if (is_free(l, from->light) && from->light->through_count > 0)
        shadow_keep_crossing(l, from->light, in->tmax);
    rays = is_free(l, from->light) ? lane_mask_all(l->count) : trace(l, from, in, through, &filtered);
    if (!filtered) {
        add_lanes(s, lanes_of(l, rays), n, &l->on->lit);
        return;
    }
    for (; rays; rays &= rays - 1) {
        const uint32_t k = first_of64(rays);

        colour_lane_add(&l->on->lit, l->of[k], colour_mul(brdf_at(s, l->of[k]), through[k]));
    }
}

/* The light of one source where it arrives at the lit surfaces. True: the rays' origins have been named for it alone;
 * sides are named for each light. */
static bool arrive(lighting *l, const scene_light *from, light_sample *s, light_lanes *in)
{
    const geometry *g = &l->on->geometry;
    const light_origin origin = light_own_origin(from->light);
    const light_points at = lighting_points(l);
    const bool sided = geometry_is_bent(g) || brdf_has_back(&l->finishes);
    bool grazing;

    from->class->incident(from->light, &origin, &at, in);
    grazing = brdf_cosines(s, g, &in->dir, brdf_shines(&l->finishes), lanes_whole(at.n));
    l->sided = sided;
    l->apart = grazing && !sided;
    if (sided)
        shadow_find_sides(l, &in->dir);
    if (!l->apart)
        return false;
    begin_rays(l);
    shadow_name_origins(l, s->cosine);
    return true;
}

static void reflect(lighting *l, const scene_light *from, const finishes *f, light_sample *s, const light_lanes *in)
{
    const uint32_t n = lanes_whole(l->on->count);

    brdf_reflect(f, l->context->scene->model, s, in, l->glossy && !(from->light->flags & LIGHT_SHADOWLESS), n);
    if (from->grid && (from->light->flags & LIGHT_AREA_ILLUMINATION))
        area_reflect(l, from, s, in, n);
}

/* Add the light of one source to the lit surfaces. */
static void add_light_source(lighting *l, const scene_light *from)
{
    shade_context *c = l->context;
    light_sample s;
    light_lanes in;
    bool named;

    if (l->photons)
        photons_aim(c, (size_t)(from - c->scene->lights));
    named = arrive(l, from, &s, &in);
    reflect(l, from, &l->finishes, &s, &in);
    l->which = contributing(l, &l->finishes, &s);
    l->count = lane_mask_list(l->which, l->of);
    if (l->count > 0)
        add_visible(l, from, &s, &in);
    if (named)
        shadow_name_origins(l, NULL);
    c->failed = c->failed || query_context_failed(c->context);
}

/* Collect the lit surfaces. */
static void begin(lighting *l, shade_context *c, surfaces *on)
{
    l->context = c;
    l->on = on;
    l->glossy = on->count == 0 || on->at[0].from->gathers == 0;   /* paths of a batch have the same history */
    l->begun = 0;
    l->named = false;
    memset(&on->lit, 0, sizeof on->lit);
    brdf_begin(&l->finishes, c->scene->model, on, 0);
}

/* Of the lit surfaces only those that this light shines on. */
static void choose_lit(lighting *l, const light *from, const uint8_t *all, uint32_t count)
{
    finishes *f = &l->finishes;

    f->count = 0;
    for (uint32_t k = 0; k < count; k++)
        if (model_is_lit_by(l->context->scene->model, l->on->at[all[k]].at->object, from))
            f->lit[f->count++] = all[k];
}

/* The lights of a scene with light groups. */
static void gather_by_group(lighting *l, const shading *scene)
{
    const uint32_t count = l->finishes.count;
    uint8_t all[BATCH_MAX];

    memcpy(all, l->finishes.lit, count);
    for (size_t k = 0; k < scene->light_count; k++) {
        if (l->context->failed || interrupt_is_due(&l->context->interrupt, count))
            return;
        choose_lit(l, scene->lights[k].light, all, count);
        if (l->finishes.count > 0)
            add_light_source(l, &scene->lights[k]);
    }
}

/* ---- one light of many ---- */

/* By lane: the light that was drawn among those before, by what they would give, the sum of that, and a random number. */
typedef struct lottery {
    uint32_t light[BATCH_MAX];
    double sum[BATCH_MAX], won[BATCH_MAX], number[BATCH_MAX];
} lottery;

static void begin_lottery(const lighting *l, const uint8_t *all, uint32_t count, lottery *out)
{
    const shade_context *c = l->context;

    for (uint32_t k = 0; k < count; k++) {
        const path *p = l->on->at[all[k]].from;

        out->sum[all[k]] = out->won[all[k]] = 0.0;
        out->light[all[k]] = UINT32_MAX;
        out->number[all[k]] = random_point_of_set(&c->samples[p->lane], p->draw, p->draws, p->branch * 0x85ebca6bu).x;
    }
}

/* What is left of the number after a choice is as random as it was before. */
static void offer(lottery *to, uint32_t lane, uint32_t number, double weight)
{
    double share;

    if (!(weight > 0.0))
        return;
    to->sum[lane] += weight;
    share = weight / to->sum[lane];
    if (to->number[lane] < share) {
        to->light[lane] = number;
        to->won[lane] = weight;
        to->number[lane] /= share;
    } else {
        to->number[lane] = (to->number[lane] - share) / (1.0 - share);
    }
}

/* What the light would give if nothing were in its way. */
static void offer_light(lighting *l, uint32_t number, lottery *to)
{
    const shading *scene = l->context->scene;
    const scene_light *from = &scene->lights[number];
    const light_origin origin = light_own_origin(from->light);
    const light_points at = lighting_points(l);
    const uint32_t n = lanes_whole(at.n);
    light_sample s;
    light_lanes in;

    from->class->incident(from->light, &origin, &at, &in);
    brdf_cosines(&s, &l->on->geometry, &in.dir, brdf_shines(&l->finishes), n);
    brdf_reflect(&l->finishes, scene->model, &s, &in, false, n);
    for (uint32_t k = 0; k < l->finishes.count; k++) {
        const uint32_t lane = l->finishes.lit[k];

        if (s.front[lane] && s.contributes[lane])
            offer(to, lane, number, (double)colour_weight(brdf_at(&s, lane)));
    }
}

/* Of the lit surfaces those that have drawn this light. */
static void choose_drawn(lighting *l, const lottery *from, uint32_t number, const uint8_t *all, uint32_t count)
{
    l->finishes.count = 0;
    for (uint32_t k = 0; k < count; k++)
        if (from->light[all[k]] == number)
            l->finishes.lit[l->finishes.count++] = all[k];
}

/* Each surface asks one light, and takes what that gives for all. */
static void gather_some(lighting *l, const shading *scene)
{
    const uint32_t count = l->finishes.count;
    colour before[BATCH_MAX];
    uint8_t all[BATCH_MAX];
    lottery drawn;

    memcpy(all, l->finishes.lit, count);
    begin_lottery(l, all, count, &drawn);
    for (uint32_t k = 0; k < scene->light_count; k++) {
        choose_lit(l, scene->lights[k].light, all, count);
        offer_light(l, k, &drawn);
    }
    for (uint32_t k = 0; k < count; k++) {
        before[k] = colour_lane(&l->on->lit, all[k]);
        colour_lane_put(&l->on->lit, all[k], colour_of(0.0f, 0.0f, 0.0f));
    }
    for (uint32_t k = 0; k < scene->light_count; k++) {
        if (l->context->failed || interrupt_is_due(&l->context->interrupt, count))
            return;
        choose_drawn(l, &drawn, k, all, count);
        if (l->finishes.count > 0)
            add_light_source(l, &scene->lights[k]);
    }
    for (uint32_t k = 0; k < count; k++) {
        const double by = drawn.won[all[k]] > 0.0 ? drawn.sum[all[k]] / drawn.won[all[k]] : 0.0;

        colour_lane_put(&l->on->lit, all[k], colour_add(before[k], colour_scale(colour_lane(&l->on->lit, all[k]), (float)by)));
    }
}

void light_gather(lighting *l, shade_context *c, surfaces *on)
{
    const shading *scene = c->scene;

    begin(l, c, on);
    if (l->photons)
        photon_light_add(l->photons, c, &l->finishes, on);
    if (scene->plan->subsurface)
        subsurface_add(c, &l->finishes, on);
    if (scene->light_count > 1 && l->finishes.count > 0 && on->at[0].from->gathers > 0) {
        gather_some(l, scene);
        return;
    }
    if (scene->model->light_groups.count > 0) {
        gather_by_group(l, scene);
        return;
    }
    for (size_t k = 0; l->finishes.count > 0 && k < scene->light_count; k++) {
        if (c->failed || interrupt_is_due(&c->interrupt, l->finishes.count))
            return;
        add_light_source(l, &scene->lights[k]);
    }
}

/* ---- stacks ---- */

/* What is known of the rays to one light, by lane: those that were asked, those not occluded, and what they leave of it, unless that is all. */
typedef struct known_rays { uint64_t asked, open; bool white; colour_lanes through; } known_rays;

/* Ask the rays from these surfaces, but for those that were asked. */
static void ask(lighting *l, const scene_light *from, const light_lanes *in, uint64_t lanes, known_rays *known)
{
    const colour white = colour_of(1.0f, 1.0f, 1.0f);
    colour through[BATCH_MAX];
    bool filtered = false;
    uint64_t rays;

    l->which = lanes & ~known->asked;
    l->count = lane_mask_list(l->which, l->of);
    known->asked |= lanes;
    if (l->count == 0)
        return;
    rays = trace(l, from, in, through, &filtered);
    known->open |= lanes_of(l, rays);
    for (; rays && !known->white; rays &= rays - 1)
        colour_lane_put(&known->through, l->of[first_of64(rays)], filtered ? through[first_of64(rays)] : white);
}

/* Add what a layer reflects of light that is left. */
static void add_left(const lighting *l, const light_sample *s, uint64_t lanes, const known_rays *known, colour_lanes *to)
{
    if (known->white) {
        add_lanes(s, lanes, lanes_whole(l->on->count), to);
        return;
    }
    for (; lanes; lanes &= lanes - 1) {
        const uint32_t i = first_of64(lanes);

        colour_lane_add(to, i, colour_mul(brdf_at(s, i), colour_lane(&known->through, i)));
    }
}

static void add_to_layers(lighting *l, const scene_light *from, lit_stacks *to)
{
    shade_context *c = l->context;
    known_rays known;
    light_sample s;
    light_lanes in;
    const bool named = arrive(l, from, &s, &in), free = is_free(l, from->light);

    known.asked = 0;
    known.open = free ? ~(uint64_t)0 : 0;
    known.white = free || shadow_is_white(l, from);
    l->dir = &in.dir;
    for (uint32_t k = 0; k < to->levels; k++) {
        const finishes *f = &to->finishes[k];
        uint64_t lanes;

        reflect(l, from, f, &s, &in);
        lanes = contributing(l, f, &s);
        if (!free)
            ask(l, from, &in, lanes, &known);
        add_left(l, &s, lanes & known.open, &known, &to->lit[k]);
    }
    if (named)
        shadow_name_origins(l, NULL);
    c->failed = c->failed || query_context_failed(c->context);
}

/* The surfaces of which some layer is lit. */
static void begin_stacks(lighting *l, shade_context *c, surfaces *on, lit_stacks *out)
{
    const appearance *last = NULL;
    uint64_t lit = 0;

    l->context = c;
    l->on = on;
    l->glossy = true;
    l->begun = 0;
    l->named = false;
    l->finishes.kinds = l->finishes.count = 0;
    l->finishes.has_phong = false;
    out->levels = 1;
    for (uint32_t i = 0; i < (on->alike ? 1 : on->count); i++) {
        const appearance *a = on->at[i].appearance;

        if (a != last && a->stack && a->stack->count > out->levels)
            out->levels = a->stack->count;
        last = a;
    }
    for (uint32_t k = 0; k < out->levels; k++) {
        finishes *f = &out->finishes[k];

        brdf_begin(f, c->scene->model, on, k);
        l->finishes.kinds |= f->kinds;
        l->finishes.has_phong |= f->has_phong;
        lit |= lit_of(f);
        memset(&out->lit[k], 0, sizeof out->lit[k]);
    }
    l->finishes.count = lane_mask_list(lit, l->finishes.lit);
}

void light_gather_stacks(lighting *l, shade_context *c, surfaces *on, lit_stacks *out)
{
    const shading *scene = c->scene;

    begin_stacks(l, c, on, out);
    for (size_t k = 0; l->finishes.count > 0 && k < scene->light_count; k++) {
        if (c->failed || interrupt_is_due(&c->interrupt, l->finishes.count))
            return;
        add_to_layers(l, &scene->lights[k], out);
    }
}
