#include "shade/scatter.h"

#include "query/passage.h"
#include "shade/air.h"
#include "shade/film.h"
#include "shade/interface.h"
#include "shade/photons.h"
#include "shade/scatter_rays.h"
#include "shade/spawn.h"
#include "shade/spectrum.h"
#include "shade/unscattered.h"

#include <limits.h>

/* ---- the rays that go on ---- */

/* As coefficient_mul(), side by side. */
static inline coefficient product(const coefficient *a, const coefficient *b)
{
    float x[4], y[4];
    coefficient out;

    memcpy(x, a, sizeof x);
    memcpy(y, b, sizeof y);
    for (int i = 0; i < 4; i++)
        x[i] *= y[i];
    memcpy(&out, x, sizeof out);
    return out;
}

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

static inline bool is_rare(rarities r) { return r.fading || r.dispersion || r.dims || r.alpha || r.hidden; }

/* ---- reflected rays ---- */

/* NULL: no memory. */
static inline batch *branch_of(scattering *to, rarities has, branches *list, const surface *s)
{
    batch *b = has.single ? list->items[0] : batch_branch(to->queue, to->context->env, list, s->from->lane);

    if (!b)
        to->context->failed = true;
    return b;
}

static inline void finish_reflected(scattering *to, rarities has, batch *b, path *next, const surface *s, uint32_t lane)
{
    const double side = to->on->geometry.reflected_side[lane];
    pov_ray *ray = &b->own[b->count++];

    next->clear = 0.0f;
    next->mirrored = true;
    if (has.hidden)
        next->travelled = 0.0;
    spawn_turn(next, TURN_MIRRORED);
    if (side < 0.0) {
        world_origin_transmit(ray, s->at, -side);
        next->above ^= 1u << s->on;
    } else {
        world_origin_reflect(ray, s->at, side);
    }
}

/* Back to the side that the ray came from. */
static inline void reflect(scattering *to, rarities has, const surface *s, uint32_t lane, const coefficient *by)
{
    const coefficient factor = product(&s->from->factor, by);
    batch *b;

    if (!passes_cutoff(&to->limits, s->from, &factor, to->limits.level))
        return;
    b = branch_of(to, has, &to->queue->mirrored, s);
    if (!b)
        return;
    finish_reflected(to, has, b, spawn(b, s, lanes_at(to->on->geometry.mirrored, lane), factor, true), s, lane);
    to->reflected++;
}

/* What a film makes of the light that a surface mirrors. */
static colour filmed(const scattering *to, const surface *s, uint32_t lane)
{
    const finish *f = s->appearance->finish;
    const model *m = to->context->scene->model;
    const geometry *g = &to->on->geometry;

    if (f->irid.amount == 0.0f)
        return colour_of(1.0f, 1.0f, 1.0f);
    return film_mirrored(m, f, film_thickness(m, f, lanes_at(&g->to.point, lane)), geometry_cosines(g, lane));
}

/* The same where the colour that is seen in the mirror, through its film, is raised to a power. */
SIMD_NOINLINE static void reflect_power(scattering *to, const surface *s, uint32_t lane, const coefficient *by, float exponent)
{
    const coefficient factor = product(&s->from->factor, by), seen = { filmed(to, s, lane), factor.weight };
    batch *b;
    power_sum *p;

    if (!passes_cutoff(&to->limits, s->from, &factor, to->limits.level))
        return;
    b = batch_grow(to->queue, to->context->env, &to->queue->powered, s->from->lane);
    if (!b) {
        to->context->failed = true;
        return;
    }
    p = b->power;
    p->lane[p->count] = s->from->lane;
    p->factor[p->count] = factor.by;
    p->exponent[p->count++] = exponent;
    finish_reflected(to, to->has, b, spawn(b, s, lanes_at(to->on->geometry.mirrored, lane), seen, true), s, lane);
    to->reflected++;
}

