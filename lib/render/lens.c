#include "render/lens.h"

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

    for (uint32_t i = 0; i < n; i++)
        spread(camera, right, up, view, through->lens[0][i], through->lens[1][i], &rays[i]);
}
