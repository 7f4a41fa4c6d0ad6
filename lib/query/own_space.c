#include "query/own_space.h"

void own_space_of(const world *w, uint32_t owner, const pov_ray *ray, own_space *out)
{
    const object_info *info;
    copy_path at;
    shape_ref ref;
    pov_ray moved;
    pov_box box;

    world_find(w, owner, &at);
    info = &at.world->objects_info[at.index];
    ref = world_shape(at.world, at.index);
    out->shape = at.world->groups[info->group].shape;
    out->instance = ref.instance;
    out->moved = copy_path_moves(&at) || ref.xform;
    out->member = info->member;
    out->ray = *copy_path_ray(&at, ray, &moved);
    if (ref.xform) {
        moved = out->ray;
        instance_ray(ref.xform, &moved, &out->ray);
    }
    out->speed = pov_largest(out->ray.dir);
    out->size = pov_largest(out->ray.org);
    if (out->shape->bounds(ref.instance, &box))
        out->size += pov_max(pov_largest(box.lo), pov_largest(box.hi));
}

double own_space_cosine(const own_space *s, const pov_crossing *at)
{
    pov_vec3 normal;

    s->shape->normal(s->instance, &s->ray, at, &normal);
    return fabs(pov_dot(pov_unit(normal), pov_unit(s->ray.dir)));
}