/* What goes on from surfaces: those that follow one another, or all have the same. */
typedef struct sources { const appearance *of; const coefficient *reflection, *filter; const bool *dark; uint32_t apart; } sources;

static inline sources sources_of(const surfaces *on, const appearance *a)
{
    const sources own = { a, on->reflection, on->filter, on->dark, 1 };
    const sources same = { a, &a->onward.reflection, &a->onward.filter, &a->onward.dark, 0 };

    return a->angular ? own : same;
}

/* The reflected ray of an ordinary surface. */
static inline void reflect_some(scattering *to, rarities has, const sources *from, const surface *s, uint32_t lane)
{
    const coefficient *by = &from->reflection[from->apart * lane];

    if (!from->of->reflective)
        return;
    if (!from->of->powered)
        reflect(to, has, s, lane, by);
    else
        reflect_power(to, s, lane, by, from->of->finish->reflection.exponent);
}

/* ---- transmitted rays ---- */

/* How far the transmitted ray came since the last surface that it sees. */
static double travelled_across(const scattering *to, const surface *s)
{
    const pov_vec3 step = pov_sub(s->at->point, s->ray->org);

    return s->appearance == &to->context->scene->unseen ? s->from->travelled + sqrt(pov_dot(step, step)) : 0.0;
}

/* A path on the surface's other side, at this cosine to the normal. NULL: the path is cut off. */
static inline path *spawn_across(scattering *to, rarities has, const surface *s, const coefficient *by, pov_vec3 direction, double cosine,
                                 bool deeper)
{
    coefficient factor = product(&s->from->factor, by);
    const int straight_level = s->appearance->clear ? INT_MAX : to->limits.straight_level;
    batch *b;
    path *next;

    if (!passes_cutoff(&to->limits, s->from, &factor, deeper ? to->limits.level : straight_level))
        return NULL;
    if (has.fading)
        factor.by = colour_mul(factor.by, s->faded);
    b = branch_of(to, has, &to->queue->transmitted, s);
    if (!b)
        return NULL;
    next = spawn(b, s, direction, factor, deeper);
    world_origin_transmit(&b->own[b->count++], s->at, cosine);
    next->above ^= 1u << s->on;
    if (s->from->gathering)
        next->gathering = s->appearance == &to->context->scene->unseen;
    if (has.hidden)
        next->travelled = travelled_across(to, s);
    spawn_turn(next, TURN_TRANSMITTED);
    if (has.alpha)
        next->clear *= colour_grey(has.fading ? colour_mul(by->by, s->faded) : by->by);
    if (has.dims)
        next->solids = air_solids_across(to->context->scene, s);
    to->transmitted++;
    return next;
}

/* Straight on, whatever is on both sides. NULL: the path is cut off. */
static inline path *transmit(scattering *to, rarities has, const surface *s, uint32_t lane, const coefficient *by)
{
    const int zero_steps = passage_zero_steps(to->context->scene->world, s->from->zero_steps, s->ray->org, s->at->point);
    path *out;

    if (zero_steps > PASSAGE_ZERO_STEPS_MAX) {
        to->limits.cut_depth++;
        return NULL;
    }
    out = spawn_across(to, has, s, by, s->ray->dir, to->on->geometry.view_side[lane], false);
    if (out)
        out->zero_steps = (uint16_t)zero_steps;
    return out;
}

static void face_rays(const geometry *g, uint32_t n, interfaces *p)
{
    p->normal = g->shading;
    p->cosine = g->cosine;
    if (!geometry_is_bent(g))
        return;
    p->facing = *g->shading;
    for (uint32_t i = 0; i < lanes_whole(n); i++) {
        p->sizes[i] = fabs(g->cosine[i]);
        if (g->cosine[i] < 0.0)
            lanes_put(&p->facing, i, pov_scale(lanes_at(g->shading, i), -1.0));
    }
    p->normal = &p->facing;
    p->cosine = p->sizes;
}

