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

/* Intersect those of `left` whose origin surface is of the same class as the first one's; returns the others. */
static uint64_t ask_class(const world *w, query_context *k, const pov_ray *const *rays, uint64_t left, exit_hits *e)
{
    const shape_group *first = group_of(w, rays[first_of64(left)]->origin_surface);
    uint64_t others = 0;
    xform_batch instanced;
    pairs some;

    some.count = instanced.count = 0;
    for (; left; left &= left - 1) {
        const uint32_t i = first_of64(left), which = rays[i]->origin_surface;
        const pov_ray *ray = rays[i];
        shape_ref ref;

        if (group_of(w, which)->shape != first->shape) {
            others |= bit_of(i);
            continue;
        }
        ref = world_shape(w, which);
        e->hits[i].owner = which;
        if (ref.xform)
            ray = own_ray(k, &instanced, ref.xform, ray, i, which);
        pairs_put(&some, ref.instance, ray, &e->hits[i]);
    }
    xform_batch_apply(&instanced);
    pairs_ask(k, first->shape, first->class_number, &some, false);
    return others;
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

static void end_isolated(const world *w, query_context *k, const pov_ray *const *rays, hit *out, exit_hits *e)
{
    uint64_t rest;

    for (rest = e->known; w->isolation.number && rest; rest &= rest - 1) {
        const uint32_t i = first_of64(rest);

        if (e->hits[i].count == 0 || !is_isolated(&w->isolation, rays[i], out[i].crossing.t))
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
    uint64_t left;
    uint32_t i;

    e->known = e->found = 0;
    if (!w->plan.transmission || !clear_solid_any_enters(rays, n))
        return;
    for (i = 0; i < n; i++)
        if (enters(w, rays[i])) {
            e->known |= bit_of(i);
            hits_begin(&e->hits[i], &k->hit_buffers[i], tmax, POV_WANT_NEAREST, &out[i].crossing);
        }
    for (left = e->known; left;)
        left = ask_class(w, k, rays, left, e);
    end_isolated(w, k, rays, out, e);
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
