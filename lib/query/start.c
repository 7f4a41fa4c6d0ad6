#include "query/start.h"

#include "world/copy_path.h"

/* What double-double cannot tell from the surface lies on it: some hundred times its error, in sizes of the shape and of
 * its distance from the origin of its space. */
static const double same_point = 0x1p-92;
/* The same for shapes that are decided in double. */
static const double same_point_in_double = 0x1p-44;
/* Smallest cosines between ray and surface that are told from zero. */
static const double least_cosine = 0x1p-54, least_cosine_in_double = 0x1p-20;

/* The size of numbers that take part in an intersection in the space of the shape, and the ray's speed there. */
static double size_of(const copy_path *at, const pov_ray *ray, double *speed)
{
    const shape_class *shape = at->world->groups[at->world->objects_info[at->index].group].shape;
    const shape_ref ref = world_shape(at->world, at->index);
    pov_ray moved, own;
    pov_box box;
    double size;

    ray = copy_path_ray(at, ray, &moved);
    own = *ray;
    if (ref.xform)
        instance_ray(ref.xform, ray, &own);
    *speed = pov_largest(own.dir);
    size = pov_largest(own.org);
    if (shape->bounds(ref.instance, &box))
        size += fmax(pov_largest(box.lo), pov_largest(box.hi));
    return size;
}

/* In double alone, an exact zero is one already; but not where the ray was taken into the shape's space, which rounds. beyond:
 * how far from the start the next crossing has to be. */
static bool is_here(const world *w, const pov_ray *ray, hit *h, double *beyond)
{
    const object_info *info;
    copy_path at;
    double speed, reach, cosine;
    bool certified, rounds;

    world_find(w, h->object, &at);
    info = &at.world->objects_info[at.index];
    certified = at.world->groups[info->group].shape->flags & POV_SHAPE_CERTIFIED;
    rounds = copy_path_moves(&at) || world_shape(at.world, at.index).xform;
    if (info->member || (certified && !rounds && !(h->crossing.mark.flags & POV_MARK_ESCALATED)))
        return false;
    reach = (certified ? same_point : same_point_in_double) * size_of(&at, ray, &speed);
    world_surface(w, ray, h);
    cosine = fmax(fabs(pov_dot(h->normal, pov_unit(ray->dir))), certified ? least_cosine : least_cosine_in_double);
    *beyond = certified ? h->crossing.t : reach / (speed * cosine);
    return h->crossing.t * speed * cosine <= reach;
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
    return query_nearest_beyond(w, k, NULL, ray, 0.0, tmax, &h) && start_may_be_here(w, ray, h.crossing.t) &&
           (start_leave(w, k, ray, tmax, from, &h), from->count > 0);
}
