#include "shade/transmittance.h"

#include "base/simd.h"
#include "shade/crossings.h"
#include "shade/haze.h"
#include "shade/paint.h"
#include "shade/photons.h"

#include <povtrace/exact.h>

/* Filter of a surface at a known point. */
static colour filter_of(const shading *scene, const pov_ray *ray, const hit *h)
{
    const appearance *a = shading_constant(scene, h->object);
    const light_crossings at = { &ray, &h, 1 };
    colour by = a->onward.filter.by;

    if (a->varies)
        paint_filters(scene, &at, &by);
    return by;
}

/* The product is rounded once. False: nothing is left. */
static inline bool is_left(light_product p, colour *through)
{
    *through = colour_of((float)p.r, (float)p.g, (float)p.b);
    return !colour_is_black(*through);
}

static inline light_product product_of(colour c)
{
    const light_product p = { (double)c.r, (double)c.g, (double)c.b };

    return p;
}

/* False: nothing is left. */
static inline bool multiply(const shading *scene, const pov_crossing *at, uint32_t count, colour *through)
{
    light_product p = product_of(*through);

    for (uint32_t i = 0; i < count; i++)
        light_take(&p, shading_constant(scene, at[i].owner)->onward.filter.by);
    return is_left(p, through);
}

/* What solids leave of light. Their order along the way matters. */
static void dim_by_solids(const shading *scene, interior_walk *around, const pov_ray *const *rays, const occlusion *found, uint64_t which,
                          light_product *left)
{
    light_product by[BATCH_MAX];

    for (uint64_t rest = which; rest; rest &= rest - 1)
        by[first_of64(rest)] = product_of(colour_of(1.0f, 1.0f, 1.0f));
    crossings_fade(scene, around, rays, found, which, by);
    if (scene->plan->media)
        haze_dim(scene, around, rays, found, which, by);
    for (; which; which &= which - 1) {
        const uint32_t i = first_of64(which);

        left[i].r *= by[i].r;
        left[i].g *= by[i].g;
        left[i].b *= by[i].b;
    }
}

/* Light that crosses surfaces, by ray (bits). Returns those of which something is left. around: where solids count. */
static uint64_t cross(const shading *scene, interior_walk *around, const pov_ray *const *rays, const occlusion *found, uint64_t which,
                      colour *through)
{
    light_product left[BATCH_MAX];
    uint64_t lit = 0;

    for (uint64_t rest = which; rest; rest &= rest - 1)
        left[first_of64(rest)] = product_of(through[first_of64(rest)]);
    crossings_filter(scene, rays, found, which, left);
    if (scene->plan->located)
        dim_by_solids(scene, around, rays, found, which, left);
    for (; which; which &= which - 1) {
        const uint32_t i = first_of64(which);

        lit |= (uint64_t)is_left(left[i], &through[i]) << i;
    }
    return lit;
}

/* The ray with its direction to the segments' end in double-double. */
static pov_ray aim_exactly(const pov_ray *ray, segment_end end)
{
    const pov_two3 org = pov_two3_of(ray->org, ray->org_lo);
    pov_ray exact = *ray;
    pov_two3 at, dir;

    if (!end.at)
        return exact;
    at = pov_two3_of(end.at->from, end.at->from_lo);
    dir.x = pov_two_sub(at.x, org.x);
    dir.y = pov_two_sub(at.y, org.y);
    dir.z = pov_two_sub(at.z, org.z);
    exact.dir = pov_two3_hi(dir);
    exact.dir_lo = pov_two3_lo(dir);
    return exact;
}

/* Decide for rays that cross something near their end. */
static uint64_t find_exactly(const shade_context *c, const pov_ray *const *rays, segment_end end, uint64_t lit,
                             occlusion *found)
{
    for (uint64_t rest = found->near_end; rest; rest &= rest - 1) {
        const uint32_t i = first_of64(rest);
        const pov_ray exact = aim_exactly(rays[i], segment_end_of(end, i));

        if (!query_occlusion_exact(c->scene->world, c->context, &exact, i, end.tmax, found))
            lit &= ~((uint64_t)1 << i);
    }
    return lit;
}

