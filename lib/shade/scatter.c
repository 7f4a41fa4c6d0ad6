#include "shade/scatter.h"

#include "query/passage.h"
#include "shade/air.h"
#include "shade/refract.h"
#include "shade/spectrum.h"

#include <limits.h>

/* ---- the rays that go on ---- */

/* Limits that cut rays off, and the numbers of rays cut off. */
typedef struct limits {
    int level, straight_level;   /* rays that go straight on keep their level */
    float weight;
    uint64_t cut_depth, cut_weight;
} limits;

/* Does a path that continues from p with this factor pass the limits? The depth is tested first, so that a ray is
 * counted once. */
static inline bool passes_cutoff(limits *l, const path *p, const coefficient *factor, int level)
{
    if (p->level >= level) {
        l->cut_depth++;
        return false;
    }
    if (!(factor->weight >= l->weight)) {
        l->cut_weight++;
        return false;
    }
    return true;
}

/* Rays that continue from a batch's surfaces: source, targets, and limits. */
typedef struct scattering {
    shade_context *context;
    const surfaces *on;
    batch_queue *queue;
    limits limits;
    uint64_t reflected, transmitted;   /* numbers of them */
} scattering;

/* Begin a path from the surface, in a direction without a low part. The caller sets the ray's origin surface and counts
 * the path. */
static inline path *spawn(batch *b, const surface *s, pov_vec3 direction, coefficient factor, bool deeper)
{
    const path *p = s->from;
    path *next = &b->paths[b->count];
    pov_ray *ray = &b->own[b->count];

    ray->org = s->at->point;
    ray->org_lo = s->at->point_lo;
    ray->dir = direction;
    next->factor = factor;
    next->level = p->level + deeper;
    next->lane = p->lane;
    next->coincident = s->coincident;
    next->above = s->above;
    next->inside = p->inside;
    next->solids = p->solids;
    next->zero_steps = 0;
    next->mirrored = p->mirrored;
    next->hue = p->hue;
    return next;
}

/* ---- reflected rays ---- */

static batch *branch_of(scattering *to, branches *list, const surface *s, bool powered)
{
    batch_queue *q = to->queue;
    const env *e = to->context->env;
    batch *b = powered ? batch_grow(q, e, list, s->from->lane, true) : batch_branch(q, e, list, s->from->lane);

    to->context->failed = to->context->failed || !b;
    return b;
}

static void finish_reflected(scattering *to, batch *b, path *next, const surface *s, uint32_t lane)
{
    next->mirrored = true;
    world_origin_reflect(&b->own[b->count++], s->at, to->on->geometry.reflected_side[lane]);
    to->reflected++;
}

/* Back to the side that the ray came from. */
static inline void reflect(scattering *to, const surface *s, uint32_t lane, const coefficient *by)
{
    const coefficient factor = coefficient_mul(s->from->factor, *by);
    batch *b;

    if (!passes_cutoff(&to->limits, s->from, &factor, to->limits.level))
        return;
    b = branch_of(to, &to->queue->mirrored, s, false);
    if (b)
        finish_reflected(to, b, spawn(b, s, lanes_at(&to->on->geometry.reflected, lane), factor, true), s, lane);
}

/* The same where the colour that is seen in the mirror is raised to a power. */
static void reflect_power(scattering *to, const surface *s, uint32_t lane, const coefficient *by, float exponent)
{
    const coefficient factor = coefficient_mul(s->from->factor, *by), clear = { { 1.0f, 1.0f, 1.0f }, factor.weight };
    batch *b;
    power_sum *p;

    if (!passes_cutoff(&to->limits, s->from, &factor, to->limits.level))
        return;
    b = branch_of(to, &to->queue->powered, s, true);
    if (!b)
        return;
    p = b->power;
    p->lane[p->count] = s->from->lane;
    p->factor[p->count] = factor.by;
    p->exponent[p->count++] = exponent;
    finish_reflected(to, b, spawn(b, s, lanes_at(&to->on->geometry.reflected, lane), clear, true), s, lane);
}

