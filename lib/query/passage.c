#include "query/passage.h"

#include "world/internal.h"

#include <math.h>

bool passage_step(const world *w, query_context *k, const pov_ray *ray, const coincident_set *from, hit *h,
                  coincident_set *on)
{
    const uint32_t which = from ? coincidence_crossed(from, ray->dir) : 0;

    on->count = 0;
    if (from && which < from->count) {
        *h = from->at[which];
        h->entering = pov_dot(h->normal, ray->dir) < 0.0;
        *on = *from;
        return true;
    }
    if (!(from ? query_nearest_from(w, k, from, ray, HUGE_VAL, h) : query_nearest(w, k, &ray, 1, HUGE_VAL, h) != 0))
        return false;
    if (h->coincident)
        world_coincident(w, k, ray, from, h, on);
    return true;
}

/* Parts of the world, and of what doubles can hold: a scene of infinite shapes alone has no size. */
static const double nowhere = 0x1p-200, least = 0x1p-960;

int passage_zero_steps(const world *w, int before, pov_vec3 from, pov_vec3 to)
{
    if (!passage_stays(from, to) && !(pov_largest(pov_sub(to, from)) <= pov_max(w->extent * nowhere, least)))
        return 0;
    return before + 1;
}

uint32_t passage_which(const coincident_set *on, uint32_t object)
{
    uint32_t which = 0;

    while (which + 1 < on->count && on->at[which].object != object)
        which++;
    return which;
}

bool passage_next(passage *p, hit *h)
{
    const pov_vec3 from = p->ray.org;
    coincident_set on;

    if (!passage_step(p->world, p->context, &p->ray, p->on.count > 0 ? &p->on : NULL, h, &on) ||
        query_context_failed(p->context))
        return false;
    if (on.count == 0)
        world_surface(p->world, &p->ray, h);
    else
        coincidence_pass(&on, passage_which(&on, h->object));
    p->on = on;
    p->ray.org = h->point;
    p->ray.org_lo = h->point_lo;
    p->ray.origin_surface = h->object;
    p->ray.origin_mark = h->crossing.mark;
    p->zero_steps = passage_zero_steps(p->world, p->zero_steps, from, h->point);
    return p->zero_steps <= PASSAGE_ZERO_STEPS_MAX;
}
