/* Segments that nothing at all is on. */
#include "query/packet.h"

/* Do all rays start on a convex shape or inside? It holds the box around them if it holds the box's corners. */
static bool start_inside(const shape_class *shape, const void *self, uint32_t object, const pov_ray *const *rays, uint32_t n)
{
    const pov_vec3 none = { 0.0, 0.0, 0.0 };
    pov_vec3 lo = { HUGE_VAL, HUGE_VAL, HUGE_VAL }, hi = { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL };

    for (uint32_t i = 0; i < n; i++) {
        const pov_vec3 p = rays[i]->org;

        if (rays[i]->origin_surface == object)
            continue;
        lo = pov_vec3_of(p.x < lo.x ? p.x : lo.x, p.y < lo.y ? p.y : lo.y, p.z < lo.z ? p.z : lo.z);
        hi = pov_vec3_of(p.x > hi.x ? p.x : hi.x, p.y > hi.y ? p.y : hi.y, p.z > hi.z ? p.z : hi.z);
    }
    for (int i = 0; lo.x <= hi.x && i < 8; i++)
        if (!shape->inside(self, pov_vec3_of(i & 1 ? hi.x : lo.x, i & 2 ? hi.y : lo.y, i & 4 ? hi.z : lo.z), none))
            return false;
    return true;
}

/* Do segments that end on a convex solid cross it nowhere else? From outside they do not, and from inside if they start there. */
static bool crosses_end_once(const world *w, const pov_ray *const *rays, uint32_t n, departure end)
{
    const shape_class *shape;
    shape_ref ref;

    if (end.object >= w->own_names || !w->objects_info[end.object].plain)
        return false;
    shape = w->groups[w->objects_info[end.object].group].shape;
    if (!(shape->flags & POV_SHAPE_CONVEX))
        return false;
    if (end.outward)
        return true;
    ref = world_shape(w, end.object);
    return !ref.xform && shape->inside && start_inside(shape, ref.instance, end.object, rays, n);
}

uint64_t query_visible(const world *w, query_context *k, const pov_ray *const *rays, uint32_t n, double tmax, departure end)
{
    const uint32_t once = crosses_end_once(w, rays, n, end) ? end.object : POV_NO_OWNER;
    bvh_group groups[BVH_GROUPS];
    occlusion out = { .near_end = 0 };
    const uint32_t count = packet_divide(w, rays, n, all_of(n), false, groups);
    uint64_t dark = 0;
    packet p;

    for (uint32_t i = 0; i < count; i++) {
        packet_begin(&p, w, k, rays, groups[i].lanes, tmax, tmax);
        p.any_blocks = p.whole = true;
        p.end = once;
        dark |= packet_end_light(&p, packet_occlusion(&p, groups[i].traverse), &out);
    }
    return all_of(n) & ~dark;
}
