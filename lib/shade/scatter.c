#include "shade/scatter.h"

#include "query/passage.h"
#include "shade/refract.h"

static const coefficient whole = { { 1.0f, 1.0f, 1.0f }, 1.0f };

/* ---- the rays that go on ---- */

/* Limits that cut rays off, and the numbers of rays cut off. */
typedef struct limits { int level; float weight; uint64_t cut_depth, cut_weight; } limits;

/* Does a path that continues from p with this factor pass the limits? The depth is tested first, so that a ray is
 * counted once. */
static inline bool passes_cutoff(limits *l, const path *p, const coefficient *factor, bool deeper)
{
    if (deeper && p->level >= l->level) {
        l->cut_depth++;
        return false;
    }
    if (!(factor->weight >= l->weight)) {
        l->cut_weight++;
        return false;
    }
    return true;
}

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
    next->zero_steps = 0;
    return next;
}

/* Begin a path on the surface's other side, at this cosine to the normal. NULL: the path is cut off. */
static path *spawn_across(batch *b, limits *l, const surface *s, pov_vec3 direction, double cosine, bool deeper)
{
    const coefficient factor = coefficient_mul(s->from->factor, s->appearance->filter);
    path *next;

    if (!passes_cutoff(l, s->from, &factor, deeper))
        return NULL;
    next = spawn(b, s, direction, factor, deeper);
    world_origin_transmit(&b->own[b->count], s->at, cosine);
    next->above ^= 1u << s->on;
    return next;
}

/* Rays that continue from a batch's surfaces: source, targets, and limits. */
typedef struct scattering {
    shade_context *context;
    const surfaces *on;
    batch *reflected, *transmitted;
    limits limits;
} scattering;

/* Back to the side that the ray came from. */
static inline void reflect(scattering *to, const surface *s, uint32_t lane, const coefficient *by)
{
    const geometry *g = &to->on->geometry;
    const coefficient factor = coefficient_mul(s->from->factor, *by);
    batch *b = to->reflected;

    if (!passes_cutoff(&to->limits, s->from, &factor, true))
        return;
    spawn(b, s, lanes_at(&g->reflected, lane), factor, true);
    world_origin_reflect(&b->own[b->count++], s->at, g->reflected_side[lane]);
}

/* Straight on, whatever is on both sides. NULL: the path is cut off. */
static path *transmit(scattering *to, const surface *s, uint32_t lane)
{
    const geometry *g = &to->on->geometry;
    path *out = spawn_across(to->transmitted, &to->limits, s, s->ray->dir, g->view_side[lane], false);

    if (!out)
        return NULL;
    out->zero_steps = passage_zero_steps(s->from->zero_steps, s->ray->org, s->at->point);
    if (out->zero_steps > PASSAGE_ZERO_STEPS_MAX) {
        to->limits.cut_depth++;
        return NULL;
    }
    return out;
}

/* The reflected ray of an ordinary surface. */
static inline void reflect_some(scattering *to, const surface *s, uint32_t lane)
{
    if (s->appearance->reflective)
        reflect(to, s, lane, &s->appearance->reflection);
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
        if (!s->appearance->transmissive)
            continue;
        dielectric_cross(&c->dielectrics, s->from->inside, scene->model, world_solid(scene->world, s->at->object),
                         &p->crossing[i]);
        p->to.before[i] = p->crossing[i].before;
        p->to.after[i] = p->crossing[i].after;
        any = true;
    }
    if (any)
        refract_lanes(&p->to, &g->view, g->shading, g->cosine, n);
}

/* Both rays that can continue from an interface. The transmitted ray gets the changed list of dielectrics; a reflected
 * one keeps its list. */
static void split(scattering *to, const interfaces *p, const surface *s, uint32_t lane)
{
    shade_context *c = to->context;
    const dielectric_crossing *crossing = &p->crossing[lane];
    const uint32_t before = to->reflected->count;
    path *out;

    if (crossing->before == crossing->after) {
        out = transmit(to, s, lane);
    } else if (p->to.squared_cosine[lane] > 0.0) {
        const pov_vec3 dir = lanes_at(&p->to.dir, lane);

        out = spawn_across(to->transmitted, &to->limits, s, dir, -pov_dot(dir, lanes_at(&to->on->geometry.to.normal, lane)),
                           true);
    } else {
        reflect(to, s, lane, &whole);
        c->counts.inner_reflections += to->reflected->count - before;
        return;
    }
    reflect_some(to, s, lane);
    if (out && !dielectric_pass(&c->dielectrics, c->env, &out->inside, crossing))
        c->failed = true;
    to->transmitted->count += out != NULL;
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

        if (transmissive && refraction) {
            split(to, &p, s, i);
        } else {
            reflect_some(to, s, i);
            if (transmissive)
                to->transmitted->count += transmit(to, s, i) != NULL;
        }
    }
}

void scatter(shade_context *c, const surfaces *on, batch *reflected, batch *transmitted)
{
    const model *m = c->scene->model;
    scattering to = { c, on, reflected, transmitted, { m->max_trace_level, (float)m->adc_bailout, 0, 0 } };

    reflected->count = transmitted->count = 0;
    scatter_lanes(&to, c->scene->plan->refraction);
    c->counts.cut_depth += to.limits.cut_depth;
    c->counts.cut_weight += to.limits.cut_weight;
    c->counts.reflected += reflected->count;
    c->counts.transmitted += transmitted->count;
}
