#include "shade/geometry.h"

#include "base/simd.h"

void geometry_begin(geometry *g)
{
    for (uint32_t i = 0; i < BATCH_MAX; i++)
        g->to.way.x[i] = g->to.normal.x[i] = 1.0;
}

/* Points and normals of what was met; of what lies on others they are known. */
static void complete(pov_tracer *t, uint32_t n)
{
    const pov_ray *rays[BATCH_MAX];
    hit *hits[BATCH_MAX];
    uint32_t count = 0, i;

    for (i = 0; i < n; i++) {
        if (t->surfaces[i].spot)
            continue;
        rays[count] = t->rays[i];
        hits[count++] = t->met[i];
    }
    if (count > 0)
        world_surface_many(t->world, NULL, rays, hits, count, &t->geometry.to);
    for (i = 0; i < n; i++)
        world_approach(&t->geometry.to, i, t->rays[i], t->met[i]);
}

/* What the surface's side and the unit direction make of lane i. */
static inline void turn(geometry *g, uint32_t i, pov_vec3 view)
{
    const pov_vec3 normal = lanes_at(&g->to.normal, i);
    double cosine = -pov_dot(normal, view);

    cosine = cosine > 0.0 ? cosine : 0.0;
    lanes_put(&g->view, i, view);
    lanes_put(&g->mirrored, i, pov_add(view, pov_scale(normal, 2.0 * cosine)));
    g->cosine[i] = cosine;
}

/* False: some direction is so short or long that its square is none. */
SIMD_CLONES static bool turn_plain(geometry *g, uint32_t n)
{
    int64_t plain = -1;

    for (uint32_t i = 0; i < n; i++) {
        pov_vec3 view;

        plain &= geometry_unit(g->to.way.x[i], g->to.way.y[i], g->to.way.z[i], &view);
        turn(g, i, view);
    }
    return plain != 0;
}

void geometry_find(pov_tracer *t, uint32_t n)
{
    geometry *g = &t->geometry;

    if (t->spots.count > 0)
        complete(t, n);
    else
        world_surface_many(t->world, walker_own(t->walker), t->rays, t->met, n, &g->to);
    if (!turn_plain(g, lanes_whole(n)))
        for (uint32_t i = 0; i < n; i++)
            turn(g, i, pov_unit(lanes_at(&g->to.way, i)));
}
