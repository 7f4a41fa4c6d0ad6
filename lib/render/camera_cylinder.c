/* Pictures on a cylinder: upright (1, 3) or lying (2, 4); along its axis rays spread from one point (1, 2), or start side
 * by side (3, 4). */
#include "base/elementary.h"
#include "render/camera_wide.h"

static bool upright(const camera_basis *b, double u, double v, pov_vec3 *dir, pov_vec3 *start)
{
    const double across = u * b->camera->angles[0];

    (void)start;
    *dir = camera_combine(b, elementary_sin(across), v * b->height, elementary_cos(across));
    return true;
}

static bool lying(const camera_basis *b, double u, double v, pov_vec3 *dir, pov_vec3 *start)
{
    const double upwards = v * b->camera->angles[0];

    (void)start;
    *dir = camera_combine(b, u * b->width, elementary_sin(upwards), elementary_cos(upwards));
    return true;
}

static bool upright_beside(const camera_basis *b, double u, double v, pov_vec3 *dir, pov_vec3 *start)
{
    *start = pov_scale(b->camera->up, v);
    return upright(b, u, 0.0, dir, start);
}

static bool lying_beside(const camera_basis *b, double u, double v, pov_vec3 *dir, pov_vec3 *start)
{
    *start = pov_scale(b->camera->right, u);
    return lying(b, 0.0, v, dir, start);
}

static unsigned aim(const pov_camera *camera, const raygen_screen *through, uint32_t n, pov_ray *rays)
{
    static camera_ray *const kinds[4] = { upright, lying, upright_beside, lying_beside };

    return camera_aim_each(kinds[camera->type - POV_CAMERA_CYLINDER_1], camera, through, n, rays);
}

static void look_up(const pov_camera *c, double u, double v, double *x, double *y)
{
    const bool upright_one = c->type == POV_CAMERA_CYLINDER_1 || c->type == POV_CAMERA_CYLINDER_3;

    *x = u * (upright_one ? c->angles[0] : camera_length(c->right));
    *y = v * (upright_one ? camera_length(c->up) : c->angles[0]);
}

const camera_class camera_cylinder = { aim, look_up };
