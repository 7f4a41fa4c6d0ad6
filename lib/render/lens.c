#include "render/lens.h"

#include "base/elementary.h"
#include "base/simd.h"

/* Points of the unit disc for those of the unit square, all alike. */
SIMD_CLONES static void find_disc_points(const double *restrict u, const double *restrict v, uint32_t n, double *restrict x, double *restrict y)
{
    for (uint32_t i = 0; i < n; i++) {
        const double radius = sqrt(u[i]);

        x[i] = radius * elementary_cos_turns(v[i]);
        y[i] = radius * elementary_sin_turns(v[i]);
    }
}

static void spread(const pov_camera *c, pov_vec3 right, pov_vec3 up, pov_vec3 view, double x, double y, pov_ray *ray)
{
    const double along = pov_dot(ray->dir, view);
    pov_vec3 aside, far;

    if (!(along > 0.0 && along < HUGE_VAL))
        return;
    aside = pov_scale(pov_add(pov_scale(right, x), pov_scale(up, y)), c->lens_radius);
    far = pov_scale(ray->dir, c->focal_distance / along);
    ray->org = pov_add(ray->org, aside);
    ray->dir = pov_sub(far, aside);
}

void lens_spread(const pov_camera *camera, const raygen_screen *through, uint32_t n, pov_ray *rays)
{
    const pov_vec3 right = pov_unit(camera->right), up = pov_unit(camera->up), view = pov_unit(camera->direction);
    double x[RAYGEN_MANY], y[RAYGEN_MANY];

    find_disc_points(through->lens[0], through->lens[1], n, x, y);
    for (uint32_t i = 0; i < n; i++)
        spread(camera, right, up, view, x[i], y[i], &rays[i]);
}
