#include "world/detail.h"

#include "world/copy_path.h"

/* A hit's shape, and its point in the space of the instance. */
typedef struct part { const shape_class *shape; shape_ref ref; pov_vec3 point, point_lo; copy_path at; } part;

static part find_part(const world *w, const hit *h)
{
    part p = { .point = h->point, .point_lo = h->point_lo };

    world_find(w, h->object, &p.at);
    p.shape = p.at.world->groups[p.at.world->objects_info[p.at.index].group].shape;
    p.ref = world_shape(p.at.world, p.at.index);
    copy_path_point(&p.at, &p.point, &p.point_lo);
    if (p.ref.xform) {
        const pov_two3 own = instance_point(p.ref.xform, p.point, p.point_lo);

        p.point = pov_two3_hi(own);
        p.point_lo = pov_two3_lo(own);
    }
    return p;
}

bool world_blended_normal(const world *w, const hit *h, pov_vec3 *out)
{
    const part p = find_part(w, h);
    pov_vec3 normal[POV_NORMALS_MAX], sum = { 0.0, 0.0, 0.0 };
    double share[POV_NORMALS_MAX];
    uint32_t count, i;

    if (!p.shape->shading_normals)
        return false;
    count = p.shape->shading_normals(p.ref.instance, p.point, p.point_lo, &h->crossing.mark, normal, share);
    if (p.ref.xform && count > 0)
        instance_rotate_normals(p.ref.xform, normal, count);
    for (i = 0; i < count; i++) {
        copy_path_normal(&p.at, &normal[i]);
        sum = pov_add(sum, pov_scale(normal[i], share[i]));
    }
    if (!(pov_largest(sum) > 0.0))
        return false;
    *out = pov_unit(sum);
    return true;
}

bool world_shading_normal(const world *w, const pov_ray *ray, const hit *h, pov_vec3 *out)
{
    if (!world_blended_normal(w, h, out))
        return false;
    if (pov_dot(*out, ray->dir) > 0.0)
        *out = pov_scale(*out, -1.0);
    return true;
}

void world_uv(const world *w, const hit *h, double out[2])
{
    const part p = find_part(w, h);

    out[0] = h->point.x;
    out[1] = h->point.y;
    if (p.shape->uv)
        p.shape->uv(p.ref.instance, p.point, &h->crossing.mark, out);
}

static bool holds(const world *w, uint32_t leaf, const hit *h)
{
    const leaf_node *o = &w->model->leaves.items[leaf];
    const shape_ref ref = world_shape(w, leaf);
    bool inside;

    if (!shape_is_solid(o->shape, o->instance))
        return false;
    inside = ref.xform ? instance_inside(ref.xform, o->shape, ref.instance, h->point, h->point_lo)
                       : o->shape->inside(ref.instance, h->point, h->point_lo);
    return inside != ((o->flags & LEAF_INVERSE) != 0);
}

/* The first of the members that hold the point give equal shares. */
static uint32_t find_givers(const world *w, const hit *h, uint32_t *which, double *share)
{
    const cutaway *c;
    uint32_t count = 0, i;
    copy_path p;
    hit own = *h;

    world_find(w, h->object, &p);
    copy_path_point(&p, &own.point, &own.point_lo);
    c = model_cutaway(p.world->model, p.index);
    for (i = 0; c && i < c->giver_count && count < POV_TEXTURES_MAX; i++)
        if (holds(p.world, p.world->model->givers.items[c->giver + i], &own))
            which[count++] = i;
    for (i = 0; i < count; i++)
        share[i] = 1.0 / count;
    return count;
}

uint32_t world_part_textures(const world *w, const hit *h, uint32_t *which, double *share)
{
    const part p = find_part(w, h);

    if (model_leaf(w->model, h->object)->flags & LEAF_CUTAWAY)
        return find_givers(w, h, which, share);
    if (!p.shape->textures)
        return 0;
    return p.shape->textures(p.ref.instance, p.point, p.point_lo, &h->crossing.mark, which, share);
}
