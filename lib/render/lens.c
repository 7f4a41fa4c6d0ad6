#include "render/lens.h"

#include "base/elementary.h"
#include "base/mix.h"

static uint64_t mix(double u, double v)
{
    return mix_bits(elementary_bits(u) * 0x9E3779B97F4A7C15u ^ elementary_bits(v));
}

/* A point of the unit disc, all alike. */
static void disc_point(uint64_t bits, double *x, double *y)
{
    const double radius = sqrt((double)(bits >> 32) * 0x1p-32), turn = (double)(bits & 0xffffffffu) * 0x1p-32;

    *x = radius * elementary_cos_turns(turn);
    *y = radius * elementary_sin_turns(turn);
}

static void spread(const pov_camera *c, pov_vec3 right, pov_vec3 up, pov_vec3 view, uint64_t bits, pov_ray *ray)
{
    const double along = pov_dot(ray->dir, view);
    double x, y;
    pov_vec3 aside, far;

    if (!(along > 0.0 && along < HUGE_VAL))
        return;
    disc_point(bits, &x, &y);
    aside = pov_scale(pov_add(pov_scale(right, x), pov_scale(up, y)), c->lens_radius);
    far = pov_scale(ray->dir, c->focal_distance / along);
    ray->org = pov_add(ray->org, aside);
    ray->dir = pov_sub(far, aside);
}

void lens_spread(const pov_camera *camera, const raygen_screen *through, uint32_t n, pov_ray *rays)
{
    const pov_vec3 right = pov_unit(camera->right), up = pov_unit(camera->up), view = pov_unit(camera->direction);

    for (uint32_t i = 0; i < n; i++)
        spread(camera, right, up, view, mix(through->u[i], through->v[i]), &rays[i]);
}
