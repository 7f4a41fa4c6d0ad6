/* The nearest crossing of a ray with a few objects, by themselves. */
#include "query/context.h"

/* The nearer of the crossings found so far is the limit of the next. */
static void cross(const world *w, query_context *k, const pov_ray *ray, uint32_t which, double tmin, double *tmax)
{
    const shape_class *shape = w->groups[w->objects_info[which].group].shape;
    const shape_ref ref = world_shape(w, which);
    pov_crossing at;
    pov_hits hits;

    hits_begin(&hits, &k->hit_buffers[0], *tmax, POV_WANT_NEAREST, &at);
    hits.owner = which;
    hits.tmin = tmin;
    if (ref.xform)
        instance_intersect(ref.xform, shape, ref.instance, ray, &hits);
    else
        shape->intersect(ref.instance, ray, &hits);
    if (hits.count > 0)
        *tmax = at.t;
}

bool query_crossing_of(const world *w, query_context *k, const pov_ray *ray, uint32_t leaf, uint32_t leaf_count,
                       double tmin, double tmax, double *t)
{
    *t = tmax;
    for (uint32_t i = leaf; i < leaf + leaf_count; i++)
        if (!w->objects_info[i].member)
            cross(w, k, ray, i, tmin, t);
    for (uint32_t i = 0; i < w->trees.count; i++)
        if (w->trees.items[i].members[0].leaf - leaf < leaf_count)
            cross(w, k, ray, (uint32_t)w->model->leaves.count + i, tmin, t);
    return *t < tmax;
}
