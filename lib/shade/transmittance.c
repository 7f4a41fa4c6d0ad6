#include "shade/transmittance.h"

#include "base/bits.h"

/* Where on its way light crosses a constant filter does not matter to what is left of it. The product is rounded once, and
 * its order is that of the objects: it is the same for the tree and the list. False: nothing is left. */
static bool multiply(const shading *scene, const pov_crossing *at, uint32_t count, colour *through)
{
    double r = (double)through->r, g = (double)through->g, b = (double)through->b;

    for (uint32_t i = 0; i < count; i++) {
        const colour filter = shading_constant(scene, at[i].owner)->filter.by;

        r *= (double)filter.r;
        g *= (double)filter.g;
        b *= (double)filter.b;
    }
    *through = colour_of((float)r, (float)g, (float)b);
    return !colour_is_black(*through);
}

uint64_t transmittance_find(const shade_context *c, const pov_ray *const *rays, uint32_t n, double tmax,
                            colour *through)
{
    occlusion found;
    uint64_t lit = query_occlusion(c->scene->world, c->walker, rays, n, tmax, &found), rest;

    for (uint32_t i = 0; i < n; i++)
        through[i] = colour_of(1.0f, 1.0f, 1.0f);
    for (rest = found.crossed; rest; rest &= rest - 1) {
        const uint32_t i = first_of64(rest);

        if (!multiply(c->scene, found.at[i], found.count[i], &through[i]))
            lit &= ~((uint64_t)1 << i);
    }
    return lit;
}

bool transmittance_from(const shade_context *c, const spot *from, const pov_ray *ray, double tmax, colour *through)
{
    occlusion found;
    uint32_t crossed;

    *through = colour_of(1.0f, 1.0f, 1.0f);
    if (!query_occlusion_from(c->scene->world, c->walker, from, ray, tmax, &found, &crossed))
        return false;
    for (; crossed; crossed &= crossed - 1)
        *through = colour_mul(*through, shading_constant(c->scene, from->at[first_of(crossed)].object)->filter.by);
    return !colour_is_black(*through) &&
           (!found.crossed || multiply(c->scene, found.at[0], found.count[0], through));
}
