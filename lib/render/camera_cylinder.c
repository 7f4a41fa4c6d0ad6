/* Pictures on a cylinder: upright (1, 3) or lying (2, 4); along its axis rays spread from one point (1, 2), or start side
 * by side (3, 4). */
#include "base/elementary.h"
#include "base/simd.h"
#include "render/camera_wide.h"

static bool is_upright(const pov_camera *c) { return c->type == POV_CAMERA_CYLINDER_1 || c->type == POV_CAMERA_CYLINDER_3; }
static bool is_beside(const pov_camera *c) { return c->type == POV_CAMERA_CYLINDER_3 || c->type == POV_CAMERA_CYLINDER_4; }

/* Around the axis: sines and cosines side by side. */
SIMD_CLONES static void turn(const double *restrict at, double by, uint32_t n, double *restrict sine, double *restrict cosine)
{
    for (uint32_t i = 0; i < n; i++) {
        sine[i] = elementary_sin(at[i] * by);
        cosine[i] = elementary_cos(at[i] * by);
    }
}

static unsigned aim(const pov_camera *camera, const raygen_screen *through, uint32_t n, pov_ray *rays)
{
    const bool upright = is_upright(camera), beside = is_beside(camera);
    const double *along = upright ? through->v : through->u;
    const pov_vec3 axis = upright ? camera->up : camera->right, none = { 0.0, 0.0, 0.0 };
    const camera_basis b = camera_basis_of(camera);
    double sine[RAYGEN_MANY], cosine[RAYGEN_MANY];

    turn(upright ? through->u : through->v, camera->angles[0], n, sine, cosine);
    for (uint32_t i = 0; i < n; i++) {
        const double spread = (beside ? 0.0 : along[i]) * (upright ? b.height : b.width);

        rays[i].dir = upright ? camera_combine(&b, sine[i], spread, cosine[i]) : camera_combine(&b, spread, sine[i], cosine[i]);
        rays[i].org = pov_add(camera->location, beside ? pov_scale(axis, along[i]) : none);
    }
    return 0;
}

static void look_up(const pov_camera *c, double u, double v, double *x, double *y)
{
    *x = u * (is_upright(c) ? c->angles[0] : camera_length(c->right));
    *y = v * (is_upright(c) ? camera_length(c->up) : c->angles[0]);
}

const camera_class camera_cylinder = { aim, look_up };
