/* Cameras that see more than half of what is around them: ultra_wide_angle, panoramic, spherical. */
#include "render/camera_wide.h"

#include "base/elementary.h"
#include "shade/tracer.h"

static double unit_of(pov_vec3 v, pov_vec3 *unit)
{
    *unit = pov_unit(v);
    return pov_dot(v, *unit);
}

unsigned camera_aim_each(camera_ray *find, const pov_camera *camera, const raygen_screen *through, uint32_t n, pov_ray *rays)
{
    camera_basis b = { .camera = camera };

    b.width = unit_of(camera->right, &b.right);
    b.height = unit_of(camera->up, &b.up);
    b.depth = unit_of(camera->direction, &b.view);
    for (uint32_t i = 0; i < n; i++) {
        pov_vec3 start = pov_vec3_of(0.0, 0.0, 0.0);

        if (!find(&b, through->u[i], through->v[i], &rays[i].dir, &start))
            rays[i].dir = pov_vec3_of(HUGE_VAL, HUGE_VAL, HUGE_VAL);
        rays[i].org = pov_add(camera->location, start);
    }
    return 0;
}

static void on_sphere(const camera_basis *b, double across, double upwards, pov_vec3 *dir)
{
    const double level = elementary_cos(upwards);

    *dir = camera_combine(b, elementary_sin(across) * level, elementary_sin(upwards), elementary_cos(across) * level);
}

/* ---- the kinds ---- */

static bool ultra_wide(const camera_basis *b, double u, double v, pov_vec3 *dir, pov_vec3 *start)
{
    const double across = u * b->camera->angles[0], upwards = v * b->camera->angles[0] * b->height / b->width;

    (void)start;
    *dir = camera_combine(b, elementary_sin(across), elementary_sin(upwards), elementary_cos(across) * elementary_cos(upwards));
    return true;
}

static bool panoramic(const camera_basis *b, double u, double v, pov_vec3 *dir, pov_vec3 *start)
{
    const double pi = 3.14159265358979323846, level = elementary_cos(v * pi);

    (void)start;
    *dir = camera_combine(b, b->width * elementary_sin(u * pi) * level, b->height * elementary_sin(v * pi),
                          b->depth * elementary_cos(u * pi) * level);
    return true;
}

static bool spherical(const camera_basis *b, double u, double v, pov_vec3 *dir, pov_vec3 *start)
{
    (void)start;
    on_sphere(b, u * b->camera->angles[0], v * b->camera->angles[1], dir);
    return true;
}

static unsigned aim_ultra_wide(const pov_camera *camera, const raygen_screen *through, uint32_t n, pov_ray *rays)
{
    return camera_aim_each(ultra_wide, camera, through, n, rays);
}

static unsigned aim_panoramic(const pov_camera *camera, const raygen_screen *through, uint32_t n, pov_ray *rays)
{
    return camera_aim_each(panoramic, camera, through, n, rays);
}

static unsigned aim_spherical(const pov_camera *camera, const raygen_screen *through, uint32_t n, pov_ray *rays)
{
    return camera_aim_each(spherical, camera, through, n, rays);
}

const camera_class camera_ultra_wide = { aim_ultra_wide };
const camera_class camera_panoramic = { aim_panoramic };
const camera_class camera_spherical = { aim_spherical };
