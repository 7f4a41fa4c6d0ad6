#include "render/raygen.h"

#include "base/simd.h"

#include <float.h>

static inline pov_vec3 direction(const pov_camera *camera, double u, double v)
{
    return pov_add(camera->direction, pov_add(pov_scale(camera->right, u), pov_scale(camera->up, v)));
}

pov_ray raygen_ray(const pov_camera *camera, int width, int height, int x, int y, double dx, double dy)
{
    pov_ray ray = { .org = camera->location, .left = POV_NOBODY };

    ray.dir = direction(camera, raygen_u(x, dx, width), raygen_v(y, dy, height));
    return ray;
}

void raygen_begin(const pov_camera *camera, pov_ray *rays, uint32_t n)
{
    const pov_ray ray = { .org = camera->location, .left = POV_NOBODY };

    for (uint32_t i = 0; i < n; i++)
        rays[i] = ray;
}

SIMD_CLONES static void place(const raygen_places *restrict p, int width, int height, uint32_t n,
                              raygen_screen *restrict out)
{
    for (uint32_t i = 0; i < n; i++) {
        out->u[i] = raygen_u(p->x[i], p->dx[i], width);
        out->v[i] = raygen_v(p->y[i], p->dy[i], height);
    }
}

void raygen_place(const raygen_places *p, int width, int height, uint32_t n, raygen_screen *out)
{
    place(p, width, height, n, out);
}

/* By lane, so that the loop is vectorised. False: some direction may be zero or not a number. */
SIMD_CLONES static bool aim(const pov_camera *camera, const raygen_screen *restrict through, uint32_t n,
                            vec_lanes *restrict out)
{
    int sound = 1;

    for (uint32_t i = 0; i < n; i++) {
        pov_vec3 d = direction(camera, through->u[i], through->v[i]);
        const double size = fabs(d.x + d.y + d.z);

        lanes_put(out, i, d);
        sound &= (size > 0.0) & (size <= DBL_MAX);
    }
    return sound;
}

unsigned raygen_aim(const pov_camera *camera, const raygen_screen *through, uint32_t n, pov_ray *rays)
{
    const pov_vec3 from = camera->location;
    vec_lanes directions;
    const bool sound = aim(camera, through, n, &directions);

    for (uint32_t i = 0; i < n; i++)
        rays[i].dir = lanes_at(&directions, i);
    return TRACER_ONE_START | (sound && isfinite(from.x + from.y + from.z) ? TRACER_SOUND : 0);
}
