#include "query/passage.h"

bool passage_step(const world *w, walker *k, const pov_ray *ray, const spot *from, hit *h, spot *on)
{
    const uint32_t which = from ? spot_crossed(from, ray->dir) : 0;

    on->count = 0;
    if (from && which < from->count) {
        *h = from->at[which];
        h->entering = pov_dot(h->normal, ray->dir) < 0.0;
        *on = *from;
        return true;
    }
    if (!(from ? query_nearest_from(w, k, from, ray, HUGE_VAL, h) : query_nearest(w, k, &ray, 1, HUGE_VAL, h) != 0))
        return false;
    if (h->company)
        world_spot(w, k, ray, from, h, on);
    return true;
}

uint32_t passage_which(const spot *on, uint32_t object)
{
    uint32_t which = 0;

    while (which + 1 < on->count && on->at[which].object != object)
        which++;
    return which;
}

bool passage_next(passage *p, hit *h)
{
    const pov_vec3 from = p->ray.org;
    spot on;

    if (!passage_step(p->world, p->walker, &p->ray, p->on.count > 0 ? &p->on : NULL, h, &on) ||
        walker_failed(p->walker))
        return false;
    if (on.count == 0)
        world_surface(p->world, &p->ray, h);
    else
        spot_pass(&on, passage_which(&on, h->object));
    p->on = on;
    p->ray.org = h->point;
    p->ray.org_lo = h->point_lo;
    p->ray.left = h->object;
    p->ray.left_mark = h->crossing.mark;
    p->zero_steps = passage_zero_steps(p->zero_steps, from, h->point);
    return p->zero_steps <= PASSAGE_ZERO_STEPS_MAX;
}