static inline void find_interfaces(const shade_context *c, surfaces *on, interfaces *p)
{
    const geometry *g = &on->geometry;
    const uint32_t n = on->count;
    const surface *s = on->at;
    bool any = false;

    for (uint32_t i = 0; i < lanes_whole(n); i++)
        p->to.before[i] = p->to.after[i] = 1.0;
    for (uint32_t i = 0; i < n; i++, s++) {
        const dielectric_crossing *at;

        if (!s->appearance->transmissive || s->appearance->clear)
            continue;
        at = s->appearance->fresnel ? interface_at(on, i) : interface_find(c, on, i);
        p->to.before[i] = at->before;
        p->to.after[i] = at->after;
        any = true;
    }
    if (!any)
        return;
    face_rays(g, n, p);
    refract_lanes(&p->to, &g->view, p->normal, p->cosine, n);
}

/* The transmitted ray gets the changed list of dielectrics. */
static inline void pass(scattering *to, path *out, const dielectric_crossing *crossing)
{
    shade_context *c = to->context;

    if (out && !dielectric_pass(&c->dielectrics, c->env, &out->inside, crossing))
        c->failed = true;
}

/* One that crosses no interface has a list of its own too: those of a batch lie in the order of its rays. */
static inline void keep_list(scattering *to, bool refraction, path *out)
{
    const dielectric_crossing none = { .index = SIZE_MAX };

    if (refraction && out && out->inside.count > 0)
        pass(to, out, &none);
}

static inline path *refract_at(scattering *to, rarities has, const surface *s, uint32_t lane, const coefficient *by, pov_vec3 dir)
{
    return spawn_across(to, has, s, by, dir, -pov_dot(dir, lanes_at(&to->on->geometry.to.normal, lane)), true);
}

static void reflect_inside(scattering *to, const surface *s, uint32_t lane, const coefficient *by)
{
    const uint64_t before = to->reflected;

    reflect(to, to->has, s, lane, by);
    to->context->counts.inner_reflections += to->reflected - before;
}

/* White light that enters a dielectric of a different ior for each colour is split into some of them. */
static inline bool is_dispersed(const scattering *to, rarities has, const surface *s, const dielectric_crossing *crossing)
{
    const shading *scene = to->context->scene;

    return has.dispersion && s->from->hue == PATH_WHITE && crossing->index == s->from->inside.count &&
           dielectric_interior(scene->model, crossing->object)->dispersion != 1.0;
}

SIMD_NOINLINE static void disperse(scattering *to, const interfaces *p, const surface *s, uint32_t lane, const coefficient *by)
{
    const dielectric_crossing *crossing = interface_at(to->on, lane);
    const interior *in = dielectric_interior(to->context->scene->model, crossing->object);
    const int n = in->dispersion_samples;

    for (int i = 0; i < n; i++) {
        const float hue = ((float)i + 0.5f) / (float)n;
        const coefficient some = { colour_mul(by->by, spectrum_of(i, n)), by->weight };
        pov_vec3 dir;
        path *out;

        if (!refract(lanes_at(&to->on->geometry.view, lane), lanes_at(p->normal, lane), p->cosine[lane],
                     crossing->before, dielectric_ior(in, hue), &dir)) {
            const coefficient shut = { colour_mul(some.by, filmed(to, s, lane)), some.weight };

            reflect_inside(to, s, lane, &shut);
            continue;
        }
        out = refract_at(to, to->has, s, lane, &some, dir);
        if (out) {
            out->hue = hue;
            out->clear = 0.0f;   /* in pictures with alpha glass that disperses is opaque, as in POV-Ray */
        }
        pass(to, out, crossing);
    }
}

/* Is light totally reflected? What is dispersed is asked colour by colour: the filter colours what is turned back there, and
 * the surface mirrors as well, as in POV-Ray. */
static inline bool is_shut(const scattering *to, rarities has, const interfaces *p, const surface *s, uint32_t lane)
{
    return p->to.before[lane] != p->to.after[lane] && !(p->to.squared_cosine[lane] > 0.0) &&
           !is_dispersed(to, has, s, interface_at(to->on, lane));
}

