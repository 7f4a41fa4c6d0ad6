/* What stands around the extension of docs/plugins.md: a class whose intersect_many() is the plain loop. */
#include <povtrace/shape_fast.h>

#include <string.h>

static void intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const pov_mark mark = { 0, 0, 0.0, 0.0 };

    (void)self;
    (void)ray;
    pov_cross(hits, 1.0, 0.0, mark);
}

static void intersect_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++)
        intersect(selves[i], rays[i], hits[i]);
}

#include "block.c"

int main(void)
{
    const pov_shape_fast *known = extension(POV_SHAPE_FAST);

    return !(known && known->intersect_many && known->size == sizeof *known) || extension("something else");
}