/* The reflected ray of an ordinary surface. */
static inline void reflect_some(scattering *to, const surface *s, uint32_t lane)
{
    const appearance *a = s->appearance;

    if (!a->reflective)
        return;
    if (a->finish->reflection.exponent == 1.0f)
        reflect(to, s, lane, &a->reflection);
    else
        reflect_power(to, s, lane, &a->reflection, a->finish->reflection.exponent);
}

/* ---- transmitted rays ---- */

/* A path on the surface's other side, at this cosine to the normal. NULL: the path is cut off. */
static path *spawn_across(scattering *to, const surface *s, const coefficient *by, pov_vec3 direction, double cosine, bool deeper)
{
    const coefficient factor = coefficient_mul(s->from->factor, *by);
    const int straight_level = s->appearance->clear ? INT_MAX : to->limits.straight_level;
    batch *b;
    path *next;

    if (!passes_cutoff(&to->limits, s->from, &factor, deeper ? to->limits.level : straight_level))
        return NULL;
    b = branch_of(to, &to->queue->transmitted, s, false);
    if (!b)
        return NULL;
    next = spawn(b, s, direction, factor, deeper);
    world_origin_transmit(&b->own[b->count++], s->at, cosine);
    next->above ^= 1u << s->on;
    if (to->context->scene->dims)
        next->solids = air_solids_across(to->context->scene, s);
    to->transmitted++;
    return next;
}

/* Straight on, whatever is on both sides. NULL: the path is cut off. */
static path *transmit(scattering *to, const surface *s, uint32_t lane, const coefficient *by)
{
    const int zero_steps = passage_zero_steps(s->from->zero_steps, s->ray->org, s->at->point);
    path *out;

    if (zero_steps > PASSAGE_ZERO_STEPS_MAX) {
        to->limits.cut_depth++;
        return NULL;
    }
    out = spawn_across(to, s, by, s->ray->dir, to->on->geometry.view_side[lane], false);
    if (out)
        out->zero_steps = zero_steps;
    return out;
}

/* Interfaces that refracted rays cross, and their new directions. */
typedef struct interfaces { dielectric_crossing crossing[BATCH_MAX]; refraction_lanes to; } interfaces;

static void find_interfaces(const shade_context *c, const surfaces *on, interfaces *p)
{
    const shading *scene = c->scene;
    const geometry *g = &on->geometry;
    const uint32_t n = on->count;
    const surface *s = on->at;
    bool any = false;

    for (uint32_t i = 0; i < lanes_whole(n); i++)
        p->to.before[i] = p->to.after[i] = 1.0;
    for (uint32_t i = 0; i < n; i++, s++) {
        if (!s->appearance->transmissive || s->appearance->clear)
            continue;
        dielectric_cross(&c->dielectrics, s->from->inside, scene->model, world_solid(scene->world, s->at->object),
                         s->from->hue, &p->crossing[i]);
        p->to.before[i] = p->crossing[i].before;
        p->to.after[i] = p->crossing[i].after;
        any = true;
    }
    if (any)
        refract_lanes(&p->to, &g->view, g->shading, g->cosine, n);
}

/* The transmitted ray gets the changed list of dielectrics. */
static void pass(scattering *to, path *out, const dielectric_crossing *crossing)
{
    shade_context *c = to->context;

    if (out && !dielectric_pass(&c->dielectrics, c->env, &out->inside, crossing))
        c->failed = true;
}

static path *refract_at(scattering *to, const surface *s, uint32_t lane, const coefficient *by, pov_vec3 dir)
{
    return spawn_across(to, s, by, dir, -pov_dot(dir, lanes_at(&to->on->geometry.to.normal, lane)), true);
}

static void reflect_inside(scattering *to, const surface *s, uint32_t lane, const coefficient *by)
{
    const uint64_t before = to->reflected;

    reflect(to, s, lane, by);
    to->context->counts.inner_reflections += to->reflected - before;
}

