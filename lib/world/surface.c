#include "world/parts.h"

/* ---- what world_nearest() leaves open ---- */

static pov_two along(double o, double o_lo, pov_two t, double d)
{
    return pov_two_add(pov_two_add_double(pov_two_of(o, 0.0), o_lo), pov_two_mul_double(t, d));
}

void world_surface(const world *w, const pov_ray *ray, hit *h)
{
    const object *o = &w->model->objects.items[h->object];
    const shape_place place = world_place(w, h->object);
    pov_two t = pov_fast_two_sum(h->crossing.t, h->crossing.t_lo);
    pov_two3 p;

    p.x = along(ray->org.x, ray->org_lo.x, t, ray->dir.x);
    p.y = along(ray->org.y, ray->org_lo.y, t, ray->dir.y);
    p.z = along(ray->org.z, ray->org_lo.z, t, ray->dir.z);
    h->point = pov_two3_hi(p);
    h->point_lo = pov_two3_lo(p);
    if (place.placement)
        placement_normal(place.placement, o->shape, place.instance, ray, &h->crossing, &h->normal);
    else
        o->shape->normal(place.instance, ray, &h->crossing, &h->normal);
    if (o->flags & OBJECT_INVERSE)
        h->normal = pov_scale(h->normal, -1.0);
    h->entering = pov_dot(h->normal, ray->dir) < 0.0;
}

/* ---- media ---- */

static bool is_within(const pov_box *b, pov_vec3 p)
{
    return p.x >= b->lo.x && p.x <= b->hi.x && p.y >= b->lo.y && p.y <= b->hi.y && p.z >= b->lo.z && p.z <= b->hi.z;
}

static bool is_inside(const world *w, const medium *m, pov_vec3 point, pov_vec3 point_lo)
{
    const object *o = &w->model->objects.items[m->object];
    const shape_place place = world_place(w, m->object);
    bool inside;

    if (m->boxed && !is_within(&m->box, point))
        return false;
    if (place.placement)
        inside = placement_inside(place.placement, o->shape, place.instance, point, point_lo);
    else
        inside = o->shape->inside(place.instance, point, point_lo);
    return inside != ((o->flags & OBJECT_INVERSE) != 0);
}

void world_media_at(const world *w, pov_vec3 point, pov_vec3 point_lo, void (*see)(void *user, uint32_t object),
                    void *user)
{
    size_t i;

    for (i = 0; i < w->media_count; i++)
        if (is_inside(w, &w->media[i], point, point_lo))
            see(user, w->media[i].object);
}