/* Constant filters, whose places do not matter: bit i: something of ray i's light is left. */
static uint64_t filter_plainly(const shading *scene, const occlusion *found, uint64_t lit, colour *through)
{
    for (uint64_t rest = found->crossed; rest; rest &= rest - 1) {
        const uint32_t i = first_of64(rest);

        if (!multiply(scene, found->at[i], found->count[i], &through[i]))
            lit &= ~((uint64_t)1 << i);
    }
    return lit;
}

/* What the crossings of lit rays leave of their light. */
static uint64_t filter_found(const shade_context *c, const pov_ray *const *rays, const path *const *from, uint32_t n, uint64_t lit,
                             const occlusion *found, colour *through)
{
    interior_walk around[BATCH_MAX];
    uint64_t blocked = 0;

    for (uint32_t i = 0; i < n; i++)
        through[i] = colour_of(1.0f, 1.0f, 1.0f);
    if (!c->scene->plan->located && !c->scene->plan->textures && !c->blocks)
        return filter_plainly(c->scene, found, lit, through);
    for (uint64_t rest = found->crossed; rest; rest &= rest - 1) {
        const uint32_t i = first_of64(rest);

        if (c->scene->plan->located)
            walk_begin(c, from[i], &around[i]);
        if (c->blocks && photons_block(c, rays[i], found->at[i], found->count[i]))
            blocked |= (uint64_t)1 << i;
    }
    return (lit & ~found->crossed) | (lit & cross(c->scene, around, rays, found, found->crossed & ~blocked, through));
}

uint64_t transmittance_find(const shade_context *c, const pov_ray *const *rays, const path *const *from, uint32_t n,
                            segment_end end, colour *through)
{
    occlusion found;
    uint64_t lit = query_occlusion(c->scene->world, c->context, rays, n, end.tmax, &found);

    if (found.near_end)
        lit = find_exactly(c, rays, end, lit, &found);
    return filter_found(c, rays, from, n, lit, &found, through);
}

uint64_t transmittance_find_lanes(const shade_context *c, const lane_rays *rays, const path *const *from, uint32_t n, segment_end end,
                                  colour *through, bool *filtered)
{
    occlusion found;
    uint64_t lit = query_occlusion_lanes(c->scene->world, c->context, rays, n, end.tmax, &found);

    if (found.near_end)
        lit = find_exactly(c, rays->make(rays->user), end, lit, &found);
    *filtered = found.crossed != 0;
    return *filtered ? filter_found(c, rays->make(rays->user), from, n, lit, &found, through) : lit;
}

bool transmittance_from(const shade_context *c, const coincident_set *on, const pov_ray *ray, const path *from,
                        segment_end end, colour *through)
{
    const pov_ray exact = aim_exactly(ray, end), *const rays = &exact;
    const bool walks = c->scene->plan->located;
    interior_walk w;
    occlusion found;
    uint32_t crossed;

    *through = colour_of(1.0f, 1.0f, 1.0f);
    if (!query_occlusion_from(c->scene->world, c->context, on, &exact, end.tmax, &found, &crossed))
        return false;
    if (walks)
        walk_begin(c, from, &w);
    for (; crossed; crossed &= crossed - 1) {
        const uint32_t k = first_of(crossed);

        *through = colour_mul(*through, filter_of(c->scene, ray, &on->at[k]));
        if (walks)
            walk_cross(c->scene, &w, on->at[k].object, !(on->above >> k & 1));
    }
    if (c->blocks && found.crossed && photons_block(c, ray, found.at[0], found.count[0]))
        return false;
    return !colour_is_black(*through) &&
           (!found.crossed || cross(c->scene, &w, &rays, &found, 1, through) != 0);
}

/* What a light is projected through may be an object that is seen there as well. What lies this fraction of the segment's
 * length from the start lies at the start, and a ray ends as little before what it crosses. */
static const double at_hole = 0x1p-40;

bool transmittance_shorten(const shade_context *c, const light *from, double tmax, pov_ray *ray)
{
    double t;

    if (!query_crossing_of(c->scene->world, c->context, ray, from->through, from->through_count, at_hole * tmax, tmax, &t))
        return false;
    ray->dir = pov_scale(ray->dir, t / tmax * (1.0 - at_hole));
    return true;
}
