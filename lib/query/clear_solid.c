#include "query/clear_solid.h"

#include "query/packet.h"

/* ---- exits ---- */

bool clear_solid_any_enters(const pov_ray *const *rays, uint32_t n)
{
    uint32_t flags = 0, i;

    for (i = 0; i < n; i++)
        flags |= rays[i]->origin_mark.flags;
    return flags & POV_MARK_INWARD;
}

/* Does a ray start on a closed solid and enter it? */
static inline bool enters(const world *w, const pov_ray *ray)
{
    const uint32_t both = POV_MARK_INWARD | POV_MARK_CLOSED;

    return (ray->origin_mark.flags & both) == both && ray->origin_surface < w->own_names &&
           w->objects_info[ray->origin_surface].plain;
}

static inline const shape_group *group_of(const world *w, uint32_t which)
{
    return &w->groups[w->objects_info[which].group];
}

static void begin_exit(query_context *k, uint32_t i, uint32_t owner, double tmax, hit *out, exit_hits *e)
{
    hits_begin(&e->hits[i], &k->hit_buffers[i], tmax, POV_WANT_NEAREST, &out[i].crossing);
    e->hits[i].owner = owner;
}

/* Intersect rays that all start on surfaces of one class. */
static void ask_class(const world *w, query_context *k, const pov_ray *const *rays, uint64_t lanes, double tmax, hit *out, exit_hits *e)
{
    const shape_group *g = group_of(w, rays[first_of64(lanes)]->origin_surface);
    xform_batch instanced;
    pairs some;

    some.count = instanced.count = 0;
    for (; lanes; lanes &= lanes - 1) {
        const uint32_t i = first_of64(lanes), which = rays[i]->origin_surface;
        const pov_ray *ray = rays[i];
        const shape_ref ref = world_shape(w, which);

        begin_exit(k, i, which, tmax, out, e);
        if (ref.xform)
            ray = own_ray(k, &instanced, ref.xform, ray, i, which);
        pairs_put(&some, ref.instance, ray, &e->hits[i]);
    }
    xform_batch_apply(&instanced);
    pairs_ask(k, g->shape, g->class_number, &some, false);
}

/* The same where the class finds exits without hits. Returns the rays that it leaves open. */
static uint64_t cross_class(const world *w, query_context *k, const pov_ray *const *rays, uint64_t lanes, hit *out, exit_hits *e)
{
    const shape_group *g = group_of(w, rays[first_of64(lanes)]->origin_surface);
    sure_pairs some;
    uint64_t rest, open;

    if (!g->shape->cross_sure || w->always_exact)
        return lanes;
    open = some.count = 0;
    for (rest = lanes; rest; rest &= rest - 1) {
        const uint32_t i = first_of64(rest), which = rays[i]->origin_surface;
        const shape_ref ref = world_shape(w, which);

        if (ref.xform)
            open |= bit_of(i);
        else
            sure_pairs_put(&some, w, ref.instance, which, rays[i], i, &out[i]);
    }
    if (some.count > 0)
        open |= sure_pairs_cross(&some, w, k, g->shape, g->class_number);
    e->sure |= lanes & ~open;
    return open;
}

/* Those of `left` whose origin surface is of the same class as the first one's. */
static uint64_t of_first_class(const world *w, const pov_ray *const *rays, uint64_t left)
{
    const shape_class *first = group_of(w, rays[first_of64(left)]->origin_surface)->shape;
    uint64_t same = 0;

    for (; left; left &= left - 1) {
        const uint32_t i = first_of64(left);

        same |= group_of(w, rays[i]->origin_surface)->shape == first ? bit_of(i) : 0;
    }
    return same;
}

/* Are both ends of a segment in an interval? Where it ends is off by less than the slack. */
static inline bool is_in(double from, double dir, double lo, double hi)
{
    const double slack = 0x1p-45 * (fabs(from) + fabs(dir)), end = from + dir;

    return from - slack >= lo && from + slack <= hi && end - slack >= lo && end + slack <= hi;
}

/* Is there nothing else on the way out of a solid? */
static inline bool is_isolated(const world_isolation *a, const pov_ray *ray, double t)
{
    const uint32_t number = a->number[ray->origin_surface];
    const pov_vec3 dir = pov_scale(ray->dir, t);
    const pov_box *b;

    if (number == 0)
        return false;
    b = &a->boxes[number - 1];
    return is_in(ray->org.x, dir.x, b->lo.x, b->hi.x) && is_in(ray->org.y, dir.y, b->lo.y, b->hi.y) &&
           is_in(ray->org.z, dir.z, b->lo.z, b->hi.z);
}