/* White light that enters a dielectric of a different ior for each colour is split into some of them. */
static inline bool is_dispersed(const scattering *to, const surface *s, const dielectric_crossing *crossing)
{
    const shading *scene = to->context->scene;

    return scene->plan->dispersion && s->from->hue == PATH_WHITE && crossing->index == s->from->inside.count &&
           dielectric_interior(scene->model, crossing->object)->dispersion != 1.0;
}

static void disperse(scattering *to, const surface *s, uint32_t lane, const coefficient *by, const dielectric_crossing *crossing)
{
    const geometry *g = &to->on->geometry;
    const interior *in = dielectric_interior(to->context->scene->model, crossing->object);
    const int n = in->dispersion_samples;

    for (int i = 0; i < n; i++) {
        const float hue = ((float)i + 0.5f) / (float)n;
        const coefficient some = { colour_mul(by->by, spectrum_of(i, n)), by->weight };
        pov_vec3 dir;
        path *out;

        if (!refract(lanes_at(&g->view, lane), lanes_at(g->shading, lane), g->cosine[lane], crossing->before,
                     dielectric_ior(in, hue), &dir)) {
            reflect_inside(to, s, lane, &some);
            continue;
        }
        out = refract_at(to, s, lane, &some, dir);
        if (out)
            out->hue = hue;
        pass(to, out, crossing);
    }
}

/* Is light totally reflected? */
static inline bool is_shut(const interfaces *p, uint32_t lane)
{
    return p->crossing[lane].before != p->crossing[lane].after && !(p->to.squared_cosine[lane] > 0.0);
}

/* The transmitted ray. */
static void cross(scattering *to, const interfaces *p, const surface *s, uint32_t lane, const coefficient *by)
{
    const dielectric_crossing *crossing = &p->crossing[lane];

    if (is_dispersed(to, s, crossing))
        disperse(to, s, lane, by, crossing);
    else if (crossing->before == crossing->after)
        pass(to, transmit(to, s, lane, by), crossing);
    else
        pass(to, refract_at(to, s, lane, by, lanes_at(&p->to.dir, lane)), crossing);
}

/* Both rays that can continue from an interface. A reflected one keeps its list of dielectrics. */
static inline void split(scattering *to, const interfaces *p, const surface *s, uint32_t lane)
{
    const coefficient whole = { to->context->scene->plan->fading ? s->faded : colour_of(1.0f, 1.0f, 1.0f), 1.0f };

    if (is_shut(p, lane)) {
        reflect_inside(to, s, lane, &whole);
        return;
    }
    reflect_some(to, s, lane);
    cross(to, p, s, lane, &s->appearance->filter);
}

static void scatter_lanes(scattering *to, bool refraction)
{
    const uint32_t n = to->on->count;
    const surface *s = to->on->at;
    interfaces p;

    if (refraction)
        find_interfaces(to->context, to->on, &p);
    for (uint32_t i = 0; i < n; i++, s++) {
        const bool transmissive = s->appearance->transmissive;

        if (transmissive && refraction && !s->appearance->clear) {
            split(to, &p, s, i);
        } else {
            reflect_some(to, s, i);
            if (transmissive)
                transmit(to, s, i, &s->appearance->filter);
        }
    }
}

void scatter(shade_context *c, const surfaces *on, batch_queue *q)
{
    const model *m = c->scene->model;
    const limits l = { m->max_trace_level, m->opaque_last_level ? m->max_trace_level : INT_MAX, (float)m->adc_bailout, 0, 0 };
    scattering to = { c, on, q, l, 0, 0 };

    scatter_lanes(&to, c->scene->plan->refraction);
    c->counts.cut_depth += to.limits.cut_depth;
    c->counts.cut_weight += to.limits.cut_weight;
    c->counts.reflected += to.reflected;
    c->counts.transmitted += to.transmitted;
}
