#include "shade/camera_normal.h"

#include "texture/normal.h"

/* A ray outside of the camera's picture has no direction. */
static bool is_outside(const pov_ray *ray) { return !isfinite(ray->dir.x + ray->dir.y + ray->dir.z); }

static pov_vec3 unit_of(const pov_ray *ray) { return is_outside(ray) ? pov_vec3_of(0.0, 0.0, 1.0) : pov_unit(ray->dir); }

void camera_normal_apply(const model *m, const double *x, const double *y, uint32_t n, pov_ray *rays)
{
    const pov_vec3 zero = pov_vec3_of(0.0, 0.0, 0.0);
    texture_points points;
    vec_lanes bent;

    points.parts = NULL;
    points.has_world = false;
    points.has_surface = points.has_uv = points.has_view = points.in_world = true;
    for (uint32_t i = 0; i < n; i++) {
        texture_point(&points, i, pov_vec3_of(x[i], y[i], 0.0), zero);
        lanes_put(&bent, i, unit_of(&rays[i]));
        lanes_put(&points.normal, i, lanes_at(&bent, i));
        lanes_put(&points.view, i, lanes_at(&bent, i));
        lanes_put(&points.uv, i, zero);
    }
    normal_eval(m, m->camera_normal, NULL, &points, n, &bent);
    for (uint32_t i = 0; i < n; i++)
        if (!is_outside(&rays[i]))
            rays[i].dir = lanes_at(&bent, i);
}
