#include "shade/geometry.h"

void geometry_begin(geometry *g)
{
    for (uint32_t i = 0; i < WORLD_MANY; i++)
        g->to.way.x[i] = g->to.normal.x[i] = 1.0;
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

void geometry_turn(geometry *g, uint32_t n)
{
    if (!turn_plain(g, lanes_whole(n)))
        for (uint32_t i = 0; i < n; i++)
            turn(g, i, pov_unit(lanes_at(&g->to.way, i)));
}
