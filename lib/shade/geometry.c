#include "shade/geometry.h"

void geometry_begin(geometry *g)
{
    g->shading = g->raw = &g->to.normal;
    for (uint32_t i = 0; i < WORLD_MANY; i++)
        g->to.dir.x[i] = g->to.normal.x[i] = g->bent.x[i] = g->smooth.x[i] = 1.0;
}

/* Set view, reflected direction and cosine of lane i. Normals that no texture perturbed face the ray: less than 0 is rounding. */
static inline void set_lane(geometry *g, const vec_lanes *shading, bool clamped, uint32_t i, pov_vec3 view)
{
    const pov_vec3 normal = lanes_at(shading, i);
    double cosine = -pov_dot(normal, view);

    cosine = cosine > 0.0 || !clamped ? cosine : 0.0;
    lanes_put(&g->view, i, view);
    lanes_put(&g->reflected, i, pov_add(view, pov_scale(normal, 2.0 * cosine)));
    g->cosine[i] = cosine;
}

/* False: the squared length of some direction is out of range. */
static inline bool set_lanes(geometry *g, const vec_lanes *shading, bool clamped, uint32_t n)
{
    int64_t plain = -1;

    for (uint32_t i = 0; i < n; i++) {
        pov_vec3 view;

        plain &= geometry_unit(g->to.dir.x[i], g->to.dir.y[i], g->to.dir.z[i], &view);
        set_lane(g, shading, clamped, i, view);
    }
    return plain != 0;
}

SIMD_CLONES static bool set_plain(geometry *g, uint32_t n) { return set_lanes(g, &g->to.normal, true, n); }

SIMD_CLONES static bool set_bent(geometry *g, uint32_t n) { return set_lanes(g, g->shading, false, n); }

/* What the geometric normals say. Where a normal that a texture perturbed mirrors a ray into the surface, it is mirrored
 * once more, or, where that normal does not face the ray, the unperturbed one mirrors it. Smooth triangles let such a
 * ray through, as in POV-Ray. */
static void find_sides(geometry *g, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++) {
        const pov_vec3 normal = lanes_at(&g->to.normal, i), raw = lanes_at(g->raw, i);
        pov_vec3 mirrored = lanes_at(&g->reflected, i);

        if (pov_dot(mirrored, raw) < 0.0 && g->raw != g->shading) {
            const pov_vec3 into = g->cosine[i] < 0.0 ? lanes_at(&g->view, i) : mirrored;

            mirrored = pov_sub(into, pov_scale(raw, 2.0 * pov_dot(into, raw)));
        }
        lanes_put(&g->turned, i, mirrored);
        g->sides[0][i] = -pov_dot(lanes_at(&g->view, i), normal);
        g->sides[1][i] = pov_dot(mirrored, normal);
    }
}

void geometry_turn(geometry *g, uint32_t n)
{
    const bool bent = geometry_is_bent(g);

    if (!(bent ? set_bent(g, lanes_whole(n)) : set_plain(g, lanes_whole(n))))
        for (uint32_t i = 0; i < n; i++)
            set_lane(g, g->shading, !bent, i, pov_unit(lanes_at(&g->to.dir, i)));
    g->mirrored = bent ? &g->turned : &g->reflected;
    g->view_side = bent ? g->sides[0] : g->cosine;
    g->reflected_side = bent ? g->sides[1] : g->cosine;
    if (bent)
        find_sides(g, n);
}
