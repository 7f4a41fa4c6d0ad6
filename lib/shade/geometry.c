#include "shade/geometry.h"

#include "base/simd.h"

void geometry_begin(geometry *g)
{
    for (uint32_t i = 0; i < BATCH_MAX; i++)
        g->way.x[i] = g->normal.x[i] = 1.0;
}

/* Points and normals of what was met. */
static void complete(pov_tracer *t, uint32_t n)
{
    const pov_ray *rays[BATCH_MAX];
    hit *hits[BATCH_MAX];
    uint32_t count = 0;

    for (uint32_t i = 0; i < n; i++) {
        const surface *s = &t->surfaces[i];

        if (s->spot)
            continue;
        rays[count] = s->ray;
        hits[count++] = s->at;
    }
    if (count > 0)
        world_surface_many(t->world, rays, hits, count);
}

static inline void put(lanes *l, uint32_t i, pov_vec3 v)
{
    l->x[i] = v.x;
    l->y[i] = v.y;
    l->z[i] = v.z;
}

/* What the surface's side and the unit direction make of lane i. */
static inline void turn(geometry *g, uint32_t i, pov_vec3 view)
{
    const pov_vec3 normal = lanes_at(&g->normal, i);
    double cosine = -pov_dot(normal, view);

    cosine = cosine > 0.0 ? cosine : 0.0;
    put(&g->view, i, view);
    put(&g->mirrored, i, pov_add(view, pov_scale(normal, 2.0 * cosine)));
    g->cosine[i] = cosine;
}

/* False: some direction is so short or long that its square is none. */
SIMD_CLONES static bool turn_plain(geometry *g, uint32_t n)
{
    int plain = 1;

    for (uint32_t i = 0; i < n; i++) {
        pov_vec3 view;

        plain &= geometry_unit(g->way.x[i], g->way.y[i], g->way.z[i], &view);
        turn(g, i, view);
    }
    return plain;
}

void geometry_find(pov_tracer *t, uint32_t n)
{
    geometry *g = &t->geometry;

    complete(t, n);
    for (uint32_t i = 0; i < n; i++) {
        const surface *s = &t->surfaces[i];
        const double side = s->at->entering ? 1.0 : -1.0;

        put(&g->way, i, s->ray->dir);
        put(&g->point, i, s->at->point);
        put(&g->point_lo, i, s->at->point_lo);
        put(&g->normal, i, pov_scale(s->at->normal, side));
    }
    if (!turn_plain(g, lanes_whole(n)))
        for (uint32_t i = 0; i < n; i++)
            turn(g, i, pov_unit(lanes_at(&g->way, i)));
}