/* The transmitted ray. */
static inline void cross(scattering *to, rarities has, const interfaces *p, const surface *s, uint32_t lane, const coefficient *by)
{
    const dielectric_crossing *crossing = interface_at(to->on, lane);

    if (is_dispersed(to, has, s, crossing))
        disperse(to, p, s, lane, by);
    else if (crossing->before == crossing->after)
        pass(to, transmit(to, has, s, lane, by), crossing);
    else
        pass(to, refract_at(to, has, s, lane, by, lanes_at(&p->to.dir, lane)), crossing);
}

/* What is left of a ray that is totally reflected. The filter that it does not cross counts in its weight, as in POV-Ray. */
static coefficient shut_by(const scattering *to, const surface *s, uint32_t lane, const coefficient *filter)
{
    coefficient out = { filmed(to, s, lane), filter->weight };

    if (to->has.fading)
        out.by = colour_mul(out.by, s->faded);
    return out;
}

/* Both rays that can continue from an interface. A reflected one keeps its list of dielectrics. Where the filter is dark
 * no ray looks for a way through, so none is turned back: the surface mirrors as its finish says. */
static inline void split(scattering *to, rarities has, const interfaces *p, const sources *from, const surface *s, uint32_t lane)
{
    const coefficient *filter = &from->filter[from->apart * lane];
    const bool dark = from->dark[from->apart * lane];

    if (!dark && is_shut(to, has, p, s, lane)) {
        const coefficient by = shut_by(to, s, lane, filter);

        reflect_inside(to, s, lane, &by);
        return;
    }
    reflect_some(to, has, from, s, lane);
    to->limits.cut_weight += dark;
    if (!dark)
        cross(to, has, p, s, lane, filter);
}

/* A surface that refracts nothing. */
static inline void go_straight(scattering *to, rarities has, bool refraction, const sources *from, const surface *s, uint32_t lane)
{
    reflect_some(to, has, from, s, lane);
    if (!from->of->transmissive)
        return;
    if (from->dark[from->apart * lane])
        to->limits.cut_weight++;
    else
        keep_list(to, refraction, transmit(to, has, s, lane, &from->filter[from->apart * lane]));
}

/* Mirrors of one appearance, where nothing transmits rays: each surface has a path of its own, so one batch takes all. */
static void mirror_alike(scattering *to, const sources *from)
{
    const surfaces *on = to->on;
    batch *b = to->queue->mirrored.items[0];
    const uint32_t before = b->count;
    limits l = to->limits;

    for (uint32_t i = 0; i < on->count; i++) {
        const surface *s = &on->at[i];
        const coefficient factor = product(&s->from->factor, &from->reflection[from->apart * i]);

        if (passes_cutoff(&l, s->from, &factor, l.level))
            finish_reflected(to, to->has, b, spawn(b, s, lanes_at(on->geometry.mirrored, i), factor, true), s, i);
    }
    to->limits = l;
    to->reflected += b->count - before;
}

/* Where nothing transmits rays. */
static void mirror_lanes(scattering *to)
{
    const surfaces *on = to->on;
    const surface *s = on->at;
    const sources all = sources_of(on, s->appearance);

    if (on->alike && all.of->reflective && !all.of->powered) {
        mirror_alike(to, &all);
        return;
    }
    for (uint32_t i = 0; i < on->count; i++, s++) {
        const sources own = sources_of(on, s->appearance);

        reflect_some(to, to->has, &own, s, i);
    }
}

static inline bool refracts(const appearance *a) { return a->transmissive && !a->clear; }

/* Surfaces of one appearance, that refract. */
static void split_plain(scattering *to, const interfaces *p)
{
    const rarities none = { .single = true };
    const surfaces *on = to->on;
    const sources all = sources_of(on, on->at[0].appearance);
    const surface *s = on->at;

    for (uint32_t i = 0; i < on->count; i++, s++)
        split(to, none, p, &all, s, i);
}

