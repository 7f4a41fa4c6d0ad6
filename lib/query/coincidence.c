#include "base/vec.h"
#include "query/packet.h"
#include "query/segment_end.h"

#include <string.h>

/* Two crossings are coincident if their distances differ by no more than the error of double-double arithmetic: some
 * 2^-98 of the lengths involved, over the cosine between ray and surface; with a margin. Gaps that doubles can
 * represent are wider: half a unit in the last place of a coordinate is 2^-54 of it. */
static const double same_point = 0x1p-92;
/* Relative interval around a distance in double that holds all distances which may tie: wider than POV_COINCIDENT. */
static const double around = 0x1p-45;

/* ---- a query that leaves several surfaces by name ----
 *
 * A packet of one lane. Filters know none of the surfaces that the ray starts on, so they only name candidates. Crossings whose
 * distance is asked for are found in double-double. */

void packet_name(packet *p, uint32_t owner)
{
    uint32_t i;

    p->named.origin_surface = POV_NO_OWNER;
    for (i = 0; i < p->from->count; i++)
        if (p->from->at[i].object == owner) {
            p->named.origin_surface = owner;
            p->named.origin_mark = p->from->at[i].crossing.mark;
        }
}

/* from: NULL: the ray's own origin surface holds for all. */
static void begin(packet *p, const world *w, query_context *k, const coincident_set *from, const pov_ray *ray,
                  double tmax)
{
    packet_begin(p, w, k, &ray, 1, tmax, tmax);
    p->traversal.soa.excluded[0] = POV_NO_OWNER;
    p->from = k->csg.from = from;
    p->candidates_only = p->exact == 0;
    p->exact = 1;
    if (!from)
        return;
    p->named = *ray;
    p->rays[0] = &p->named;
}

bool query_nearest_beyond(const world *w, query_context *k, const coincident_set *from, const pov_ray *ray, double tmin,
                          double tmax, hit *out)
{
    pov_hits *hits;
    packet p;

    begin(&p, w, k, from, ray, tmax);
    p.out = out;
    p.asked = 1;
    hits = &p.hits[0];
    packet_begin_hits(&p, 0, hits, POV_WANT_NEAREST, &out->crossing);
    hits->tmin = tmin;
    hits->always_exact = true;
    packet_nearest(&p, w->kernels->nearest_single);
    k->escalated += hits->escalated;
    out->object = hits->count ? out->crossing.owner : POV_NO_OWNER;
    out->coincident = 0;
    if (hits->tied)
        coincidence_resolve(w, k, ray, from, out);
    return hits->count > 0;
}

bool query_nearest_from(const world *w, query_context *k, const coincident_set *from, const pov_ray *ray, double tmax,
                        hit *out)
{
    return query_nearest_beyond(w, k, from, ray, 0.0, tmax, out);
}

/* All crossings near t, from near to far, in the context's memory. Returns their number. */
static uint32_t find_near(const world *w, query_context *k, const coincident_set *from, const pov_ray *ray, double t,
                          pov_crossing **crossings)
{
    pov_hits *hits;
    packet p;

    begin(&p, w, k, from, ray, t + around * fabs(t));
    p.asked = 1;
    hits = &p.hits[0];
    packet_begin_hits(&p, 0, hits, POV_WANT_ALL, k->hit_buffers[0].crossings);
    hits->tmin = t - around * fabs(t);
    hits->always_exact = true;
    hits->capacity = k->hit_buffers[0].capacity;
    hits->grow = crossings_grow;
    packet_nearest(&p, w->kernels->nearest_single);
    k->escalated += hits->escalated;
    *crossings = hits->at;
    return k->failed ? 0 : hits->count;
}

/* ---- which surfaces share a place ---- */

static bool is_solid(const world *w, uint32_t which)
{
    const leaf_node *o = model_leaf(w->model, which);

    return shape_is_solid(o->shape, o->instance);
}

static bool is_crossed(const coincident_set *s, uint32_t which, double rise)
{
    return s->above >> which & 1 ? rise < 0.0 : rise > 0.0;
}

uint32_t coincidence_crossed(const coincident_set *s, pov_vec3 dir)
{
    uint32_t i, left = s->count;

    for (i = 0; i < s->count; i++) {
        const double rise = pov_dot(s->at[i].normal, dir);

        if (!is_crossed(s, i, rise))
            continue;
        if (!(rise > 0.0 && (s->solid >> i & 1)))
            return i;
        left = left == s->count ? i : left;
    }
    return left;
}

/* Size of the numbers involved in a crossing. */
static double size_of(const world *w, const pov_ray *ray, double t)
{
    return fabs(t) * pov_largest(ray->dir) + pov_largest(ray->org) + w->extent;
}

/* Complete the hit of a crossing. */
static void complete_hit(const world *w, const pov_ray *ray, const pov_crossing *at, hit *h)
{
    h->crossing = *at;
    h->object = at->owner;
    world_surface(w, ray, h);
}

static bool shares_point(const pov_ray *ray, const hit *first, const hit *h, double size)
{
    const double gap = (h->crossing.t - first->crossing.t) + (h->crossing.t_lo - first->crossing.t_lo);
    const double a = fabs(pov_dot(first->normal, ray->dir)), b = fabs(pov_dot(h->normal, ray->dir));

    return !(gap * a * b > same_point * size * (a + b));
}

