#include "query/start.h"

#include "query/own_space.h"

/* What double-double cannot tell from the surface lies on it: some hundred times its error, in sizes of the shape and of
 * its distance from the origin of its space. */
static const double same_point = 0x1p-92;
/* The same for shapes that are decided in double. */
static const double same_point_in_double = 0x1p-44;
/* Smallest cosines between ray and surface that are told from zero. */
static const double least_cosine = 0x1p-54, least_cosine_in_double = 0x1p-20;

/* In double alone, an exact zero is one already; but not where the ray was taken into the shape's space, which rounds. beyond:
 * how far from the start the next crossing has to be. */
static bool is_here(const world *w, const pov_ray *ray, hit *h, double *beyond)
{
    bool certified;
    double reach, cosine;
    own_space own;

    own_space_of(w, h->object, ray, &own);
    certified = own.shape->flags & POV_SHAPE_CERTIFIED;
    if (own.member || (certified && !own.moved && !(h->crossing.mark.flags & POV_MARK_ESCALATED)))
        return false;
    reach = (certified ? same_point : same_point_in_double) * own.size;
    world_surface(w, ray, h);
    cosine = pov_max(fabs(pov_dot(h->normal, pov_unit(ray->dir))), certified ? least_cosine : least_cosine_in_double);
    *beyond = certified ? h->crossing.t : reach / (own.speed * cosine);
    return h->crossing.t * own.speed * cosine <= reach;
}

/* The ray is on the side of the surface that it goes to. */
static void name(coincident_set *from, const pov_ray *ray, const hit *h)
{
    uint32_t i = 0;

    while (i < from->count && from->at[i].object != h->object)
        i++;
    if (i == COINCIDENT_MAX)
        return;
    from->count += i == from->count;
    from->at[i] = *h;
    from->above = (from->above & ~(1u << i)) | (uint32_t)(pov_dot(h->normal, ray->dir) >= 0.0) << i;
}

bool start_leave(const world *w, query_context *k, const pov_ray *ray, double tmax, coincident_set *from, hit *h)
{
    double beyond;

    from->count = from->above = from->solid = 0;
    for (int i = 0; i < COINCIDENT_MAX && is_here(w, ray, h, &beyond); i++) {
        name(from, ray, h);
        if (!query_nearest_beyond(w, k, from, ray, beyond, tmax, h))
            return false;
    }
    return true;
}

bool start_find(const world *w, query_context *k, const pov_ray *ray, double tmax, coincident_set *from)
{
    hit h;

    from->count = 0;
    if (!query_nearest_beyond(w, k, NULL, ray, 0.0, tmax, &h))
        return false;
    if (start_may_be_here(w, ray, h.crossing.t))
        start_leave(w, k, ray, tmax, from, &h);
    return true;
}