static void scatter_lanes(scattering *to, surfaces *on, bool refraction)
{
    const surface *s = on->at;
    interfaces p;

    if (refraction)
        find_interfaces(to->context, on, &p);
    if (refraction && on->alike && refracts(s->appearance) && !is_rare(to->has)) {
        split_plain(to, &p);
        return;
    }
    for (uint32_t i = 0; i < on->count; i++, s++) {
        const sources own = sources_of(on, s->appearance);

        if (refraction && refracts(s->appearance))
            split(to, to->has, &p, &own, s, i);
        else
            go_straight(to, to->has, refraction, &own, s, i);
    }
}

/* Rays that are not sent at the last level, whether there would be all of them or not. */
static void count_ends(shade_context *c, const surfaces *on)
{
    for (uint32_t i = 0; i < on->count; i++)
        c->counts.cut_depth += (uint64_t)on->at[i].appearance->reflective + on->at[i].appearance->transmissive;
}

static scattering begin(shade_context *c, const surfaces *on, batch_queue *q)
{
    const model *m = c->scene->model;
    const photon_scene *photons = c->photons_fly ? c->scene->photons : NULL;
    const int level = photons_max_level(c);
    const float weight = photons ? photons->bailout : (float)m->adc_bailout;
    const limits l = { level, m->opaque_last_level ? level : INT_MAX, weight, 0, 0 };
    const plan *p = c->scene->plan;
    const rarities has = { p->fading, p->dispersion, c->scene->dims, c->alpha != NULL, p->hidden && !photons, false };
    const scattering to = { c, on, q, l, has, 0, 0 };

    return to;
}

static void count(const scattering *to)
{
    pov_counts *counts = &to->context->counts;

    counts->cut_depth += to->limits.cut_depth;
    counts->cut_weight += to->limits.cut_weight;
    counts->reflected += to->reflected;
    counts->transmitted += to->transmitted;
}

void scatter(shade_context *c, surfaces *on, batch_queue *q)
{
    const plan *p = c->scene->plan;
    scattering to;

    if (on->count == 0)
        return;
    if (on->ends) {
        count_ends(c, on);
        return;
    }
    to = begin(c, on, q);
    if (p->transmission || p->hidden)
        scatter_lanes(&to, on, p->refraction);
    else if (p->reflection)
        mirror_lanes(&to);
    if (p->subsurface && !c->photons_fly)
        unscattered_rays(&to, on, NULL);
    count(&to);
}

/* ---- for layers ---- */

scattering scatter_begin(shade_context *c, const surfaces *on, batch_queue *q) { return begin(c, on, q); }

void scatter_count(const scattering *to) { count(to); }

void scatter_reflect(scattering *to, const surface *s, uint32_t lane, const coefficient *by) { reflect(to, to->has, s, lane, by); }

void scatter_reflect_power(scattering *to, const surface *s, uint32_t lane, const coefficient *by, float exponent)
{
    reflect_power(to, s, lane, by, exponent);
}

void scatter_reflect_inside(scattering *to, const surface *s, uint32_t lane, const coefficient *by) { reflect_inside(to, s, lane, by); }

void scatter_transmit(scattering *to, const surface *s, uint32_t lane, const coefficient *by) { transmit(to, to->has, s, lane, by); }

void scatter_cross(scattering *to, const interfaces *p, const surface *s, uint32_t lane, const coefficient *by)
{
    cross(to, to->has, p, s, lane, by);
}

void scatter_find_interfaces(const shade_context *c, surfaces *on, interfaces *p) { find_interfaces(c, on, p); }

bool scatter_is_shut(const scattering *to, const interfaces *p, const surface *s, uint32_t lane) { return is_shut(to, to->has, p, s, lane); }

coefficient scatter_shut_by(const scattering *to, const surface *s, uint32_t lane, const coefficient *filter)
{
    return shut_by(to, s, lane, filter);
}