/* Does the ray end at its exit? */
static inline bool ends_at_exit(const world *w, const pov_ray *ray, double tmax, const hit *out)
{
    return out->crossing.t < tmax && is_isolated(&w->isolation, ray, out->crossing.t);
}

/* Rays that go on beyond need hits. */
static void end_sure(const world *w, query_context *k, const pov_ray *const *rays, double tmax, hit *out, exit_hits *e)
{
    for (uint64_t rest = e->sure; rest; rest &= rest - 1) {
        const uint32_t i = first_of64(rest);
        const pov_crossing at = out[i].crossing;

        if (w->isolation.number && ends_at_exit(w, rays[i], tmax, &out[i])) {
            e->found |= bit_of(i);
            continue;
        }
        begin_exit(k, i, at.owner, tmax, out, e);
        pov_cross(&e->hits[i], at.t, at.t_lo, at.mark);
    }
    k->own.complete |= w->plan.lighting ? e->found & e->sure : 0;
}

static void end_asked(const world *w, query_context *k, const pov_ray *const *rays, double tmax, hit *out, exit_hits *e)
{
    for (uint64_t rest = e->known & ~e->sure; w->isolation.number && rest; rest &= rest - 1) {
        const uint32_t i = first_of64(rest);

        if (e->hits[i].count == 0 || !ends_at_exit(w, rays[i], tmax, &out[i]))
            continue;
        k->escalated += e->hits[i].escalated;
        out[i].object = rays[i]->origin_surface;
        out[i].coincident = 0;
        e->found |= bit_of(i);
    }
}

void clear_solid_exits(const world *w, query_context *k, const pov_ray *const *rays, uint32_t n, double tmax, hit *out,
                       exit_hits *e)
{
    uint64_t left = 0;

    e->known = e->found = e->sure = 0;
    if (!w->plan.transmission || !clear_solid_any_enters(rays, n))
        return;
    for (uint32_t i = 0; i < n; i++)
        left |= enters(w, rays[i]) ? bit_of(i) : 0;
    e->known = left;
    while (left) {
        const uint64_t same = of_first_class(w, rays, left), open = cross_class(w, k, rays, same, out, e);

        if (open)
            ask_class(w, k, rays, open, tmax, out, e);
        left &= ~same;
    }
    end_sure(w, k, rays, tmax, out, e);
    end_asked(w, k, rays, tmax, out, e);
}

/* ---- light ---- */

/* Does a segment end outside an interval? With u = 2^-53, the end is off by u |from| for the start's lower part, u
 * |way| for its product, and u (|from| + |way|) for their sum; the slack's own sum rounds by as much once more. Bounds
 * are rounded outward. That makes 3 u (|from| + |way|) at most. */
static inline bool is_out(double from, double dir, double lo, double hi)
{
    const double slack = 0x1p-51 * (fabs(from) + fabs(dir)), end = from + dir;

    return end + slack < lo || end - slack > hi;
}

bool clear_solid_light_exits(const world *w, const pov_ray *ray, double tmax)
{
    const pov_vec3 dir = pov_scale(ray->dir, tmax), lo = w->transparent.lo, hi = w->transparent.hi;

    if (!enters(w, ray) || !w->objects_info[ray->origin_surface].filters)
        return false;
    return is_out(ray->org.x, dir.x, lo.x, hi.x) || is_out(ray->org.y, dir.y, lo.y, hi.y) ||
           is_out(ray->org.z, dir.z, lo.z, hi.z);
}

/* A part of the path that is more than what roundings amount to. */
static const double beyond = 0x1p-20;

/* The solid is convex: where a point beyond the end is inside, all of the path is. Boxes alone are asked, as rooms are boxes; others would
 * rather be crossed. */
bool clear_solid_light_stays(const world *w, const pov_ray *ray, double tmax)
{
    const pov_vec3 end = pov_add(ray->org, pov_scale(ray->dir, tmax + beyond * tmax)), end_lo = { 0.0, 0.0, 0.0 };
    shape_ref ref;

    if (!enters(w, ray) || !(group_of(w, ray->origin_surface)->shape->flags & POV_SHAPE_BOX))
        return false;
    ref = world_shape(w, ray->origin_surface);
    return !ref.xform && group_of(w, ray->origin_surface)->shape->inside(ref.instance, end, end_lo);
}