/* Insert a hit in the order of objects. If an object is crossed twice here, at an edge, its entry counts. */
static void insert(coincident_set *s, const model *m, const hit *h)
{
    uint32_t at = s->count;

    for (uint32_t i = 0; i < s->count; i++)
        if (s->at[i].object == h->object) {
            if (h->entering && !s->at[i].entering)
                s->at[i] = *h;
            return;
        }
    if (s->count == COINCIDENT_MAX)
        return;
    for (; at > 0 && model_is_before(m, h->object, s->at[at - 1].object); at--)
        s->at[at] = s->at[at - 1];
    s->at[at] = *h;
    s->count++;
}

/* The order of ties must only be the same for the tree and the list. */
static bool is_nearer(const pov_crossing *a, const pov_crossing *b)
{
    if (a->t != b->t)
        return a->t < b->t;
    if (a->t_lo != b->t_lo)
        return a->t_lo < b->t_lo;
    return a->owner < b->owner;
}

static void find_set(const world *w, query_context *k, const pov_ray *ray, const coincident_set *from, const hit *h, coincident_set *out)
{
    const double size = size_of(w, ray, h->crossing.t);
    pov_crossing *at;
    const uint32_t count = find_near(w, k, from, ray, h->crossing.t, &at);
    hit first, next;
    uint32_t i;

    out->count = out->above = out->solid = 0;
    if (count == 0)
        return;
    crossings_sort(at, count, is_nearer);
    complete_hit(w, ray, &at[0], &first);
    insert(out, w->model, &first);
    for (i = 1; i < count; i++) {
        complete_hit(w, ray, &at[i], &next);
        if (!shares_point(ray, &first, &next, size))
            continue;
        next.point = first.point;
        next.point_lo = first.point_lo;
        insert(out, w->model, &next);
    }
    for (i = 0; i < out->count; i++) {
        out->at[i].coincident = (uint16_t)(out->count > 1 ? out->count : 0);
        out->above |= (uint32_t)out->at[i].entering << i;
        out->solid |= (uint32_t)is_solid(w, out->at[i].object) << i;
    }
}

/* The set of a hit that has been resolved, or NULL. */
static const coincident_set *recall(const query_context *k, const pov_ray *ray, const hit *h)
{
    for (size_t i = 0; i < k->resolved.count; i++) {
        const coincident_set *on = &k->resolved.items[i].on;

        if (k->resolved.items[i].ray != ray)
            continue;
        for (uint32_t j = 0; j < on->count; j++)
            if (on->at[j].object == h->object && on->at[j].crossing.t == h->crossing.t && on->at[j].crossing.t_lo == h->crossing.t_lo)
                return on;
    }
    return NULL;
}

void world_coincident(const world *w, query_context *k, const pov_ray *ray, const coincident_set *from, const hit *h,
                      coincident_set *out)
{
    const coincident_set *known = from ? NULL : recall(k, ray, h);

    if (known)
        *out = *known;
    else
        find_set(w, k, ray, from, h, out);
}

void coincidence_resolve(const world *w, query_context *k, const pov_ray *ray, const coincident_set *from, hit *out)
{
    resolved_set s;
    uint32_t which;

    s.ray = ray;
    find_set(w, k, ray, from, out, &s.on);
    if (s.on.count == 0)
        return;
    which = coincidence_crossed(&s.on, ray->dir);
    *out = s.on.at[which < s.on.count ? which : 0];
    if (!from)
        k->failed = !VEC_PUSH(k->env, &k->resolved, s) || k->failed;
}

/* ---- light ---- */

/* Transparent surfaces of the set that are crossed at the start. False: an opaque one is crossed. */
static bool leave(const world *w, const coincident_set *from, pov_vec3 dir, uint32_t *crossed)
{
    const model *m = w->model;

    *crossed = 0;
    for (uint32_t i = 0; i < from->count; i++) {
        const leaf_node *o = model_leaf(m, from->at[i].object);

        if ((o->flags & LEAF_NO_SHADOW) || !is_crossed(from, i, pov_dot(from->at[i].normal, dir)))
            continue;
        if (!material_is_transparent(&m->materials.items[o->material]))
            return false;
        *crossed |= 1u << i;
    }
    return true;
}

/* Does light end, as far as doubles tell? False with near_end: they do not. */
static bool is_blocked_from(const world *w, query_context *k, const coincident_set *from, const pov_ray *ray, double tmax,
                            bool any_blocks, bool exact, occlusion *out)
{
    packet p;

    begin(&p, w, k, from, ray, tmax);
    p.any_blocks = any_blocks;
    if (exact)
        return packet_end_light(&p, segment_end_occlusion(&p), out) != 0;
    p.slack = packet_near_end(tmax);
    return packet_end_light(&p, packet_occlusion(&p, w->kernels->any_single), out) != 0;
}

bool query_occlusion_from(const world *w, query_context *k, const coincident_set *from, const pov_ray *ray, double tmax,
                          occlusion *out, uint32_t *crossed)
{
    out->crossed = out->near_end = 0;
    if (!leave(w, from, ray->dir, crossed))
        return false;
    if (w->plan.coloured_shadows)   /* the crossings' distances count */
        return !is_blocked_from(w, k, from, ray, tmax, false, true, out);
    if (is_blocked_from(w, k, from, ray, tmax, true, false, out))
        return false;
    return !out->near_end || !is_blocked_from(w, k, from, ray, tmax, true, true, out);
}

bool query_blocked_from(const world *w, query_context *k, const coincident_set *from, const pov_ray *ray, double tmax)
{
    occlusion found;

    found.crossed = found.near_end = 0;
    return is_blocked_from(w, k, from, ray, tmax, true, true, &found);
}
